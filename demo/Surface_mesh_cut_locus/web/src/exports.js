// What can be exported, in which formats, and how. None of it depends on what is shown: what is missing is computed.
import { cutOpen, download, uncut, writers } from './exporters.js';
import { takePicture } from './picture.js';
import { curveToSvg, outlineToSvg } from './svg.js';

const curveFormats = { obj: 'OBJ lines', ply: 'PLY', vtp: 'VTP (ParaView)', txt: 'CGAL polylines', svg: 'SVG, as seen' };
const surfaceFormats = { obj: 'OBJ', ply: 'PLY', vtp: 'VTP (ParaView)', glb: 'glTF, binary' };

export const kinds = {
  faceCurve: { label: 'Cut locus', formats: curveFormats, note: 'Through the faces of the mesh.' },
  edgeCurve: { label: 'Cut locus along mesh edges', formats: curveFormats, note: 'Edges of the mesh only.' },
  surface: { label: 'Surface', formats: surfaceFormats, note: 'With the distance at each vertex (not in OBJ).' },
  cut: { label: 'Surface, cut open', formats: { ...surfaceFormats, svg: 'SVG, outline' },
    note: 'With texture coordinates. It is cut for that, also if it is shown closed; faces that the curve crosses are split, '
      + 'unless only the one along mesh edges is shown.' },
  picture: { label: 'Picture', formats: { png: 'PNG' }, note: '' },
};

async function exportCurve(app, kind, format) {
  const curve = await app.curveFor(kind);
  if (format === 'svg') {
    const sources = { points: app.source.points.map((point) => app.toView(point)), lines: app.source.border };
    return download(curveToSvg(app.viewer, curve.segments, sources, app.viewer.colors), app.fileName('cut_locus.svg'), 'image/svg+xml');
  }
  const text = await app.engine.run('write', { curve: kind === 'faceCurve' ? 1 : 0, format });
  return download(text, app.fileName(format === 'txt' ? 'cut_locus.polylines.txt' : `cut_locus.${format}`));
}

async function exportCut(app, format) {
  const atlas = await app.sheet.current();
  if (format === 'svg')
    return download(outlineToSvg(atlas, app.viewer.colors), app.fileName('cut.svg'), 'image/svg+xml');
  return download(await writers[format](cutOpen(app.mesh, atlas, app.distance)), app.fileName(`cut.${format}`));
}

export async function exportAs(app, kind, format, picture) {
  if (kind === 'picture') {
    const blob = await takePicture(app.viewer, { ...picture, legend: picture.hasLegend ? app.legendItems() : null });
    download(blob, app.fileName('cut_locus.png'));
  } else if (kind === 'surface') {
    download(await writers[format](uncut(app.mesh, app.distance)), app.fileName(`distance.${format}`));
  } else if (kind === 'cut') {
    await exportCut(app, format);
  } else {
    await exportCurve(app, kind, format);
  }
}
