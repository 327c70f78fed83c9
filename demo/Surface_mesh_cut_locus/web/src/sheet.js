// The surface cut open and flattened, which follows the thresholds and the source.
import { seamsOf } from './atlas.js';
import { Cancelled } from './engine.js';
import { describeAtlas } from './words.js';

const restMilliseconds = 300; // a slider that has not moved for so long is at rest

export class Sheet {
  constructor(app) {
    this.app = app;
    this.atlas = null;
  }

  async toggle() {
    if (!this.app.mesh || this.app.engine.isBusy) return;
    if (this.atlas) {
      this.drop();
      this.app.viewer.fit();
    } else {
      this.app.state.isCut = true;
      const isCut = await this.app.attempt('Cutting the surface open…', () => (this.app.isSolved ? this.cut() : this.app.solveNow()));
      if (isCut) this.app.viewer.fit(); // there is half of the room
      else this.drop();
    }
    this.app.report();
  }

  // The sheet follows the sliders when they rest.
  cutAtRest() {
    clearTimeout(this.cutTimer);
    if (!this.app.state.isCut) return;
    this.app.panel.setCutStale();
    this.cutTimer = setTimeout(() => this.app.attempt('Cutting the surface open…', () => this.cut()), restMilliseconds);
  }

  // Along the curve of mesh edges, for the thresholds as they are.
  async cut() {
    const begin = performance.now();
    let atlas;
    try {
      atlas = await this.compute();
    } catch (error) {
      // what cancels it by a new command cuts again
      if (!(error instanceof Cancelled)) this.drop();
      throw error;
    }
    this.atlas = atlas;
    this.app.viewer.showCut({ ...atlas, ...seamsOf(atlas, this.app.mesh.positions) });
    this.app.panel.setCut(true, this.quality(atlas));
    this.app.times.cut = performance.now() - begin;
    this.app.appearance.drawCurves();
  }

  async compute() {
    if (this.app.state.border !== 'no')
      throw new Error('The surface is cut open from points: let the border be no source');
    const { edgeCurve: curve, ...atlas } =
      await this.app.engine.run('cut', { parameters: this.app.parameters });
    this.app.curves.edgeCurve = curve;
    atlas.step = JSON.stringify(this.app.step);
    return atlas;
  }

  quality({ numbers, triangles }) {
    return describeAtlas(numbers, triangles.length / 3);
  }

  async current() {
    return this.atlas && this.atlas.step === JSON.stringify(this.app.step) ? this.atlas : this.compute();
  }

  forget() {
    clearTimeout(this.cutTimer);
    this.atlas = null;
    this.app.panel.setCut(false);
  }

  drop() {
    this.app.state.isCut = false;
    if (!this.atlas) return;
    this.forget();
    this.app.viewer.showUncut();
    this.app.appearance.updateSurface();
  }
}
