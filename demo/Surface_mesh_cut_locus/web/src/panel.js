// The controls beside the surface, and the messages above it.
import { samples, sampleSizes } from './samples.js';
import { branchScale } from './branch_scale.js';
import { Slider, thresholds } from './sliders.js';
import { methods } from './state.js';

const element = (id) => document.getElementById(id);
const count = (n) => Math.round(n).toLocaleString('en');

function milliseconds(ms) {
  if (!Number.isFinite(ms)) return '–';
  if (ms >= 1000) return `${(ms / 1000).toPrecision(3)} s`;
  return `${ms >= 100 ? Math.round(ms) : ms.toFixed(1)} ms`;
}

function number(x, digits = 5) {
  return Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : '–';
}

const stageLabels = {
  preprocessing: 'mesh',
  distance: 'distances',
  strength: 'where paths meet',
  tree: 'tree',
  homology: 'cycles',
  filter: 'curves',
};

// by the status of a cut locus: 0 is that of one with branches
const emptyNotes = {
  1: 'The cut locus is one point: either all shortest paths meet there, as on a sphere, or no branch passes the '
    + 'thresholds. Smaller ones may show some.',
  2: 'The cut locus has no branches: either all shortest paths end at the border, as in a flat disk, or no branch '
    + 'passes the thresholds. Smaller ones may show some.',
};

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
    for (const row of thresholds) {
      const slider = new Slider(row, (value) => app.setParameter(row.id, value));
      slider.methods = row.methods;
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
    element('panel-toggle').addEventListener('click', () => this.toggle());
    element('help-button').addEventListener('click', () => element('help').showModal());
    this.setState(app.state);
  }

  setState(state) {
    element('solver').value = state.solver;
    element('method').value = state.method;
    element('method').disabled = state.solver !== 'exact';
    element('method').title = state.solver === 'exact' ? 'Next method (M)' : 'The other methods need exact distances';
    element('policy').value = state.parameters.policy;
    element('policy-field').hidden = state.method !== 'laplacian';
    for (const [name, slider] of Object.entries(this.sliders)) {
      slider.set(state.parameters[name]);
      slider.row.hidden = !slider.methods.includes(state.method);
    }
    for (const [name, value] of Object.entries(state.show)) element(`show-${name}`).checked = value;
    this.setSample(state);
  }

  // the method after that of the state, for the keyboard
  nextMethod(state) {
    return methods[(methods.indexOf(state.method) + 1) % methods.length];
  }

  // On a phone the panel lies below the surface, and can be folded.
  toggle() {
    const isFolded = element('panel').classList.toggle('is-folded');
    element('panel-toggle').textContent = isFolded ? 'More' : 'Less';
    element('panel-toggle').setAttribute('aria-expanded', !isFolded);
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

  // What the library takes for the thresholds that are left to it.
  setDefaults({ angle, width, gap }, method) {
    this.sliders.angle.setInitial(angle);
    const percent = number(100 * width, 3);
    const note = method === 'polyhedral' ? 'Automatic: all branches.'
      : width > 0 ? `Automatic: ${percent} %, what this mesh resolves.`
        : `Automatic: a gap of ${number(gap, 3)} radians between the paths where they part, as this mesh has few, sharp corners.`;
    this.sliders.width.setInitial(width > 0 || !(gap > 0) ? 100 * width : NaN, note);
  }

  // The scale of the colours, beside its box, and below the surface while they are shown.
  setScale(state, defaults) {
    const { label, ends } = branchScale(state, defaults);
    element('width-label').textContent = label;
    element('width-range').textContent = `(${ends.join(' to ')})`;
    element('legend-scale').hidden = !state.show.width;
    element('legend-curve').hidden = state.show.width;
    element('scale-name').textContent = `${label}:`;
    [element('scale-low').textContent, element('scale-high').textContent] = ends;
  }

  setResult({ source, curve, times }) {
    if (!source || !curve) return;
    const [edges, cycles, leaves, branchings, length, radius] = curve.numbers;
    const note = emptyNotes[curve.numbers[9]] || '';
    element('result-note').textContent = note;
    element('result-note').hidden = note === '';
    fillList(element('numbers'), [
      ['genus', count(source.genus)],
      ...(source.borderLoops > 0 ? [['border loops', count(source.borderLoops)]] : []),
      ['edges of the curve', count(edges)],
      ['cycles', count(cycles)],
      ['ends, branchings', `${count(leaves)}, ${count(branchings)}`],
      ['length', number(length)],
      // off by a part of an edge, and that of the curve shown: other thresholds give another one
      ['injectivity radius', edges > 0 ? `${number(radius, 3)} (with these thresholds)` : '–'],
      ['farthest distance', number(source.farthestDistance)],
    ]);
    const { threshold } = times;
    fillList(element('times'), [
      ['new threshold', threshold ? milliseconds(threshold.shown) : '–'],
      ...(threshold ? [['– computing', milliseconds(threshold.computed)]] : []),
      ...(times.smoothing ? [['smoothed', milliseconds(times.smoothing.shown)]] : []),
      ['new source', milliseconds(times.source)],
      ['– computing', milliseconds(times.solve)],
      ...Object.entries(times.stages).map(([stage, ms]) => [`– – ${stageLabels[stage]}`, milliseconds(ms)]),
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

  // what is plain goes by itself, unless it stays
  showMessage(text, isPlain = false, stays = false) {
    element('message-text').textContent = text;
    element('message').classList.toggle('is-plain', isPlain);
    element('message').hidden = false;
    clearTimeout(this.messageTimer);
    if (isPlain && !stays) this.messageTimer = setTimeout(() => this.hideMessage(), 4000);
  }

  hideMessage() {
    element('message').hidden = true;
  }
}
