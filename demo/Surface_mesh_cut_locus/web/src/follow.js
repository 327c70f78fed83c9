// The source follows the pointer while a key or a button is held: by previews while it moves, on a simplified mesh if there
// is one, otherwise with a bounded error; exactly when it rests or is let go.
import { Canceled } from './engine.js';
import { rounded } from './state.js';

// of distances: as the manual has it for a source that moves
const relativeError = 1e-3;
const restMilliseconds = 150; // a pointer that has not moved for so long rests

export class Follower {
  constructor(app) {
    this.app = app;
    this.isActive = false;
    this.updates = 0; // in all, for the times
  }

  // `index` says which of the sources moves; without it, it is the last one.
  start(index) {
    const { state } = this.app;
    if (this.isActive || !this.app.isSolved || !state.sources || state.border === 'only') return false;
    this.isActive = true;
    this.index = index ?? state.sources.length - 1;
    this.sources = null; // of the last preview, if nothing exact has replaced it
    this.hasStep = false; // in the history
    this.app.viewer.setMoving(true);
    return true;
  }

  // `locate` gives the place of the surface, or null; while the worker computes, only the last one is remembered.
  move(locate) {
    if (!this.isActive) return;
    clearTimeout(this.restTimer);
    this.locate = locate;
    this.running ||= this.run().finally(() => { this.running = null; });
  }

  // The worker computes while the page draws what it has computed last.
  async run() {
    while (this.locate) {
      const location = this.locate();
      this.locate = null;
      if (!location) continue;
      const source = { face: location.face, coordinates: location.coordinates.map(rounded) };
      const sources = this.app.state.sources.map((s, i) => (i === this.index ? source : s));
      if (!this.app.preview.isReady) await this.exact; // which takes the same worker
      try {
        this.leavesRest = await this.app.previewSources(sources, relativeError);
        this.sources = sources;
        this.countFrame();
      } catch (error) {
        if (error instanceof Canceled) this.stop();
        // otherwise there can be no source here, as beside another one: it stays where it was
      }
    }
    // flattening takes too long to begin at each rest
    if (this.leavesRest && this.sources && this.isActive && !this.app.state.isCut)
      this.restTimer = setTimeout(() => { this.exact ||= this.replace().finally(() => { this.exact = null; }); }, restMilliseconds);
  }

  // The exact curve comes in the place of the preview. All rests on the way are one step to take back.
  async replace() {
    const { sources, hasStep } = this;
    if (!sources) return;
    this.sources = null;
    this.hasStep = true;
    await this.app.setSources(sources, this.app.state.border, hasStep);
  }

  // `updates` counts frames, not what has been computed
  countFrame() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = null;
      ++this.updates;
    });
  }

  stop() {
    clearTimeout(this.restTimer);
    this.isActive = false;
    this.app.viewer.setMoving(false);
  }

  async end() {
    if (!this.isActive) return;
    clearTimeout(this.restTimer);
    await this.running;
    await this.exact;
    if (!this.isActive) return; // ended twice
    this.stop();
    if (this.sources) await this.replace();
    else if (!this.app.isSolved) await this.app.solve();
  }
}
