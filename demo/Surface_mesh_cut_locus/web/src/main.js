// Starts the page: puts the parts together, and listens to the keyboard, to files that are dropped and to the address.
import { Address } from './address.js';
import { App } from './app.js';
import { DragHint } from './drag_hint.js';
import { Link } from './link.js';
import { Panel } from './panel.js';
import { samples } from './samples.js';
import { fromHash, toHash } from './state.js';
import { Viewer } from './viewer.js';

const element = (id) => document.getElementById(id);
const isFirstScreen = location.hash.length < 2;
const { state, ignored } = fromHash(location.hash);
const link = new Link(ignored);
const panel = new Panel();

let viewer;
try {
  viewer = new Viewer(element('canvas'), { model: element('model-view'), atlas: element('atlas-view') }, {
    onPick: (place, mode) => app.pick(place, mode || panel.mode),
    onHover: (place, at) => app.hover(place, at),
    onFollow: {
      start: (index) => app.follower.start(index),
      move: (locate) => app.follower.move(locate),
      end: () => app.follower.end(),
    },
    onChange: () => saveState(),
    onLost: (isLost) => panel.setLost(isLost),
    overlays: ['tools', 'intro', 'result', 'legend', 'cut-info'].map(element),
  });
} catch (error) {
  panel.showMessage('This page needs WebGL 2, which this browser does not offer.');
  throw error;
}
const app = new App(viewer, panel, state, link);
panel.connect(app);

let saved = location.hash;
const address = new Address((hash) => {
  saved = hash;
  history.replaceState(null, '', hash);
});
function saveState() {
  if (!app.mesh) return;
  state.view = viewer.getView();
  address.set(toHash(state));
}
app.onState = saveState;
window.addEventListener('pagehide', () => address.flush());

async function start() {
  if (!state.sample) {
    panel.invite(state.file);
    return;
  }
  if (!samples.some(({ name }) => name === state.sample)) {
    link.add(`There is no sample of the name “${state.sample}”.`);
    state.sample = samples[0].name;
  }
  await app.openSample(state.sample, state.faces, true);
  if (isFirstScreen && app.isSolved) greet();
}

// Nobody has chosen anything yet: the wave says what there is to see, if things may move.
function greet() {
  new DragHint(viewer, element('drag-hint')).show();
  if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches) app.wave.play();
}

window.addEventListener('hashchange', () => {
  if (location.hash === saved) return;
  location.reload();
});

element('copy-link').addEventListener('click', async () => {
  saveState();
  address.flush();
  try {
    await navigator.clipboard.writeText(location.href);
    panel.showMessage('The link is in the clipboard.', { isPlain: true });
  } catch {
    panel.showMessage('The link is in the address bar of the browser.', { isPlain: true });
  }
});

const pickCenter = (mode) => {
  const place = viewer.pointer.atCenter();
  if (place) app.pick(place, mode);
};

const turn = Math.PI / 24;
const part = 0.1; // of half of the sheet
const zoom = (factor) => (isOnSheet() ? viewer.movePlane(0, 0, factor) : viewer.zoom(1 / factor));
const isOnSheet = () => document.activeElement === element('atlas-view');
const keys = {
  o: () => element('open').click(),
  s: () => pickCenter('source'),
  a: () => pickCenter('add'),
  t: () => pickCenter('path'),
  f: () => app.appearance.fit(),
  r: () => app.appearance.fit(),
  v: () => app.appearance.look('best'),
  m: () => { if (state.solver === 'exact') app.setSolver('exact', panel.nextMethod(state)); },
  c: () => app.sheet.toggle(),
  p: () => app.export('picture', 'png', { ...viewer.size, hasLegend: true }),
  w: () => app.wave.toggle(),
  '?': () => element('help').showModal(),
  '+': () => zoom(1 / 0.9),
  '=': () => zoom(1 / 0.9),
  '-': () => zoom(0.9),
  Escape: () => { app.cancel(); panel.hideMessage(); },
};
const move = (right, up) => (isOnSheet() ? viewer.movePlane(part * right, part * up) : viewer.orbit(turn * right, -turn * up));
const viewKeys = {
  ArrowLeft: () => move(-1, 0),
  ArrowRight: () => move(1, 0),
  ArrowUp: () => move(0, 1),
  ArrowDown: () => move(0, -1),
};

function takeBack(event) {
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== 'z' && key !== 'y')) return false;
  if (key === 'y' || event.shiftKey) app.redo();
  else app.undo();
  event.preventDefault();
  return true;
}

window.addEventListener('keydown', (event) => {
  if (element('help').open) return;
  const isTyping = event.target.matches('input[type=number], input[type=range], select');
  if (!event.target.matches('input[type=number]') && takeBack(event)) return;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (isTyping && key !== 'Escape') return;
  if (key === 'd') viewer.pointer.startFollowing();
  else if (/^[1-4]$/.test(key)) element('samples').children[Number(key) - 1].click();
  else if (keys[key]) keys[key]();
  else if (viewKeys[key] && !event.target.matches('button, input, summary')) viewKeys[key]();
  else return;
  event.preventDefault();
});

// what is held is let go
window.addEventListener('keyup', (event) => { if (event.key.toLowerCase() === 'd') viewer.pointer.endFollowing(); });
window.addEventListener('blur', () => viewer.pointer.endFollowing());

const stage = document.body;
let depth = 0; // of the elements entered while a file is dragged
stage.addEventListener('dragenter', () => { ++depth; element('drop').hidden = false; });
stage.addEventListener('dragleave', () => { if (--depth <= 0) element('drop').hidden = true; });
stage.addEventListener('dragover', (event) => event.preventDefault());
stage.addEventListener('drop', (event) => {
  event.preventDefault();
  depth = 0;
  element('drop').hidden = true;
  const [file] = event.dataTransfer.files;
  if (file) app.openFile(file);
});

// for tests and for whoever looks at the page from the console
window.cutLocusPage = { app, viewer, panel };
start();
