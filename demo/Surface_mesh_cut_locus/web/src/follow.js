// The source follows the pointer while a key or a button is held: with a bounded error while it moves, exactly when it
// stops.
import { Cancelled } from './engine.js';
import { rounded } from './state.js';

// of distances: as the manual has it for a source that moves
const relativeError = 1e-3;

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
    this.sources = null;
    this.app.viewer.setMoving(true);
    return true;
  }

  // `locate` gives the place of the surface, or null; while the worker computes, only the last one is remembered.
  move(locate) {
    if (!this.isActive) return;
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
      try {
        await this.app.previewSources(sources, relativeError);
        this.sources = sources;
        this.countFrame();
      } catch (error) {
        if (error instanceof Cancelled) this.isActive = false;
        // otherwise there can be no source here, as beside another one: it stays where it was
      }
    }
  }

  // `updates` counts frames, not what has been computed
  countFrame() {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = null;
      ++this.updates;
    });
  }

  async end() {
    await this.running;
    this.app.viewer.setMoving(false);
    const { isActive, sources } = this;
    this.isActive = false;
    if (isActive && sources) await this.app.setSources(sources);
    else if (isActive && !this.app.isSolved) await this.app.solve();
  }
}
