// All that can be done by keys. Letters, digits and signs do so only while one of the views has the focus: spoken words, or
// keys that are pressed by chance elsewhere, do nothing.
import { element } from './elements.js';

const turn = Math.PI / 24;
const part = 0.1; // of half of the sheet

export function listenToKeys({ app, viewer, panel, crosshair }) {
  const isOnSheet = () => document.activeElement === element('atlas-view');
  const isOnView = () => isOnSheet() || document.activeElement === element('model-view');
  const zoom = (factor) => (isOnSheet() ? viewer.movePlane(0, 0, factor) : viewer.zoom(1 / factor));
  const move = (right, up) => (isOnSheet() ? viewer.movePlane(part * right, part * up) : viewer.orbit(turn * right, -turn * up));
  const pick = (mode) => {
    const place = crosshair.locate();
    if (place) app.pick(place, mode);
  };
  const keys = {
    o: () => element('open').click(),
    s: () => pick('source'),
    a: () => pick('add'),
    t: () => pick('path'),
    i: () => crosshair.showValues((location, at) => app.hover(location, at)),
    d: () => viewer.pointer.startFollowing(),
    f: () => app.appearance.fit(),
    r: () => app.appearance.fit(),
    v: () => app.appearance.look('best'),
    m: () => { if (app.state.solver === 'exact') app.setSolver('exact', panel.nextMethod(app.state)); },
    c: () => app.sheet.toggle(),
    w: () => app.wave.toggle(),
    p: () => app.export('picture', 'png', { ...viewer.size, hasLegend: true }),
    '?': () => element('help').showModal(),
    '+': () => zoom(1 / 0.9),
    '=': () => zoom(1 / 0.9),
    '-': () => zoom(0.9),
    ArrowLeft: () => move(-1, 0),
    ArrowRight: () => move(1, 0),
    ArrowUp: () => move(0, 1),
    ArrowDown: () => move(0, -1),
  };
  for (const [i, button] of [...element('samples').children].entries()) keys[i + 1] = () => button.click();

  const takeBack = (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== 'z' && key !== 'y')) return false;
    if (key === 'y' || event.shiftKey) app.redo();
    else app.undo();
    event.preventDefault();
    return true;
  };

  window.addEventListener('keydown', (/** @type {any} */ event) => {
    if (element('help').open) return;
    if (!event.target.matches('input[type=number]') && takeBack(event)) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Escape') {
      app.cancel();
      panel.hideMessage();
      return;
    }
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!isOnView() || !Object.hasOwn(keys, key)) return;
    keys[key]();
    event.preventDefault();
  });

  // what is held is let go
  window.addEventListener('keyup', (event) => { if (event.key.toLowerCase() === 'd') viewer.pointer.endFollowing(); });
  window.addEventListener('blur', () => viewer.pointer.endFollowing());
}
