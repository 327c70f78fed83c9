// What can be exported, in which formats, and how. None of it depends on what is shown: what is missing is computed.
import { cutOpen, download, uncut, writers } from './exporters.js';
import { takePicture } from './picture.js';
import { curveToSvg, outlineToSvg } from './svg.js';

const curveFormats = { obj: 'OBJ lines', ply: 'PLY', vtp: 'VTP (ParaView)', txt: 'CGAL polylines', svg: 'SVG, as seen' };
const surfaceFormats = { obj: 'OBJ', ply: 'PLY', vtp: 'VTP (ParaView)', glb: 'glTF, binary' };

// `stem` begins the names of files, which tell what is in them.
export const kinds = {
  faceCurve: { stem: 'cut_locus', label: 'Cut locus', formats: curveFormats, note: 'Through the faces of the mesh. PLY and VTP have the width of each branch.' },
  edgeCurve: { stem: 'cut_locus_along_edges', label: 'Cut locus along mesh edges', formats: curveFormats, note: 'Edges of the mesh only. PLY and VTP have the width of each branch.' },
  surface: { stem: 'distance', label: 'Surface', formats: surfaceFormats, note: 'With the distance at each vertex (not in OBJ), or -1 where no path leads.' },
  cut: { stem: 'cut_open', label: 'Surface, cut open', formats: { ...surfaceFormats, svg: 'SVG, outline' },
    note: 'With texture coordinates. It is cut for that, also if it is shown closed; faces that the curve crosses are split, '
      + 'unless only the one along mesh edges is shown.' },
  picture: { stem: 'picture', label: 'Picture', formats: { png: 'PNG' }, note: '' },
};

const nameOf = (app, kind, format) => app.fileName(`${kinds[kind].stem}.${format === 'txt' ? 'polylines.txt' : format}`);

async function writeCurve(app, kind, format) {
  const curve = await app.curveFor(kind);
  if (format !== 'svg') return app.engine.run('write', { curve: kind === 'faceCurve' ? 1 : 0, format });
  const sources = { points: app.source.points.map((point) => app.toView(point)), lines: app.source.border };
  return curveToSvg(app.viewer, curve.segments, sources, app.viewer.colors);
}

async function writeCut(app, format) {
  const atlas = await app.sheet.current();
  return format === 'svg' ? outlineToSvg(atlas, app.viewer.colors) : writers[format](cutOpen(app.mesh, atlas, app.distance));
}

function write(app, kind, format, picture) {
  if (kind === 'picture') return takePicture(app.viewer, { ...picture, legend: picture.hasLegend ? app.legendItems() : null });
  if (kind === 'surface') return writers[format](uncut(app.mesh, app.distance));
  return kind === 'cut' ? writeCut(app, format) : writeCurve(app, kind, format);
}

export async function exportAs(app, kind, format, picture) {
  const content = await write(app, kind, format, picture);
  download(content, nameOf(app, kind, format), format === 'svg' ? 'image/svg+xml' : undefined);
}
