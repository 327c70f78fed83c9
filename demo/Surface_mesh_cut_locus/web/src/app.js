// What the page does: it loads a mesh, solves for a source, follows the sliders and cuts the surface open. It knows
// the engine, the viewer and the panel, which do not know each other.
import { describeAtlas, seamsOf } from './atlas.js';
import { branchScale } from './branch_scale.js';
import { Cancelled, Engine } from './engine.js';
import { atlasToObj, download, meshToPly } from './exporters.js';
import { explain, objectionTo } from './messages.js';
import { farthestFace, fileStart, samples, startCoordinates } from './samples.js';
import { defaultState, rounded } from './state.js';

const stageTexts = {
  preprocessing: 'Preparing the mesh…',
  distance: 'Computing distances…',
  strength: 'Finding where shortest paths meet…',
  tree: 'Joining the branches…',
  homology: 'Closing the cycles…',
  cutting: 'Cutting the surface open…',
  flattening: 'Flattening…',
};

const faceCurve = 1, edgeCurve = 0;
const restMilliseconds = 150; // a slider that has not moved for so long is at rest

export class App {
  constructor(viewer, panel, state) {
    this.viewer = viewer;
    this.panel = panel;
    this.state = state;
    this.engine = new Engine((stage) => panel.setBusyText(stageTexts[stage]));
    this.mesh = null;
    this.curves = {};
    this.isSolved = false; // the worker has the solver and the source of the state
    this.exactMethod = state.method; // the one that was chosen last
    this.defaults = null; // of the thresholds, for this source
    this.leastAngle = 0; // branches that need a smaller one are not computed yet
    this.jobs = 0;
    this.times = {};
    this.onState = () => {};
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
      Object.assign(this.state, names);
      this.wantedSample = this.state.sample;
      this.isSolved = false;
      const { positions, triangles } = this.mesh;
      const faceCount = triangles.length / 3;
      if (!keepsSource || !this.state.source || this.state.source.face >= faceCount)
        this.state.source = { face: farthestFace(positions, triangles, start), coordinates: [...startCoordinates] };
      if (!keepsSource) {
        this.state.isCut = false;
        this.viewer.resetView();
      }
      this.atlas = null;
      this.panel.setCut(false);
      this.curves = {};
      this.viewer.setMesh(positions, triangles);
      this.panel.setMesh(this.state, this.mesh);
      await this.solveNow();
    });
  }

  setSource({ face, coordinates }) {
    // as a link will have it
    this.state.source = { face, coordinates: coordinates.map(rounded) };
    return this.solve();
  }

  setSolver(solver, method) {
    if (solver === 'exact') this.exactMethod = this.state.solver === 'exact' ? method : this.exactMethod;
    this.state.method = solver === 'exact' ? this.exactMethod : 'laplacian';
    this.state.solver = solver;
    this.panel.setState(this.state);
    return this.solve();
  }

  async solve() {
    if (!this.mesh) return;
    if (this.engine.isBusy) this.engine.cancel();
    this.isSolved = false;
    await this.attempt('Computing…', () => this.solveNow());
  }

  async solveNow() {
    const begin = performance.now();
    const { solver, method, source, parameters } = this.state;
    const result = await this.engine.run('solve',
      { solver, method, source, parameters: { ...parameters }, curves: this.wantedCurves() });
    this.isSolved = true;
    this.distance = result.distance;
    this.laplacian = null;
    this.gradient = null;
    const [sx, sy, sz, fx, fy, fz, farthestDistance, borderLoops, genus, angle, width, gap] = result.sourceNumbers;
    this.source = { point: [sx, sy, sz], farthest: [fx, fy, fz], farthestDistance, borderLoops, genus };
    this.defaults = { angle, width, gap };
    this.leastAngle = Math.min(this.angleFor(null), this.angleFor(parameters.width));
    this.panel.setDefaults(this.defaults, method);
    this.viewer.setDistance(this.distance);
    this.viewer.setMarker(this.viewer.sourceMarker, this.toView(this.source.point));
    this.viewer.setMarker(this.viewer.farthestMarker, this.toView(this.source.farthest));
    const { isCut } = this.state;
    this.dropAtlas();
    this.takeCurves(result, parameters);
    this.viewer.draw();
    Object.assign(this.times, {
      source: performance.now() - begin,
      solve: result.solveMilliseconds,
      stages: result.stages,
      threshold: null,
      smoothing: null,
      cut: null,
    });
    await this.showFields();
    this.state.isCut = isCut;
    if (isCut) await this.cutNow();
    this.report();
  }

  toView(p) {
    const [x, y, z, radius] = this.mesh.numbers;
    return [(p[0] - x) / radius, (p[1] - y) / radius, (p[2] - z) / radius];
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
    this.panel.setScale(this.state, this.defaults);
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
        this.dropAtlas();
        this.takeCurves(result, parameters);
        this.viewer.draw();
        this.times[this.wantsSmooth && this.state.method === 'laplacian' ? 'smoothing' : 'threshold'] = { shown: performance.now() - begin, computed: result.milliseconds };
        this.panel.hideMessage();
        this.report();
      } while (this.wantsUpdate);
    } catch (error) {
      if (!(error instanceof Cancelled)) this.panel.showMessage(explain(error.message));
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

  liveParameters() {
    return { ...this.state.parameters, ...(this.wantsSmooth ? {} : { smoothing: 0 }) };
  }

  takeCurves(result, parameters) {
    this.drawn = { ...parameters };
    for (const name of ['edgeCurve', 'faceCurve']) if (result[name]) this.curves[name] = result[name];
    this.shownCurve = result.faceCurve ? 'faceCurve' : 'edgeCurve';
    this.drawCurves();
  }

  drawCurves() {
    const { show } = this.state;
    const scale = branchScale(this.state, this.defaults);
    this.panel.setScale(this.state, this.defaults);
    for (const name of ['edgeCurve', 'faceCurve']) {
      const curve = this.curves[name];
      this.viewer[name].show(show[name], show.hidden);
      if (curve && show[name])
        this.viewer[name].set(curve.segments, show.width ? Array.from(curve[scale.quantity], scale.place) : null);
    }
    this.updateDisk();
  }

  updateDisk() {
    const { show } = this.state;
    const curve = this.curves[this.shownCurve];
    const hasDisk = show.disk && curve && Number.isFinite(curve.numbers[5]);
    this.viewer.setUniforms({
      showIsolines: show.isolines,
      showLaplacian: show.laplacian && Boolean(this.laplacian),
      showDisk: Boolean(hasDisk),
      showChecker: show.checker && Boolean(this.atlas),
      radius: hasDisk ? curve.numbers[5] : 0,
      spacing: this.source ? this.source.farthestDistance / 25 : 1,
    });
    this.viewer.arrows.visible = show.gradient && Boolean(this.gradient);
    const nearest = hasDisk && curve.numbers.length > 6 ? this.toView(curve.numbers.subarray(6, 9)) : null;
    this.viewer.setMarker(this.viewer.nearestMarker, nearest);
    this.panel.showNearest(nearest !== null);
  }

  // The Laplacian and the gradient are computed when they are first shown for a source.
  async showFields() {
    const { show } = this.state;
    if (!this.isSolved) return;
    if (show.laplacian && !this.laplacian) {
      this.laplacian = await this.engine.run('laplacian');
      const sorted = Float32Array.from(this.laplacian, Math.abs).sort();
      this.viewer.setUniforms({ laplacianScale: 2 * sorted[Math.floor(0.9 * sorted.length)] || 1 });
      this.viewer.setLaplacian(this.laplacian);
    }
    if (show.gradient && !this.gradient) {
      this.gradient = await this.engine.run('gradient');
      this.viewer.setArrows(this.gradient, 0.035);
    }
    this.updateDisk();
  }

  async setShown(name, value) {
    this.state.show[name] = value;
    const missing = (name === 'faceCurve' || name === 'edgeCurve') && this.wantedCurves().length > 0;
    if (missing) await this.updateCurves();
    this.drawCurves();
    if (value && (name === 'laplacian' || name === 'gradient'))
      await this.attempt('Computing…', () => this.showFields());
    this.viewer.invalidateCurves();
    this.report();
  }

  resetParameters() {
    this.state.parameters = defaultState().parameters;
    this.panel.setState(this.state);
    return this.updateCurves();
  }

  async toggleCut() {
    if (!this.mesh || this.engine.isBusy) return;
    this.state.isCut = !this.atlas;
    if (this.atlas) {
      this.dropAtlas();
    } else if (!await this.attempt('Cutting the surface open…', () => (this.isSolved ? this.cutNow() : this.solveNow()))) {
      this.state.isCut = false;
    }
    this.report();
  }

  // Along the curve of mesh edges, for the thresholds as they are.
  async cutNow() {
    const begin = performance.now();
    const { edgeCurve: curve, ...atlas } =
      await this.engine.run('cut', { parameters: { ...this.state.parameters } });
    this.curves.edgeCurve = curve;
    this.atlas = atlas;
    this.viewer.showCut({ ...atlas, ...seamsOf(atlas, this.mesh.positions) });
    this.panel.setCut(true, describeAtlas(atlas.numbers, atlas.triangles.length / 3));
    this.times.cut = performance.now() - begin;
    this.drawCurves();
  }

  // A cut belongs to the curve that it followed.
  dropAtlas() {
    if (!this.atlas) return;
    this.atlas = null;
    this.state.isCut = false;
    this.viewer.showUncut();
    this.panel.setCut(false);
    this.updateDisk();
  }

  report() {
    this.panel.setResult({
      mesh: this.mesh,
      source: this.source,
      curve: this.curves[this.shownCurve],
      times: this.times,
      method: this.state.method,
    });
    this.onState();
  }

  fileName(ending) {
    const mesh = this.state.sample || (this.state.file || 'mesh').replace(/\.\w+$/, '');
    return `${mesh}_${ending}`;
  }

  async export(kind) {
    if (kind === 'png') {
      download(await this.viewer.toPng(), this.fileName('cut_locus.png'));
      return;
    }
    if (!this.mesh || !this.curves[this.shownCurve]) {
      this.panel.showMessage('There is nothing to export yet: open a mesh first.');
      return;
    }
    if (kind === 'mesh-ply') {
      download(meshToPly(this.mesh, this.distance), this.fileName('distance.ply'));
    } else if (kind === 'atlas-obj') {
      if (!this.atlas) {
        this.panel.showMessage('Cut the surface open first: the button is “Cut and flatten”.');
        return;
      }
      download(atlasToObj(this.mesh, this.atlas), this.fileName('cut.obj'));
    } else {
      const format = kind.replace('polylines-', '');
      await this.attempt('Writing…', async () => {
        const text = await this.engine.run('write',
          { curve: this.shownCurve === 'faceCurve' ? faceCurve : edgeCurve, format });
        download(text, this.fileName(format === 'txt' ? 'cut_locus.polylines.txt' : `cut_locus.${format}`));
      });
    }
  }
}
