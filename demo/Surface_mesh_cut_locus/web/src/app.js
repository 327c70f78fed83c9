// What the page does: it loads a mesh, solves for its sources, follows the sliders and cuts the surface open. It knows
// the engine, the viewer and the panel, which do not know each other.
import { overlapOf, seamsOf } from './atlas.js';
import { branchScale } from './branch_scale.js';
import { Cancelled, Engine } from './engine.js';
import { exportAs } from './exports.js';
import { History } from './history.js';
import { legendItems } from './legend_items.js';
import { explain, objectionTo } from './messages.js';
import { describeValues, nearestSegment, Readout } from './readout.js';
import { farthestFace, fileStart, samples, startCoordinates } from './samples.js';
import { defaultState, rounded } from './state.js';
import { applyTheme, onPreference, themeColors } from './theme.js';
import { guessUp } from './up_axis.js';
import { describeAtlas } from './words.js';

const stageTexts = {
  preprocessing: 'Preparing the mesh…',
  distance: 'Computing distances…',
  strength: 'Finding where shortest paths meet…',
  tree: 'Joining the branches…',
  homology: 'Closing the loops…',
  cutting: 'Cutting the surface open…',
  flattening: 'Flattening…',
};

const faceCurve = 1, edgeCurve = 0;
const restMilliseconds = 150; // a slider that has not moved for so long is at rest
const nearPixels = 9; // what a click is as near to is meant

const copy = (value) => JSON.parse(JSON.stringify(value));

export class App {
  constructor(viewer, panel, state) {
    this.viewer = viewer;
    this.panel = panel;
    this.state = state;
    this.engine = new Engine((stage) => panel.setBusyText(stageTexts[stage]));
    this.history = new History();
    this.readout = new Readout();
    this.mesh = null;
    this.curves = {};
    this.isSolved = false; // the worker has the solver and the sources of the state
    this.exactMethod = state.method; // the one that was chosen last
    this.defaults = null; // of the thresholds, for these sources
    this.linkedView = state.view; // until there is a mesh
    this.leastAngle = 0; // branches that need a smaller one are not computed yet
    this.jobs = 0;
    this.times = {};
    this.onState = () => {};
    onPreference(() => this.applyLook());
    this.applyLook();
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
      if (!(error instanceof Cancelled)) this.panel.showMessage(explain(error.message));
      return false;
    } finally {
      this.panel.setBusy(--this.jobs > 0);
    }
  }

  cancel() {
    if (!this.engine.isBusy) return;
    this.isSolved = false;
    this.engine.cancel();
    this.dropAtlas(); // it may be that of other thresholds
    this.panel.showMessage('Cancelled.', true);
  }

  openSample(name, faces, keepsSource = false) {
    const sample = samples.find((s) => s.name === name);
    if (!sample) {
      this.panel.showMessage(`There is no sample of the name “${name}”.`);
      return false;
    }
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
    let bytes;
    try {
      bytes = await file.arrayBuffer();
    } catch {
      this.panel.showMessage(`“${file.name}” cannot be read.`);
      return false;
    }
    const extension = file.name.split('.').pop().toLowerCase();
    return this.open({ bytes, extension }, { sample: null, file: file.name }, fileStart, keepsSource);
  }

  async open(recipe, names, start, keepsSource) {
    if (this.engine.isBusy) this.engine.cancel(false);
    return this.attempt('Reading the mesh…', async () => {
      const begin = performance.now();
      try {
        this.mesh = await this.engine.load(recipe);
      } catch (error) {
        // the module has dropped the mesh it had
        if (this.mesh && !(error instanceof Cancelled)) this.engine.restart();
        this.isSolved = false;
        this.panel.setSample(this.state);
        throw error;
      }
      this.times = { load: performance.now() - begin };
      this.takeMesh(names, start, keepsSource);
      const view = keepsSource ? this.linkedView : null;
      this.linkedView = null;
      if (view) this.viewer.setView(view);
      await this.solveNow();
      if (!view) this.look('best');
      const { repairs } = this.mesh;
      if (repairs) this.panel.showMessage(`Repaired to open it: ${repairs}.`, true);
    });
  }

  takeMesh(names, start, keepsSource) {
    Object.assign(this.state, names);
    this.wantedSample = this.state.sample;
    this.isSolved = false;
    const { positions, triangles, component, numbers } = this.mesh;
    const faceCount = triangles.length / 3;
    const isInMesh = (this.state.sources || []).every(({ face }) => face < faceCount);
    if (!keepsSource || !this.state.sources || !isInMesh)
      this.state.sources = [{ face: farthestFace(positions, triangles, start, component), coordinates: [...startCoordinates] }];
    if (!keepsSource) {
      // thresholds are those of another mesh
      this.state.isCut = false;
      this.state.parameters = defaultState().parameters;
      this.state.look.up = 'auto';
    }
    this.history.clear();
    this.mesh.edgeLength = numbers[3] * meanEdgeLength(positions, triangles);
    this.mesh.up = this.state.sample ? 'z' : guessUp(positions, triangles);
    this.forgetAtlas();
    this.curves = {};
    this.path = null;
    this.viewer.setMesh(positions, triangles);
    this.readout.setMesh(positions, triangles);
    this.applyLook();
    if (!keepsSource) this.viewer.resetView();
    this.panel.setState(this.state);
    this.panel.setMesh(this.state, this.mesh);
  }

  // A click, or a key: `mode` says what for.
  pick(location, mode) {
    if (!this.mesh) return null;
    if (mode === 'path') return this.showPaths(location);
    const source = { face: location.face, coordinates: location.coordinates.map(rounded) };
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

  // If that fails, all stays as it was.
  async setSources(sources) {
    const { state } = this;
    if (sources.length > 1 && state.method === 'laplacian') {
      this.panel.showMessage('This method takes one source: choose “the smooth shape” or “the polyhedron itself” for several.');
      return;
    }
    const before = state.sources;
    const wasSolved = this.isSolved;
    state.sources = sources;
    if (await this.solve() || !wasSolved || this.isSolved) return;
    state.sources = before;
    await this.solveNow().catch(() => {});
  }

  setSolver(solver, method) {
    const { state } = this;
    if (solver === 'exact') this.exactMethod = state.solver === 'exact' ? method : this.exactMethod;
    state.method = solver === 'exact' ? this.exactMethod : 'laplacian';
    state.solver = solver;
    const hadSeveral = state.method === 'laplacian' && state.sources && state.sources.length > 1;
    if (hadSeveral) state.sources = state.sources.slice(0, 1);
    this.panel.setState(state);
    return this.solve().then(() => {
      if (hadSeveral) this.panel.showMessage('This method takes one source: the first one is left.', true);
    });
  }

  async solve() {
    if (!this.mesh) return false;
    if (this.engine.isBusy) this.engine.cancel();
    this.isSolved = false;
    return this.attempt('Computing…', () => this.solveNow());
  }

  async solveNow() {
    const begin = performance.now();
    const { solver, method, sources, parameters } = this.state;
    const result = await this.engine.run('solve',
      { solver, method, sources, parameters: { ...parameters }, curves: this.wantedCurves() });
    this.isSolved = true;
    this.panel.showReadout(null); // it was that of other sources
    this.distance = result.distance;
    this.laplacian = null;
    this.gradient = null;
    this.takeSources(result.sourceNumbers);
    this.leastAngle = Math.min(this.angleFor(null), this.angleFor(parameters.width));
    this.panel.setDefaults(this.defaults, method);
    this.viewer.setDistance(this.distance);
    this.setPath(null);
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
    this.remember();
    await this.showFields();
    if (this.state.isCut) await this.cutNow();
    this.report();
  }

  takeSources(numbers) {
    const [fx, fy, fz, farthestDistance, borderLoops, genus, angle, width, gap, ...points] = numbers;
    this.source = { points: [], farthest: [fx, fy, fz], farthestDistance, borderLoops, genus };
    for (let i = 0; i < points.length; i += 3) this.source.points.push(points.slice(i, i + 3));
    this.defaults = { angle, width, gap };
    this.viewer.setSources(this.source.points.map((point) => this.toView(point)));
    this.viewer.setMarker(this.viewer.farthestMarker, this.toView(this.source.farthest));
  }

  toView(p) {
    const [x, y, z, radius] = this.mesh.numbers;
    return [(p[0] - x) / radius, (p[1] - y) / radius, (p[2] - z) / radius];
  }

  // what can be taken back
  get step() {
    const { sources, solver, method, parameters } = this.state;
    return copy({ sources, solver, method, parameters });
  }

  remember() {
    clearTimeout(this.rememberTimer);
    this.history.push(this.step);
    this.panel.setHistory(this.history);
  }

  undo() {
    this.remember();
    return this.restore(this.history.undo());
  }

  redo() {
    return this.restore(this.history.redo());
  }

  async restore(step) {
    if (!step) return;
    const now = this.step;
    Object.assign(this.state, step);
    if (step.solver === 'exact') this.exactMethod = step.method;
    this.panel.setState(this.state);
    this.panel.setHistory(this.history);
    const isSame = ['sources', 'solver', 'method'].every((name) => JSON.stringify(now[name]) === JSON.stringify(step[name]));
    if (isSame && this.isSolved) await this.updateCurves();
    else await this.solve();
    this.panel.setHistory(this.history);
  }

  wantedCurves() {
    const { show } = this.state;
    const curves = [];
    if (show.faceCurve) curves.push(faceCurve);
    if (show.edgeCurve || !show.faceCurve) curves.push(edgeCurve);
    return curves;
  }

  // The library computes branches from an angle at the source on, as its Exact_tree_solver says: for a width, in
  // percent, or for its default.
  angleFor(width) {
    if (!this.defaults || this.state.method !== 'direction') return 0;
    return width === null ? Math.max(0.5 * this.defaults.width, 0.1 * this.defaults.gap) : 0.5 * width / 100;
  }

  get needsMoreBranches() {
    return this.angleFor(this.state.parameters.width) < this.leastAngle;
  }

  // What takes longer than a frame waits for the slider to rest: smoothing, and more branches than there are.
  setParameter(name, value) {
    this.state.parameters[name] = value;
    const { method, show, parameters } = this.state;
    const smooths = method === 'laplacian' && show.faceCurve && parameters.smoothing > 0;
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
      this.cutAtRest();
    } catch (error) {
      if (!(error instanceof Cancelled)) this.panel.showMessage(explain(error.message));
    } finally {
      this.isUpdating = false;
    }
  }

  // The sheet follows the sliders when they rest.
  cutAtRest() {
    clearTimeout(this.cutTimer);
    if (!this.state.isCut) return;
    this.panel.setCutStale();
    this.cutTimer = setTimeout(() => this.attempt('Cutting the surface open…', () => this.cutNow()), 2 * restMilliseconds);
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

  liveParameters() {
    return { ...this.state.parameters, ...(this.wantsSmooth ? {} : { smoothing: 0 }) };
  }

  takeCurves(result, parameters) {
    this.drawn = { ...parameters };
    for (const name of ['edgeCurve', 'faceCurve']) if (result[name]) this.curves[name] = result[name];
    this.shownCurve = result.faceCurve ? 'faceCurve' : 'edgeCurve';
    this.drawCurves();
  }

  get curve() {
    return this.curves[this.shownCurve];
  }

  drawCurves() {
    const { show } = this.state;
    const scale = branchScale(this.state, this.defaults);
    this.panel.setScale(scale);
    for (const name of ['edgeCurve', 'faceCurve']) {
      const curve = this.curves[name];
      this.viewer[name].show(show[name], show.hidden);
      if (curve && show[name])
        this.viewer[name].set(curve.segments, show.width ? Array.from(curve[scale.quantity], scale.place) : null);
    }
    this.updateSurface();
  }

  // What is drawn on the surface itself.
  updateSurface() {
    const { show, look } = this.state;
    const { curve } = this;
    const hasDisk = show.disk && curve && Number.isFinite(curve.numbers[5]) && curve.numbers[0] > 0;
    this.viewer.setUniforms({
      showIsolines: show.isolines,
      coloring: look.color === 'laplacian' && !this.laplacian ? 'plain' : look.color,
      showDisk: Boolean(hasDisk),
      showChecker: show.checker && Boolean(this.atlas),
      radius: hasDisk ? curve.numbers[5] : 0,
      spacing: this.source ? this.source.farthestDistance / 25 : 1,
      largest: this.source ? this.source.farthestDistance || 1 : 1,
    });
    this.viewer.arrows.visible = show.gradient && Boolean(this.gradient);
    const nearest = hasDisk ? this.toView(curve.numbers.subarray(6, 9)) : null;
    this.viewer.setMarker(this.viewer.nearestMarker, nearest);
    this.hasDisk = Boolean(hasDisk);
  }

  // The Laplacian and the gradient are computed when they are first shown for a source.
  async showFields() {
    const { show, look } = this.state;
    if (!this.isSolved) return;
    if (look.color === 'laplacian' && !this.laplacian) {
      this.laplacian = await this.engine.run('laplacian');
      const sorted = Float32Array.from(this.laplacian, Math.abs).sort();
      this.laplacianScale = 2 * sorted[Math.floor(0.9 * sorted.length)] || 1;
      this.viewer.setUniforms({ laplacianScale: this.laplacianScale });
      this.viewer.setLaplacian(this.laplacian);
    }
    if (show.gradient && !this.gradient) {
      this.gradient = await this.engine.run('gradient');
      this.viewer.setArrows(this.gradient, 0.035);
    }
    this.updateSurface();
  }

  async setShown(name, value) {
    this.state.show[name] = value;
    if (name === 'faceCurve' || name === 'edgeCurve') await this.updateCurves();
    this.drawCurves();
    if (value && name === 'gradient') await this.attempt('Computing…', () => this.showFields());
    if (name === 'values') this.hover(null);
    this.viewer.invalidateCurves();
    this.report();
  }

  async setLook(name, value) {
    this.state.look[name] = value;
    this.applyLook(name);
    if (name === 'color') {
      this.updateSurface();
      if (value === 'laplacian') await this.attempt('Computing…', () => this.showFields());
    }
    if (name === 'up') this.look('best');
    this.report();
  }

  applyLook(changed) {
    const { look } = this.state;
    const { viewer } = this;
    applyTheme(look.theme);
    viewer.setTheme(themeColors());
    viewer.setUp(look.up === 'auto' ? (this.mesh ? this.mesh.up : 'z') : look.up);
    viewer.setTransparency(look.transparency);
    viewer.setUniforms({ isFlat: look.shading === 'flat' });
    viewer.setOcclusion(look.occlusion);
    viewer.hasAxes = look.axes;
    if (!changed || changed === 'wireframe') viewer.showWireframe(look.wireframe);
    if (this.curve) this.report();
  }

  look(name) {
    const { curve } = this;
    if (!this.mesh || !this.source) return;
    this.viewer.look(name, curve ? curve.segments : new Float32Array(0), this.source.points.map((p) => this.toView(p)));
    this.onState();
  }

  fit() {
    this.viewer.fit();
    this.onState();
  }

  // The shortest paths to a point; one near the curve is meant to be on it.
  async showPaths(location) {
    if (!this.isSolved || !this.curve) return;
    const nearest = nearestSegment(this.curve.segments, location.place);
    const isOnCurve = nearest && nearest.away < nearPixels * location.pixel;
    const end = (isOnCurve && this.viewer.pointer.atPlace(nearest.place)) || location;
    await this.attempt('Finding shortest paths…', async () => {
      const { points, numbers } = await this.engine.run('paths', { end: { face: end.face, coordinates: end.coordinates } });
      this.setPath({ points, numbers, end: end.place });
      if (numbers.length === 0) this.panel.showMessage('No path leads there from the source.', true);
    });
    this.report();
  }

  setPath(path) {
    this.path = path && path.numbers.length > 0 ? path : null;
    if (!this.path) {
      this.viewer.setPaths(new Float32Array(0), null);
      return;
    }
    const segments = [];
    for (let i = 0, start = 0; i < path.numbers.length; i += 2) {
      const size = path.numbers[i];
      for (let k = start; k + 1 < start + size; ++k) segments.push(...path.points.subarray(3 * k, 3 * k + 6));
      start += size;
    }
    this.viewer.setPaths(Float32Array.from(segments), path.end);
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
    Object.assign(this.state, { parameters: standard.parameters, solver: standard.solver, method: standard.method });
    this.exactMethod = standard.method;
    this.panel.setState(this.state);
    if (solver !== standard.solver || method !== standard.method) return this.solve();
    this.remember();
    return this.updateCurves();
  }

  async toggleCut() {
    if (!this.mesh || this.engine.isBusy) return;
    if (this.atlas) {
      this.dropAtlas();
      this.viewer.fit();
    } else {
      this.state.isCut = true;
      const isCut = await this.attempt('Cutting the surface open…', () => (this.isSolved ? this.cutNow() : this.solveNow()));
      if (isCut) this.viewer.fit(); // there is half of the room
      else this.dropAtlas();
    }
    this.report();
  }

  // Along the curve of mesh edges, for the thresholds as they are.
  async cutNow() {
    const begin = performance.now();
    if (this.state.sources.length > 1) {
      this.dropAtlas();
      throw new Error('The surface is flattened from one source: with several, it falls into as many sheets');
    }
    let atlas;
    try {
      atlas = await this.computeAtlas();
    } catch (error) {
      // what cancels it by a new command cuts again
      if (!(error instanceof Cancelled)) this.dropAtlas();
      throw error;
    }
    this.atlas = atlas;
    this.viewer.showCut({ ...atlas, ...seamsOf(atlas, this.mesh.positions) });
    this.panel.setCut(true, this.quality(atlas));
    this.times.cut = performance.now() - begin;
    this.drawCurves();
  }

  async computeAtlas() {
    const { edgeCurve: curve, ...atlas } =
      await this.engine.run('cut', { parameters: { ...this.state.parameters } });
    this.curves.edgeCurve = curve;
    atlas.overlap = this.overlapOf(atlas);
    atlas.step = JSON.stringify(this.step);
    return atlas;
  }

  overlapOf(atlas) {
    return overlapOf(atlas, this.viewer.renderer);
  }

  quality({ numbers, triangles, overlap }) {
    return describeAtlas(numbers, triangles.length / 3, overlap);
  }

  forgetAtlas() {
    clearTimeout(this.cutTimer);
    this.atlas = null;
    this.panel.setCut(false);
  }

  dropAtlas() {
    this.state.isCut = false;
    if (!this.atlas) return;
    this.forgetAtlas();
    this.viewer.showUncut();
    this.updateSurface();
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
      faceCount: this.mesh.triangles.length / 3,
      edgeLength: this.mesh.edgeLength,
      times: this.times,
      state: this.state,
      defaults: this.defaults,
    });
    this.panel.setLegend(this.legendItems());
    this.onState();
  }

  fileName(ending) {
    const mesh = this.state.sample || (this.state.file || 'mesh').replace(/\.\w+$/, '');
    return `${mesh}_${ending}`;
  }

  // for exports, for the thresholds as they are
  async curveFor(name) {
    const result = await this.engine.run('curves',
      { curves: [name === 'faceCurve' ? faceCurve : edgeCurve], parameters: { ...this.state.parameters } });
    return result[name];
  }

  async atlasFor() {
    if (this.state.sources.length > 1)
      throw new Error('The surface is cut open from one source: with several, it falls into as many sheets');
    return this.atlas && this.atlas.step === JSON.stringify(this.step) ? this.atlas : this.computeAtlas();
  }

  async export(kind, format, picture) {
    if (!this.mesh || !this.curve) {
      this.panel.showMessage('There is nothing to export yet: open a mesh first.');
      return;
    }
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
