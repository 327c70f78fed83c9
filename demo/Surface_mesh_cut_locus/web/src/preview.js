// Previews of the curve while a source moves: on a simplified mesh, in a worker of its own, so that what is exported, taken
// back or goes on to be worked with is always that of the mesh. The simplified mesh is made when the page has nothing else to
// do, and is as large as this computer computes in time.
import { Canceled, Engine } from './engine.js';
import { coarse } from './words.js';

// For each preview: thirty pictures in a second look like motion, and drawing needs half of the time.
const budget = 1000 / 30 / 2; // milliseconds
const growth = 1.5; // times grow like this power of the number of faces, at most; they are measured in the end
const leastStep = 0.9; // with more of the faces left, it is not worth another try
const idleMilliseconds = 300; // nothing has been done for so long
const measurements = 5; // of which the least counts: code is compiled while it runs
const relativeError = 1e-3; // of distances: as the manual has it for a source that moves

export class Preview {
  constructor(app) {
    this.app = app;
    this.engine = null;
    this.forget();
  }

  // another mesh
  forget() {
    clearTimeout(this.timer);
    if (this.engine && this.engine.isBusy) this.engine.cancel(false);
    this.key = null; // of what it is made for, or cannot be made for
    this.faces = 0; // of the simplified mesh, if there is one
    this.isSettled = false;
  }

  get wanted() {
    const { solver, method, border } = this.app.state;
    return `${solver} ${method} ${border}`;
  }

  get isReady() {
    return this.faces > 0 && this.key === this.wanted;
  }

  // What a source takes on the whole mesh says how much smaller the mesh has to be.
  schedule(milliseconds) {
    if (this.key === this.wanted) return;
    this.isSettled = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (this.app.engine.isBusy || this.app.follower.isActive || document.hidden) this.schedule(milliseconds);
      else this.settle(milliseconds);
    }, idleMilliseconds);
  }

  async settle(milliseconds) {
    if (this.engine && this.engine.isBusy) this.engine.cancel(false);
    const key = this.wanted;
    this.key = key;
    this.faces = 0;
    try {
      const faces = milliseconds > budget && this.app.state.border !== 'only' ? await this.simplify(milliseconds) : 0;
      if (this.key !== key) return;
      this.faces = faces;
    } catch (error) {
      // replaced by another one; or a mesh that cannot be simplified: sources move on the whole one
      if (error instanceof Canceled || this.key !== key) return;
    }
    this.isSettled = true;
  }

  // From above, as what has been measured at first is the less sure. Returns the number of faces, 0 if there is no gain.
  async simplify(milliseconds) {
    const { positions, triangles, component, numbers } = this.app.mesh;
    const sources = this.app.state.sources;
    this.engine ||= new Engine(() => {}, () => {});
    await this.engine.run('takeMesh', { positions, triangles, component, unit: numbers[3] });
    let faces = triangles.length / 3, time = milliseconds;
    for (let slack = 2; time > budget; slack = 1) {
      const wanted = Math.max(Math.floor(slack * faces * (budget / time) ** (1 / growth)), coarse);
      if (wanted > leastStep * faces) break;
      const before = faces;
      ({ faces } = await this.engine.run('simplify', { faces: wanted }));
      time = await this.measure(sources);
      if (faces > leastStep * before) break;
    }
    this.milliseconds = time;
    return time < milliseconds / 2 ? faces : 0;
  }

  async measure(sources) {
    let least = Infinity;
    for (let i = 0; i < measurements; ++i)
      least = Math.min(least, (await this.compute(sources, true)).milliseconds);
    return least;
  }

  // On the simplified mesh, drawn on the whole one; `wantsValues`: distances at its vertices as well.
  async compute(sources, wantsValues) {
    const { app } = this;
    const { solver, method, border } = app.state;
    const { width } = app.parameters;
    // never finer than what is shown of the whole mesh
    const finest = width === null && app.defaults && app.defaults.width > 0 ? 100 * app.defaults.width : width;
    try {
      return await this.engine.run('preview', {
        solver, method, sources, border: border !== 'no', curve: app.wantedCurves()[0],
        parameters: { ...app.parameters, width: finest, smoothing: 0 }, relativeError, wantsValues,
      });
    } catch (error) {
      if (error.fatal) this.faces = 0; // the worker has been started again, without the mesh
      throw error;
    }
  }
}
