// The controls beside the surface, and the messages above it.
import { samples, sampleSizes } from './samples.js';
import { Slider, thresholds } from './sliders.js';

const element = (id) => document.getElementById(id);
const count = (n) => Math.round(n).toLocaleString('en');

function milliseconds(ms) {
  if (!Number.isFinite(ms)) return '–';
  if (ms >= 1000) return `${(ms / 1000).toPrecision(3)} s`;
  return `${ms >= 100 ? Math.round(ms) : ms.toFixed(1)} ms`;
}

function number(x) {
  return Number.isFinite(x) ? String(Number(x.toPrecision(5))) : '–';
}

function fillList(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value]) => {
    const term = document.createElement('dt'), definition = document.createElement('dd');
    term.textContent = name;
    definition.textContent = value;
    return [term, definition];
  }));
}

export class Panel {
  constructor() {
    this.sliders = {};
    for (const size of sampleSizes) element('faces').append(new Option(`${size / 1000} K faces`, size));
    for (const { name, label } of samples) {
      const button = document.createElement('button');
      button.textContent = label;
      button.dataset.sample = name;
      element('samples').append(button);
    }
  }

  connect(app) {
    for (const [method, rows] of Object.entries(thresholds))
      for (const row of rows) {
        const slider = new Slider(row, (value) => app.setParameter(row.id, value));
        slider.row.dataset.method = method;
        this.sliders[row.id] = slider;
        element('sliders').append(slider.row);
      }
    element('samples').addEventListener('click', ({ target }) => {
      if (target.dataset.sample) app.openSample(target.dataset.sample, Number(element('faces').value));
    });
    element('faces').addEventListener('change', () => {
      if (app.wantedSample) app.openSample(app.wantedSample, Number(element('faces').value));
    });
    element('open').addEventListener('click', () => element('file').click());
    element('file').addEventListener('change', () => {
      const [file] = element('file').files;
      if (file) app.openFile(file);
      element('file').value = '';
    });
    element('solver').addEventListener('change', () => app.setSolver(element('solver').value, app.state.method));
    element('method').addEventListener('change', () => app.setSolver(app.state.solver, element('method').value));
    element('policy').addEventListener('change', () => app.setParameter('policy', element('policy').value));
    element('defaults').addEventListener('click', () => app.resetParameters());
    for (const name of Object.keys(app.state.show))
      element(`show-${name}`).addEventListener('change', ({ target }) => app.setShown(name, target.checked));
    element('cut').addEventListener('click', () => app.toggleCut());
    element('export').addEventListener('click', () => app.export(element('export-kind').value));
    element('cancel').addEventListener('click', () => app.cancel());
    element('message-close').addEventListener('click', () => this.hideMessage());
    element('help-button').addEventListener('click', () => element('help').showModal());
    this.setState(app.state);
  }

  setState(state) {
    element('solver').value = state.solver;
    element('method').value = state.method;
    element('method').disabled = state.solver !== 'exact';
    element('method').title = state.solver === 'exact' ? 'Other method (M)' : 'The direction method needs exact distances';
    element('policy').value = state.parameters.policy;
    element('policy-field').hidden = state.method !== 'laplacian';
    for (const [name, slider] of Object.entries(this.sliders)) {
      slider.set(state.parameters[name]);
      slider.row.hidden = slider.row.dataset.method !== state.method;
    }
    for (const [name, value] of Object.entries(state.show)) element(`show-${name}`).checked = value;
    element('strength-range').textContent = state.method === 'direction' ? '(2 to 200)' : '(0 to π)';
    this.setSample(state);
  }

  setSample(state) {
    for (const button of element('samples').children)
      button.setAttribute('aria-pressed', button.dataset.sample === state.sample);
    if (!sampleSizes.includes(state.faces) && !element('faces').querySelector('[data-other]')) {
      const option = new Option(`${count(state.faces)} faces`, state.faces);
      option.dataset.other = '';
      element('faces').append(option);
    }
    element('faces').value = state.faces;
  }

  setMesh(state, mesh) {
    this.setSample(state);
    const name = state.sample ? samples.find((s) => s.name === state.sample).label : state.file;
    element('mesh-info').textContent =
      `${name}: ${count(mesh.positions.length / 3)} vertices, ${count(mesh.triangles.length / 3)} faces`;
  }

  setDefaultAngle(angle) {
    this.sliders.angle.setInitial(angle);
  }

  setResult({ source, curve, times }) {
    if (!source || !curve) return;
    const [edges, cycles, leaves, branchings, length, radius] = curve.numbers;
    fillList(element('numbers'), [
      ['genus', count(source.genus)],
      ...(source.borderLoops > 0 ? [['border loops', count(source.borderLoops)]] : []),
      ['edges of the curve', count(edges)],
      ['cycles', count(cycles)],
      ['ends, branchings', `${count(leaves)}, ${count(branchings)}`],
      ['length', number(length)],
      ['injectivity radius', number(radius)],
      ['farthest distance', number(source.farthestDistance)],
    ]);
    const { threshold } = times;
    fillList(element('times'), [
      ['new threshold', threshold ? milliseconds(threshold.shown) : '–'],
      ...(threshold ? [['– computing', milliseconds(threshold.computed)]] : []),
      ...(times.smoothing ? [['smoothed', milliseconds(times.smoothing.shown)]] : []),
      ['new source', milliseconds(times.source)],
      ['– computing', milliseconds(times.solve)],
      ...Object.entries(times.stages).map(([stage, ms]) => [`– – ${stage}`, milliseconds(ms)]),
      ...(times.cut ? [['cut and flattened', milliseconds(times.cut)]] : []),
      ['reading', milliseconds(times.load)],
    ]);
  }

  showNearest(visible) {
    element('legend-nearest').hidden = !visible;
  }

  setCut(isCut, description = '') {
    element('cut-info').textContent = description;
    element('cut-info').hidden = !isCut;
    element('cut').textContent = isCut ? 'Close again' : 'Cut and flatten';
    element('cut').setAttribute('aria-pressed', isCut);
  }

  // Short work does not flicker.
  setBusy(isBusy, text) {
    clearTimeout(this.busyTimer);
    document.body.dataset.busy = isBusy;
    if (!isBusy) {
      element('busy').hidden = true;
      return;
    }
    if (text) this.setBusyText(text);
    this.busyTimer = setTimeout(() => { element('busy').hidden = false; }, 150);
  }

  setBusyText(text) {
    element('busy-text').textContent = text;
  }

  showMessage(text, isPlain = false) {
    element('message-text').textContent = text;
    element('message').classList.toggle('is-plain', isPlain);
    element('message').hidden = false;
    clearTimeout(this.messageTimer);
    if (isPlain) this.messageTimer = setTimeout(() => this.hideMessage(), 4000);
  }

  hideMessage() {
    element('message').hidden = true;
  }
}
