// What the page does: it loads a mesh, solves for its sources, follows the sliders and cuts the surface open. It knows
// the engine, the viewer and the panel, which do not know each other.
import { Appearance } from './appearance.js';
import { CellColors, colorsOf } from './cell_colors.js';
import { Canceled, Engine } from './engine.js';
import { exportAs } from './exports.js';
import { Follower } from './follow.js';
import { History } from './history.js';
import { KeptMeshes } from './kept_meshes.js';
import { legendItems } from './legend_items.js';
import { explain, extensionOf, objectionTo } from './messages.js';
import { PathTool } from './path_tool.js';
import { Preview } from './preview.js';
import { describeValues, Readout } from './readout.js';
import { farthestFace, fileStart, samples, startCoordinates } from './samples.js';
import { Sheet } from './sheet.js';
import { defaultState, rounded } from './state.js';
import { guessUp } from './up_axis.js';
import { Wave } from './wave.js';

const stageTexts = {
  preprocessing: 'Preparing the mesh…',
  distance: 'Computing distances…',
  strength: 'Finding where shortest paths meet…',
  tree: 'Joining the branches…',
  homology: 'Closing the loops…',
  filter: 'Choosing the branches…',
  cutting: 'Cutting the surface open…',
  flattening: 'Flattening…',
};

const faceCurve = 1, edgeCurve = 0;
const restMilliseconds = 150; // a slider that has not moved for so long is at rest
const nearPixels = 9; // what a click is as near to is meant

export class App {
  constructor(viewer, panel, store, link) {
    this.viewer = viewer;
    this.panel = panel;
    this.store = store;
    this.link = link; // with what is to be said about it
    this.engine = new Engine((stage) => panel.setBusyText(stageTexts[stage]), (stage, share) => panel.setBusyShare(share));
    this.history = new History();
    this.kept = new KeptMeshes();
    this.readout = new Readout();
    this.appearance = new Appearance(this);
    this.cellColors = new CellColors(this);
    this.sheet = new Sheet(this);
    this.follower = new Follower(this);
    this.pathTool = new PathTool(this);
    this.preview = new Preview(this);
    this.wave = new Wave((share, isPlaying) => this.showWave(share, isPlaying));
    this.mesh = null;
    this.curves = {};
    this.isSolved = false; // the worker has the solver and the sources of the state
    this.solved = null; // what it has been solved for last, of this mesh
    this.commands = 0; // to solve or to open: what one of them has replaced is not taken back
    this.exactMethod = this.state.method; // the one that was chosen last
    this.defaults = null; // of the thresholds, for these sources
    this.linkedView = this.state.view; // until there is a mesh
    this.leastAngle = 0; // branches that need a smaller one are not computed yet
    this.hasWave = false; // on the screen
    this.jobs = 0;
    this.times = {};
    this.appearance.apply();
  }

  get state() {
    return this.store.state;
  }

  // Runs something that takes time; tells the user what became of it. False if it failed.
  async attempt(text, action) {
    this.panel.hideMessage();
    this.panel.setBusy(++this.jobs > 0, text);
    try {
      await action();
      return true;
    } catch (error) {
      // what another command has replaced needs no words
      if (!(error instanceof Canceled))
        this.panel.showMessage(explain(error), { onRetry: error.fatal ? () => this.attempt(text, action) : null });
      return false;
    } finally {
      this.panel.setBusy(--this.jobs > 0);
    }
  }

  cancel() {
    if (!this.engine.isBusy) return;
    this.isSolved = false;
    this.engine.cancel();
    this.sheet.drop(); // it may be that of other thresholds
    this.panel.showMessage('Canceled.', { isPlain: true });
  }

  openSample(name, faces, keepsSource = false) {
    const sample = samples.find((s) => s.name === name);
    this.wantedSample = name;
    return this.open({ sample: name, faces }, { sample: name, faces, file: null }, sample.start, keepsSource);
  }

  async openFile(file) {
    const objection = objectionTo(file);
    if (objection) {
      this.panel.showMessage(objection);
      return false;
    }
    const keepsSource = this.state.file === file.name && !this.mesh; // a link that names this file
    const command = ++this.commands;
    let bytes;
    try {
      bytes = await file.arrayBuffer();
    } catch {
      this.panel.showMessage(`“${file.name}” cannot be read.`);
      return false;
    }
    // another one has been opened while this one was read
    if (command !== this.commands) return false;
    const isOpen = await this.openBytes(file.name, bytes, keepsSource);
    if (isOpen) await this.kept.put(file.name, bytes);
    return isOpen;
  }

  openBytes(name, bytes, keepsSource) {
    return this.open({ bytes, extension: extensionOf(name) }, { sample: null, file: name }, fileStart, keepsSource);
  }

  // The file that a link names, if this browser has kept it; false if not.
  async openKept() {
    const { file } = this.state;
    const bytes = await this.kept.get(file);
    if (!bytes) return false;
    this.openBytes(file, bytes, true);
    return true;
  }

  async open(recipe, names, start, keepsSource) {
    ++this.commands;
    if (this.engine.isBusy) this.engine.cancel(false);
    return this.attempt('Reading the mesh…', async () => {
      const begin = performance.now();
      try {
        this.mesh = await this.engine.load(recipe);
      } catch (error) {
        // the module has dropped the mesh it had
        if (this.mesh && !(error instanceof Canceled) && !error.fatal) this.engine.restart();
        this.isSolved = false;
        this.panel.setSample(this.state);
        throw error;
      }
      this.times = { load: performance.now() - begin };
      this.takeMesh(names, start, keepsSource);
      const view = keepsSource ? this.linkedView : null;
      this.linkedView = null;
      if (view) this.viewer.setView(view);
      if (keepsSource) await this.solveLinked();
      else await this.solveNow();
      if (!view) this.appearance.look('best');
      const notes = [...(keepsSource ? this.link.notes : [])];
      if (this.mesh.repairs) notes.push(`Repaired to open it: ${this.mesh.repairs}.`);
      if (notes.length > 0) this.panel.showMessage(notes.join(' '), { isPlain: true });
    });
  }

  // As a link says, if that can be done: sources and method of others may make no sense on this mesh.
  async solveLinked() {
    try {
      await this.solveNow();
    } catch (error) {
      if (error instanceof Canceled || error.fatal) throw error;
      const { solver, method, border, parameters } = defaultState();
      this.store.set({ solver, method, border, parameters, sources: [this.firstSource()], isCut: false });
      this.exactMethod = method;
      this.link.add(`What this link asks for cannot be shown: ${explain(error)} The surface is shown as it opens.`);
      await this.solveNow();
    }
  }

  // Where it is on the mesh before anybody chooses.
  firstSource() {
    const { positions, triangles, component } = this.mesh;
    return { face: farthestFace(positions, triangles, this.start, component), coordinates: [...startCoordinates] };
  }

  takeMesh(names, start, keepsSource) {
    this.wantedSample = names.sample;
    this.isSolved = false;
    this.solved = null;
    this.start = start;
    const { positions, triangles, numbers } = this.mesh;
    const faceCount = triangles.length / 3;
    const isInMesh = (this.state.sources || []).every(({ face }) => face < faceCount);
    if (keepsSource && !isInMesh) this.link.add('The source of this link is not on this surface: another one is shown.');
    const hasSources = keepsSource && this.state.sources && isInMesh;
    // thresholds are those of another mesh
    const others = { isCut: false, border: 'no', parameters: defaultState().parameters, look: { up: 'auto' } };
    this.history.clear();
    this.preview.forget();
    this.mesh.edgeLength = numbers[3] * meanEdgeLength(positions, triangles);
    this.mesh.up = names.sample ? 'z' : guessUp(positions, triangles, extensionOf(names.file));
    this.curves = {};
    this.store.set({ ...names, ...(hasSources ? {} : { sources: [this.firstSource()] }), ...(keepsSource ? {} : others) });
    this.sheet.forget();
    this.cellColors.step = null;
    this.viewer.setMesh(positions, triangles);
    this.readout.setMesh(positions, triangles);
    this.appearance.apply();
    if (!keepsSource) this.viewer.resetView();
    this.panel.setMesh(this.state, this.mesh);
  }

  // A click, or a key: `mode` says what for.
  pick(location, mode) {
    if (!this.mesh) return null;
    if (mode === 'path') return this.pathTool.show(location);
    const source = { face: location.face, coordinates: location.coordinates.map(rounded) };
    // a point beside the border, if that has been the only source
    if (this.state.border === 'only') return this.setSources([source], 'also');
    return this.setSources(mode === 'add' ? this.withSource(source, location) : [source]);
  }

  // One more, or one less if it is there.
  withSource(source, { place, pixel }) {
    const { sources } = this.state;
    const off = (point) => Math.hypot(...this.toView(point).map((x, k) => x - place[k]));
    const near = this.source ? this.source.points.findIndex((point) => off(point) < nearPixels * pixel) : -1;
    if (near < 0) return [...sources, source];
    return sources.length > 1 ? sources.filter((_, i) => i !== near) : sources;
  }

  setSources(sources, border = this.state.border, replacesStep = false) {
    return this.change({ sources, border }, replacesStep);
  }

  setSolver(solver, method) {
    if (solver === 'exact') this.exactMethod = this.state.solver === 'exact' ? method : this.exactMethod;
    return this.change({ solver, method: solver === 'exact' ? this.exactMethod : 'laplacian' });
  }

  // If that fails, or is canceled, all becomes what it was when it was solved last, unless another command has come.
  async change(values, replacesStep = false) {
    this.store.set(values);
    const solving = this.solve(replacesStep);
    const command = this.commands;
    if (await solving || this.isSolved || command !== this.commands || !this.solved) return;
    const { exactMethod, ...solved } = this.solved;
    this.store.set(solved);
    this.exactMethod = exactMethod;
    this.panel.setBusy(++this.jobs > 0, 'Going back…'); // and the message stays
    await this.solveNow().catch(() => {});
    this.panel.setBusy(--this.jobs > 0);
  }

  async solve(replacesStep = false) {
    if (!this.mesh) return false;
    ++this.commands;
    if (this.engine.isBusy) this.engine.cancel();
    this.isSolved = false;
    return this.attempt('Computing…', () => this.solveNow(replacesStep));
  }

  async solveNow(replacesStep = false) {
    const begin = performance.now();
    const { solver, method, sources, border, parameters } = this.state;
    const points = border === 'only' ? [] : sources;
    const result = await this.engine.run('solve',
      { solver, method, sources: points, border: border !== 'no', parameters: this.parameters, curves: this.wantedCurves() });
    this.isSolved = true;
    this.solved = { solver, method, sources, border, exactMethod: this.exactMethod };
    this.panel.showReadout(null); // it was that of other sources
    this.distance = result.distance;
    this.appearance.forgetFields();
    this.takeSources(result);
    this.leastAngle = Math.min(this.angleFor(null), this.angleFor(parameters.width));
    this.panel.setDefaults(this.defaults, method);
    this.viewer.setDistance(this.distance);
    this.pathTool.set(null);
    this.curves = {};
    this.takeCurves(result, parameters);
    this.viewer.invalidateCurves();
    Object.assign(this.times, {
      source: performance.now() - begin,
      solve: result.solveMilliseconds,
      stages: result.stages,
      threshold: null,
      smoothing: null,
      cut: null,
    });
    this.remember(replacesStep);
    await this.appearance.showFields();
    if (this.state.isCut) await this.sheet.cut();
    this.report();
    this.preview.schedule(result.solveMilliseconds + result.milliseconds);
  }

  // Sources that move: what is drawn follows, and nothing else. Returns whether all else is as it was.
  async previewSources(sources, relativeError) {
    if (this.preview.isReady) {
      await this.drawPreview(sources);
      return true;
    }
    this.isSolved = false;
    const { solver, method, border } = this.state;
    const parameters = { ...this.parameters, smoothing: 0 };
    const result = await this.engine.run('solve',
      { solver, method, sources, border: border !== 'no', parameters, curves: this.wantedCurves(), relativeError });
    this.distance = result.distance;
    this.appearance.forgetFields();
    this.times.follow = result.solveMilliseconds + result.milliseconds;
    this.takeSources(result);
    this.pathTool.set(null);
    this.viewer.setDistance(this.distance);
    this.curves = {};
    this.takeCurves(result, parameters);
    this.viewer.invalidateCurves();
    return false;
  }

  // Distances are wanted only where they are shown, and when the surface is going to be drawn again.
  async drawPreview(sources) {
    this.wave.end();
    const { show, look } = this.state;
    const isShown = show.isolines || show.disk || ['distance', 'cells'].includes(look.color);
    const result = await this.preview.compute(sources, isShown && this.viewer.isSurfaceDue);
    this.times.follow = result.milliseconds;
    const points = sources.map(({ face, coordinates }) => this.viewer.placeOf(face, coordinates));
    this.viewer.setUniforms({ coloring: look.color === 'laplacian' ? 'plain' : look.color });
    if (result.distance) {
      this.viewer.setDistance(result.distance);
      const radius = result.numbers[5] * this.mesh.numbers[3]; // from that of the unit ball
      this.viewer.setUniforms({ showDisk: show.disk && Number.isFinite(radius), radius });
      if (look.color === 'cells' && sources.length > 1) this.viewer.setCells(colorsOf(result.nearestSource));
    }
    this.viewer.showPreview(result.segments, points, show.hidden);
    this.panel.setPreview(this.preview.faces);
  }

  showWave(share, isPlaying) {
    const front = share < 1 && this.source ? share * this.source.farthestDistance : null;
    this.viewer.setFront(front);
    this.panel.setWave(share, isPlaying, front);
    const isShown = front !== null;
    if (this.hasWave === isShown) return;
    this.hasWave = isShown;
    this.panel.setLegend(this.legendItems());
  }

  takeSources({ sourceNumbers, borderSegments, nearestSource }) {
    const [fx, fy, fz, farthestDistance, borderLoops, genus, angle, width, total, ...points] = sourceNumbers;
    const hasBorder = borderSegments.length > 0;
    this.source = { points: [], border: borderSegments, hasBorder, total, nearest: nearestSource, farthest: [fx, fy, fz], farthestDistance, borderLoops, genus };
    for (let i = 0; i < points.length; i += 3) this.source.points.push(points.slice(i, i + 3));
    this.defaults = { angle, width };
    this.wave.end();
    this.viewer.setSources(this.source.points.map((point) => this.toView(point)));
    this.viewer.setMarker(this.viewer.farthestMarker, this.toView(this.source.farthest));
    this.viewer.setSourceLines(borderSegments);
    this.cellColors.forget();
    this.viewer.setCells(total > 1 ? colorsOf(nearestSource) : null);
  }

  toView(p) {
    const [x, y, z, radius] = this.mesh.numbers;
    return [(p[0] - x) / radius, (p[1] - y) / radius, (p[2] - z) / radius];
  }

  // what can be taken back
  get step() {
    const { sources, border, solver, method, parameters } = this.state;
    return { sources, border, solver, method, parameters };
  }

  remember(replacesLast = false) {
    clearTimeout(this.rememberTimer);
    this.history.push(this.step, replacesLast);
    this.panel.setHistory(this.history);
  }

  // A source that is still being moved is one step.
  async undo() {
    await this.follower.end();
    this.remember();
    return this.restore(this.history.undo());
  }

  async redo() {
    await this.follower.end();
    return this.restore(this.history.redo());
  }

  async restore(step) {
    if (!step) return;
    const now = this.step;
    this.store.set(step);
    if (step.solver === 'exact') this.exactMethod = step.method;
    this.panel.setHistory(this.history);
    const isSame = ['sources', 'border', 'solver', 'method'].every((name) => JSON.stringify(now[name]) === JSON.stringify(step[name]));
    if (isSame && this.isSolved) await this.updateCurves();
    else await this.solve();
    this.panel.setHistory(this.history);
  }

  wantedCurves() {
    const { show } = this.state;
    const curves = [];
    if (show.faceCurve || !show.edgeCurve) curves.push(faceCurve);
    if (show.edgeCurve) curves.push(edgeCurve);
    return curves;
  }

  // The library computes branches from an angle at the source on, as its Exact_tree_solver says: for a width, in
  // percent, or for its default.
  angleFor(width) {
    if (!this.defaults || this.state.method !== 'default') return 0;
    return width === null ? 0.125 * this.defaults.width : 0.5 * width / 100;
  }

  get needsMoreBranches() {
    return this.angleFor(this.state.parameters.width) < this.leastAngle;
  }

  // What takes longer than a frame waits for the slider to rest: smoothing, and more branches than there are.
  setParameter(name, value) {
    this.store.set({ parameters: { [name]: value } });
    const { method, parameters } = this.state;
    const smooths = method === 'laplacian' && this.wantedCurves().includes(faceCurve) && parameters.smoothing > 0;
    clearTimeout(this.restTimer);
    clearTimeout(this.rememberTimer);
    this.rememberTimer = setTimeout(() => this.remember(), 3 * restMilliseconds);
    if (!smooths && !this.needsMoreBranches) return this.updateCurves();
    this.restTimer = setTimeout(() => this.updateCurves(true), restMilliseconds);
    return smooths ? this.updateCurves(false) : null;
  }

  // While the worker computes, only the last move of a slider is remembered.
  async updateCurves(isSmooth = true) {
    if (!this.isSolved) {
      if (this.mesh && !this.engine.isBusy) await this.solve();
      return;
    }
    this.wantsSmooth = isSmooth;
    this.moved = performance.now();
    if (this.isUpdating) {
      this.wantsUpdate = true;
      return;
    }
    this.isUpdating = true;
    try {
      do {
        this.wantsUpdate = false;
        const begin = this.moved;
        const parameters = this.liveParameters();
        const result = await this.computeCurves(parameters);
        this.takeCurves(result, parameters);
        this.viewer.draw();
        this.times[this.wantsSmooth && this.state.method === 'laplacian' ? 'smoothing' : 'threshold'] = { shown: performance.now() - begin, computed: result.milliseconds };
        this.panel.hideMessage();
        this.report();
      } while (this.wantsUpdate);
      this.sheet.cutAtRest();
      this.cellColors.showAtRest();
    } catch (error) {
      if (!(error instanceof Canceled)) this.panel.showMessage(explain(error));
    } finally {
      this.isUpdating = false;
    }
  }

  async computeCurves(parameters) {
    const takesLong = this.needsMoreBranches;
    if (takesLong) this.panel.setBusy(++this.jobs > 0, 'Computing more branches…');
    try {
      const result = await this.engine.run('curves', { curves: this.wantedCurves(), parameters });
      this.leastAngle = Math.min(this.leastAngle, this.angleFor(parameters.width));
      return result;
    } finally {
      if (takesLong) this.panel.setBusy(--this.jobs > 0);
    }
  }

  // for the library: of one source, a Voronoi diagram is empty
  get parameters() {
    const { parameters, sources, border } = this.state;
    const loops = border !== 'no' && this.source ? this.source.borderLoops : 0;
    const total = (border === 'only' ? 0 : sources.length) + loops;
    return { ...parameters, keep: total > 1 ? parameters.keep : 'all' };
  }

  liveParameters() {
    return { ...this.parameters, ...(this.wantsSmooth ? {} : { smoothing: 0 }) };
  }

  takeCurves(result, parameters) {
    this.drawn = { ...parameters };
    for (const name of ['edgeCurve', 'faceCurve']) if (result[name]) this.curves[name] = result[name];
    this.shownCurve = result.faceCurve ? 'faceCurve' : 'edgeCurve';
    this.viewer.hidePreview();
    this.panel.setPreview(0);
    this.appearance.drawCurves();
  }

  get path() {
    return this.pathTool.path;
  }

  get atlas() {
    return this.sheet.atlas;
  }

  get curve() {
    return this.curves[this.shownCurve];
  }

  // The values where the pointer rests, or nothing.
  hover(location, at) {
    const { curve } = this;
    if (!location || !this.state.show.values || !this.distance) {
      this.panel.showReadout(null);
      return;
    }
    const values = this.readout.values(location, this.distance, curve && curve.numbers[0] > 0 ? curve : null, this.mesh.numbers[3]);
    this.panel.showReadout(describeValues(values, this.state.method === 'laplacian'), at);
  }

  // All that decides on the result is as it was at first; what is shown stays.
  resetParameters() {
    const standard = defaultState();
    const { solver, method } = this.state;
    this.store.set({ parameters: standard.parameters, solver: standard.solver, method: standard.method });
    this.exactMethod = standard.method;
    if (solver !== standard.solver || method !== standard.method) return this.solve();
    this.remember();
    return this.updateCurves();
  }

  legendItems() {
    return legendItems(this);
  }

  report() {
    if (!this.source || !this.curve) return;
    this.panel.setResult({
      mesh: this.mesh,
      source: this.source,
      curve: this.curve,
      lacksEdgeCurve: this.state.show.edgeCurve && !this.curves.edgeCurve,
      faceCount: this.mesh.triangles.length / 3,
      edgeLength: this.mesh.edgeLength,
      times: this.times,
      state: this.state,
      defaults: this.defaults,
    });
    this.panel.setLegend(this.legendItems());
  }

  fileName(ending) {
    const mesh = this.state.sample || (this.state.file || 'mesh').replace(/\.\w+$/, '');
    return `${mesh}_${ending}`;
  }

  // for exports, for the thresholds as they are
  async curveFor(name) {
    const result = await this.engine.run('curves',
      { curves: [name === 'faceCurve' ? faceCurve : edgeCurve], parameters: this.parameters });
    return result[name];
  }

  async export(kind, format, picture) {
    if (!this.mesh || !this.curve) {
      this.panel.showMessage('There is nothing to export yet: open a mesh first.');
      return;
    }
    await this.follower.end(); // previews are not exported
    await this.attempt('Writing…', async () => {
      if (!this.isSolved) await this.solveNow();
      await exportAs(this, kind, format, picture);
    });
  }
}

function meanEdgeLength(positions, triangles) {
  let sum = 0;
  for (let f = 0; f < triangles.length; f += 3)
    for (let k = 0; k < 3; ++k) {
      const a = 3 * triangles[f + k], b = 3 * triangles[f + (k + 1) % 3];
      sum += Math.hypot(positions[a] - positions[b], positions[a + 1] - positions[b + 1], positions[a + 2] - positions[b + 2]);
    }
  return sum / triangles.length;
}
