// The surface cut open and flattened, which follows the thresholds and the source.
import { curveNames } from './arrays.js';
import { seamsOf } from './atlas.js';
import { colorsOfSheets } from './cell_colors.js';
import { Canceled } from './engine.js';
import { sheetsOf } from './sheets.js';
import { describeAtlas, isOnePoint } from './words.js';

const restMilliseconds = 300; // a slider that has not moved for so long is at rest

export class Sheet {
  constructor(app) {
    this.app = app;
    this.atlas = null; // that is shown
    this.computed = null; // the last one, also if it was computed to be exported
  }

  // Also while the worker has something else to do: what is asked for last counts.
  async toggle() {
    if (!this.app.mesh) return;
    let hasChanged = true;
    if (this.app.state.isCut) {
      this.drop();
      hasChanged = await this.app.attempt('Computing…', () => this.app.appearance.showFields());
    } else {
      this.app.store.set({ isCut: true });
      hasChanged = await this.app.attempt('Cutting the surface open…', () => (this.app.isSolved ? this.cut() : this.app.solveNow()));
      if (!hasChanged) this.drop();
    }
    this.app.report();
    if (hasChanged) this.app.viewer.fit(); // there is half of the room, or all, and another legend
  }

  // The sheet follows the sliders when they rest.
  cutAtRest() {
    clearTimeout(this.cutTimer);
    if (!this.app.state.isCut) return;
    this.app.panel.setCutStale();
    this.cutTimer = setTimeout(() => this.app.attempt('Cutting the surface open…', () => this.cut()), restMilliseconds);
  }

  // The logarithmic map is that of one point.
  get parameterization() {
    return this.app.source && isOnePoint(this.app.source) ? this.app.state.parameterization : 'injective';
  }

  setParameterization(name) {
    this.app.store.set({ parameterization: name });
    if (!this.app.state.isCut) return;
    this.app.attempt('Cutting the surface open…', () => (this.app.isSolved ? this.cut() : this.app.solveNow()));
  }

  // The curve that is shown: through the faces, which are split for that, unless only the one of mesh edges is. Where shortest
  // paths cross the seams, directions would be those of others.
  get seam() {
    const { state } = this.app;
    const isOfEdges = state.show.edgeCurve && !state.show.faceCurve && this.parameterization === 'injective';
    const index = isOfEdges ? 0 : 1;
    return { index, name: curveNames[index] };
  }

  // what the sheet depends on
  get step() {
    return JSON.stringify([this.app.step, this.seam.index, this.parameterization]);
  }

  // Along the curve that is shown, for the thresholds as they are.
  async cut() {
    const begin = performance.now();
    let atlas;
    try {
      atlas = await this.current();
    } catch (error) {
      // what cancels it by a new command cuts again
      if (!(error instanceof Canceled)) this.drop();
      throw error;
    }
    if (!this.app.state.isCut) return; // it has been closed meanwhile
    this.atlas = atlas;
    const isNew = !this.app.viewer.hasAtlas;
    this.app.cellColors.step = null;
    const colors = this.app.source.total > 1 ? colorsOfSheets(atlas.sheets, atlas.uv.length / 2) : null;
    this.app.viewer.showCut({ ...atlas, ...seamsOf(atlas, this.app.mesh.positions), colors });
    this.app.panel.setCut(true, this.quality(atlas));
    if (isNew) this.app.viewer.fitPlane(); // beside what is told about it
    this.app.times.cut = performance.now() - begin;
    this.app.appearance.drawCurves();
  }

  async compute() {
    const { name, index } = this.seam;
    const { step, parameterization } = this;
    const { curve, ...atlas } = await this.app.engine.run('cut', { parameters: this.app.parameters, curve: index, parameterization });
    this.app.curves[name] = curve;
    Object.assign(atlas, { step, parameterization });
    const { mesh, state, source } = this.app;
    atlas.sheets = sheetsOf(atlas, mesh, state.border === 'only' ? [] : state.sources, source.nearest);
    this.computed = atlas;
    return atlas;
  }

  quality({ numbers, triangles, parameterization }) {
    return describeAtlas(numbers, triangles.length / 3, parameterization);
  }

  async current() {
    return this.computed && this.computed.step === this.step ? this.computed : this.compute();
  }

  // another mesh
  forget() {
    this.computed = null;
    this.close();
  }

  close() {
    clearTimeout(this.cutTimer);
    this.atlas = null;
    this.app.panel.setCut(false);
  }

  drop() {
    this.app.store.set({ isCut: false });
    if (!this.atlas) return;
    this.close();
    this.app.viewer.showUncut();
    this.app.appearance.updateSurface();
  }
}
