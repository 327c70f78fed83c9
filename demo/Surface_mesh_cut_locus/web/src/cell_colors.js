// The colors of the nearest of several sources: exactly along the curve between them. The surface is divided there when all
// rests; until then, vertices have the color of the source that is nearest to them.
import { cellColor } from './color_maps.js';

const restMilliseconds = 300; // a slider that has not moved for so long is at rest

// of each vertex, three numbers
export function colorsOf(sources) {
  const colors = new Float32Array(3 * sources.length);
  sources.forEach((source, v) => colors.set(cellColor(source), 3 * v));
  return colors;
}

// Of a sheet for each cell: all of it has the color of its source.
export function colorsOfSheets(sheets, vertexCount) {
  const sources = new Uint32Array(vertexCount);
  for (const { source, vertices } of sheets) for (const v of vertices) sources[v] = source;
  return colorsOf(sources);
}

export class CellColors {
  constructor(app) {
    this.app = app;
    this.step = null; // what the surface is divided for
  }

  get isWanted() {
    const { state, source, isSolved, atlas } = this.app;
    return isSolved && state.look.color === 'cells' && source.total > 1 && !state.isCut && !atlas;
  }

  // Other sources, or another mesh.
  forget() {
    clearTimeout(this.timer);
    if (this.step !== null && !this.app.atlas) this.app.viewer.showUncut();
    this.step = null;
  }

  async show() {
    const { step } = this.app.sheet;
    if (!this.isWanted || this.step === step) return;
    const { index } = this.app.sheet.seam;
    const { source, ...cells } = await this.app.engine.run('cells', { parameters: this.app.parameters, curve: index });
    if (!this.isWanted || this.app.sheet.step !== step) return;
    this.step = step;
    this.app.viewer.showCells({ ...cells, colors: colorsOf(source) });
    this.app.appearance.updateSurface();
  }

  showAtRest() {
    clearTimeout(this.timer);
    if (this.isWanted) this.timer = setTimeout(() => this.app.attempt('Computing…', () => this.show()), restMilliseconds);
  }
}
