// The shortest paths to a point that has been picked.
import { nearestSegment } from './readout.js';

const nearPixels = 9; // what a click is as near to is meant

export class PathTool {
  constructor(app) {
    this.app = app;
    this.path = null; // the points of all of them, and for each how many it has, and its length
  }

  // A point near the curve is meant to be on it.
  async show(location) {
    if (!this.app.isSolved || !this.app.curve) return;
    if (this.app.source.hasBorder) {
      this.app.panel.showMessage('Shortest paths are shown to points only: let the border be no source.', { isPlain: true });
      return;
    }
    const nearest = nearestSegment(this.app.curve.segments, location.place);
    const isOnCurve = nearest && nearest.away < nearPixels * location.pixel;
    const end = (isOnCurve && this.app.viewer.pointer.atPlace(nearest.place)) || location;
    await this.app.attempt('Finding shortest paths…', async () => {
      const { points, numbers } = await this.app.engine.run('paths', { end: { face: end.face, coordinates: end.coordinates } });
      this.set({ points, numbers, end: end.place });
      if (numbers.length === 0) this.app.panel.showMessage('No path leads there from the source.', { isPlain: true });
    });
    this.app.report();
  }

  set(path) {
    this.path = path && path.numbers.length > 0 ? path : null;
    if (!this.path) {
      this.app.viewer.setPaths(new Float32Array(0), null);
      return;
    }
    const segments = [];
    for (let i = 0, start = 0; i < path.numbers.length; i += 2) {
      const size = path.numbers[i];
      for (let k = start; k + 1 < start + size; ++k) segments.push(...path.points.subarray(3 * k, 3 * k + 6));
      start += size;
    }
    this.app.viewer.setPaths(Float32Array.from(segments), path.end);
  }
}
