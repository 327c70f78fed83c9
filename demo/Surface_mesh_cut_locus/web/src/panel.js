// The controls beside the surface, the result on it, and the messages above it.
import { element } from './elements.js';
import { kinds } from './exports.js';
import { fillLegend } from './legend.js';
import { samples, sampleSizes } from './samples.js';
import { Slider, thresholds } from './sliders.js';
import { methods } from './state.js';
import { recall, remember } from './memory.js';
import { count, doubts, isOnePoint, milliseconds, number, numberRows, summary } from './words.js';

const stageLabels = {
  preprocessing: 'mesh',
  distance: 'distances',
  strength: 'where paths meet',
  tree: 'tree',
  homology: 'loops',
  filter: 'curves',
};

function fillList(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value, hint]) => {
    const term = document.createElement('dt'), definition = document.createElement('dd');
    term.textContent = name;
    definition.textContent = value;
    if (hint) term.append(document.createElement('br'), Object.assign(document.createElement('small'), { textContent: hint }));
    return [term, definition];
  }));
}

const valueOf = (input) =>
  (input.type === 'checkbox' ? input.checked : input.type === 'range' ? Number(input.value) : input.value);

export class Panel {
  constructor() {
    this.sliders = {};
    for (const size of sampleSizes) element('faces').append(new Option(`${size / 1000} K faces`, String(size)));
    for (const { name, label } of samples) {
      const button = document.createElement('button');
      button.textContent = label;
      button.dataset.sample = name;
      element('samples').append(button);
    }
    for (const [name, { label }] of Object.entries(kinds)) element('export-what').append(new Option(label, name));
    element('intro').hidden = recall('intro') === 'read';
    element('panel').classList.add('is-folded'); // which shows on phones alone
    element('result-fold').open = window.matchMedia('(min-width: 1200px)').matches;
  }

  connect(app) {
    this.app = app;
    for (const row of thresholds) {
      const slider = new Slider(row, (value) => app.setParameter(row.id, value));
      this.sliders[row.id] = slider;
      element(row.isDetail ? 'detail' : 'sliders').append(slider.row);
    }
    element('samples').addEventListener('click', ({ target }) => {
      if (target.dataset.sample) app.openSample(target.dataset.sample, Number(element('faces').value));
    });
    element('faces').addEventListener('change', () => {
      if (app.wantedSample) app.openSample(app.wantedSample, Number(element('faces').value));
    });
    const openFile = () => element('file').click();
    element('open').addEventListener('click', openFile);
    element('invitation-open').addEventListener('click', openFile);
    element('invitation-sample').addEventListener('click', () => app.openSample(samples[0].name, app.state.faces));
    element('file').addEventListener('change', () => {
      const [file] = element('file').files;
      if (file) app.openFile(file);
      element('file').value = '';
    });
    element('solver').addEventListener('change', () => app.setSolver(element('solver').value, app.state.method));
    element('method').addEventListener('change', () => app.setSolver(app.state.solver, element('method').value));
    element('policy').addEventListener('change', () => app.setParameter('policy', element('policy').value));
    element('keep').addEventListener('change', ({ target }) => app.setParameter('keep', target.value));
    element('border').addEventListener('change', ({ target }) => app.setSources(app.state.sources, target.value));
    element('defaults').addEventListener('click', () => app.resetParameters());
    element('undo').addEventListener('click', () => app.undo());
    element('redo').addEventListener('click', () => app.redo());
    for (const name of Object.keys(app.state.show))
      element(`show-${name}`).addEventListener('change', ({ target }) => app.appearance.setShown(name, target.checked));
    for (const name of Object.keys(app.state.look))
      element(`look-${name}`).addEventListener('input', ({ target }) => app.appearance.setLook(name, valueOf(target)));
    element('cut').addEventListener('click', () => app.sheet.toggle());
    element('parameterization').addEventListener('change', ({ target }) => app.sheet.setParameterization(target.value));
    element('fit').addEventListener('click', () => app.appearance.fit());
    element('view').addEventListener('change', ({ target }) => {
      if (target.value) app.appearance.look(target.value);
      target.value = '';
    });
    element('forget').addEventListener('click', async () => {
      await app.kept.clear();
      this.showMessage('No mesh of yours is kept here any more.', { isPlain: true });
    });
    element('cancel').addEventListener('click', () => app.cancel());
    element('message-close').addEventListener('click', () => this.hideMessage());
    element('message-retry').addEventListener('click', () => this.onRetry());
    element('panel-toggle').addEventListener('click', () => this.toggle());
    element('panel-hide').addEventListener('click', () => this.setHidden(true));
    element('panel-show').addEventListener('click', () => this.setHidden(false));
    element('wave-play').addEventListener('click', () => app.wave.toggle());
    element('wave-front').addEventListener('input', ({ target }) => app.wave.moveTo(target.value / target.max));
    element('intro-close').addEventListener('click', () => this.closeIntro());
    element('help-button').addEventListener('click', () => element('help').showModal());
    this.connectFullScreen();
    this.connectExport(app);
    app.store.subscribe((state) => this.setState(state));
    this.setState(app.state);
  }

  // Where the browser has it: on phones some have not, and frames may be without.
  connectFullScreen() {
    const button = element('full-screen');
    button.hidden = !document.fullscreenEnabled;
    button.addEventListener('click', async () => {
      try {
        await (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());
      } catch {
        this.showMessage('This browser does not show the page on the full screen.', { isPlain: true });
      }
    });
    document.addEventListener('fullscreenchange', () => button.setAttribute('aria-pressed', String(Boolean(document.fullscreenElement))));
  }

  connectExport(app) {
    const setFormats = () => {
      const { formats, note } = kinds[element('export-what').value];
      element('export-format').replaceChildren(...Object.entries(formats).map(([name, label]) => new Option(label, name)));
      element('export-note').textContent = note;
      const isPicture = element('export-what').value === 'picture';
      element('picture-options').hidden = !isPicture;
      if (isPicture && element('picture-width').value === '') this.setPictureSize(app.viewer.size);
    };
    element('export-what').addEventListener('change', setFormats);
    element('export').addEventListener('click', () =>
      app.export(element('export-what').value, element('export-format').value, this.picture()));
    setFormats();
  }

  setPictureSize({ width, height }) {
    element('picture-width').value = Math.round(2 * width);
    element('picture-height').value = Math.round(2 * height);
  }

  picture() {
    const size = (id, otherwise) => {
      const value = Math.round(Number(element(id).value));
      return value >= 16 ? Math.min(value, 16384) : otherwise;
    };
    const { viewer } = this.app;
    return {
      width: size('picture-width', viewer.size.width),
      height: size('picture-height', viewer.size.height),
      isTransparent: element('picture-transparent').checked,
      hasLegend: element('picture-legend').checked,
    };
  }

  get mode() {
    return /** @type {HTMLInputElement} */ (document.querySelector('#modes input:checked')).value;
  }

  setState(state) {
    element('solver').value = state.solver;
    element('method').value = state.method;
    element('method').disabled = state.solver !== 'exact';
    element('method').title = state.solver === 'exact' ? 'Next method (M)' : 'The other methods need exact distances';
    element('policy').value = state.parameters.policy;
    element('keep').value = state.parameters.keep;
    element('border').value = state.border;
    element('parameterization').value = state.parameterization;
    element('clip-field').hidden = state.look.clip === 'no';
    element('policy-field').hidden = state.method !== 'laplacian';
    for (const [name, slider] of Object.entries(this.sliders)) {
      if (slider.value !== state.parameters[name]) slider.set(state.parameters[name]);
      slider.row.hidden = !slider.methods.includes(state.method);
    }
    for (const [name, value] of Object.entries(state.show)) element(`show-${name}`).checked = value;
    for (const [name, value] of Object.entries(state.look)) {
      const input = element(`look-${name}`);
      if (input.type === 'checkbox') input.checked = value;
      else input.value = value;
    }
    this.setSample(state);
  }

  // `front` is the distance that the wave has come, or null if there is none.
  setWave(share, isPlaying, front) {
    const slider = element('wave-front');
    slider.value = share * slider.max;
    slider.setAttribute('aria-valuetext', front === null ? 'all of it' : `at distance ${number(front)}`);
    element('wave-play').textContent = isPlaying ? '❚❚ Stop' : '▶ Wave';
  }

  // Who has read it does not see it again.
  closeIntro() {
    element('intro').hidden = true;
    element('wave-play').focus();
    remember('intro', 'read');
  }

  setHistory(history) {
    element('undo').disabled = !history.canUndo;
    element('redo').disabled = !history.canRedo;
  }

  // the method after that of the state, for the keyboard
  nextMethod(state) {
    return methods[(methods.indexOf(state.method) + 1) % methods.length];
  }

  // On a phone the panel lies below the surface, and can be unfolded.
  toggle() {
    this.showReadout(null); // places move
    const isFolded = element('panel').classList.toggle('is-folded');
    element('panel-toggle').textContent = isFolded ? 'More' : 'Less';
    element('panel-toggle').setAttribute('aria-expanded', !isFolded);
  }

  // The picture alone; the focus goes to what takes it back.
  setHidden(isHidden) {
    this.showReadout(null);
    element('panel').hidden = isHidden;
    element('panel-show').hidden = !isHidden;
    element(isHidden ? 'panel-show' : 'panel-hide').focus();
    this.app.viewer.resize();
    this.app.appearance.fit();
  }

  // In a frame of another page there is the picture, with the wave, and a link to all the rest.
  setEmbedded(isEmbedded) {
    document.body.classList.toggle('is-embedded', isEmbedded);
    element('embed-open').hidden = !isEmbedded;
    element('intro').hidden ||= isEmbedded;
    if (isEmbedded) element('tools').prepend(element('wave'));
  }

  setLink(hash) {
    element('embed-open').href = hash;
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
    element('faces-field').hidden = !state.sample; // files have the size that they have
  }

  setMesh(state, mesh) {
    this.setSample(state);
    element('invitation').hidden = true;
    const name = state.sample ? samples.find((s) => s.name === state.sample).label : state.file;
    const parts = new Set(mesh.component).size;
    element('mesh-info').textContent =
      `${name}: ${count(mesh.positions.length / 3)} vertices, ${count(mesh.triangles.length / 3)} faces`
      + (parts > 1 ? ` in ${count(parts)} separate parts. The cut locus is that of the part with the source.` : '');
    element('repairs').textContent = mesh.repairs ? `Repaired: ${mesh.repairs}.` : '';
    element('repairs').hidden = !mesh.repairs;
  }

  // A link cannot have the file.
  invite(file) {
    element('invitation-title').textContent = `This link is about the file “${file}”`;
    element('invitation-text').textContent = 'Links do not contain meshes, and this browser has not kept that one. Open the file here, or '
      + 'drop it on the page, to see the same source, thresholds and view.';
    element('invitation').hidden = false;
  }

  // What the library takes for the thresholds that are left to it.
  setDefaults({ angle, width }, method) {
    this.sliders.angle.setInitial(angle);
    const percent = number(100 * width, 3);
    const note = method === 'polyhedral' ? 'Automatic: all branches.'
      : width > 0 ? `Automatic: ${percent} %, what this mesh resolves.`
        : 'Automatic: what the few, sharp corners of this mesh cause, however narrow.';
    this.sliders.width.setInitial(width > 0 || method !== 'default' ? 100 * width : NaN, note);
  }

  setScale({ label }) {
    element('width-label').textContent = label;
  }

  setLegend(items) {
    fillLegend(element('legend'), items);
  }

  // of how many faces the mesh is on which what is drawn has been computed, or 0: it is the result
  setPreview(faces) {
    if (this.previewFaces === faces) return;
    this.previewFaces = faces;
    element('preview-note').hidden = faces === 0;
    element('preview-note').textContent = `Preview, on ${count(faces)} faces: the cut locus comes when the source rests.`;
    element('result').classList.toggle('is-preview', faces > 0);
  }

  setResult(result) {
    const { times, state } = result;
    element('result').hidden = false;
    element('keep-field').hidden = result.source.total < 2;
    element('parameterization').disabled = !isOnePoint(result.source);
    element('border-field').hidden = result.source.borderLoops === 0;
    element('look-color').querySelector('[value=cells]').disabled = result.source.total < 2;
    const concerns = doubts(result);
    const text = [summary(result), ...concerns].join(' ');
    // what has not changed is not announced again
    if (element('result-note').textContent !== text) element('result-note').textContent = text;
    element('result').classList.toggle('is-doubtful', concerns.length > 0);
    const rows = numberRows(result);
    fillList(element('numbers'), rows);
    element('picture-text').textContent = `${state.sample || state.file}. ${text} `
      + rows.map(([name, value, hint]) => `${name} ${value} ${hint}`).join(', ');
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
      ['edges of the curve', count(result.curve.numbers[0])],
    ]);
  }

  setCut(isCut, quality) {
    element('cut-info').textContent = quality ? quality.text : '';
    element('cut-info').hidden = !isCut;
    element('cut-info').classList.toggle('is-doubtful', Boolean(quality) && !quality.isInjective);
    element('cut').textContent = isCut ? 'Close again' : 'Cut and flatten';
    element('cut').setAttribute('aria-pressed', isCut);
    this.showReadout(null); // places move
    if (isCut) element('result-fold').open = false; // it would cover the sheet
  }

  setCutStale() {
    element('cut-info').textContent = 'The sheet follows when the slider rests.';
  }

  // beside the pointer, and within the stage
  showReadout(text, at) {
    const readout = element('readout');
    readout.hidden = !text;
    if (!text) return;
    readout.textContent = text;
    const stage = element('stage').getBoundingClientRect();
    const { offsetWidth, offsetHeight } = readout;
    const x = at[0] - stage.left + 16, y = at[1] - stage.top + 16;
    readout.style.left = `${x + offsetWidth > stage.width ? x - offsetWidth - 32 : x}px`;
    readout.style.top = `${y + offsetHeight > stage.height ? y - offsetHeight - 32 : y}px`;
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
    element('busy-share').hidden = true;
  }

  // the part of a stage that is done
  setBusyShare(share) {
    element('busy-share').value = share;
    element('busy-share').hidden = false;
  }

  // What is plain goes by itself, when it has been read. `onRetry` does again what has failed.
  showMessage(text, { isPlain = false, onRetry = null } = {}) {
    element('message-text').textContent = text;
    element('message-retry').hidden = !onRetry;
    this.onRetry = onRetry;
    element('message').classList.toggle('is-plain', isPlain);
    element('message').hidden = false;
    clearTimeout(this.messageTimer);
    if (isPlain) this.messageTimer = setTimeout(() => this.hideMessage(), Math.max(5000, 80 * text.length));
  }

  // whether there is no graphics card to draw with
  setLost(isLost) {
    if (isLost)
      this.showMessage('The graphics card does not draw any more. The picture comes back with it, or when the page is loaded again.',
        { onRetry: () => location.reload() });
    else this.hideMessage();
  }

  hideMessage() {
    element('message').hidden = true;
  }
}
