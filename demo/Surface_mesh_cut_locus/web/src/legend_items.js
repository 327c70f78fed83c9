// Everything that is on the screen, in the order of its weight, with the colors it has there.
import { branchScale } from './branch_scale.js';
import { branchColor, cellColor, cssColor, distanceColors, laplacianColor, stops } from './color_maps.js';
import { number } from './words.js';

function pathLabel({ numbers }) {
  const paths = numbers.length / 2;
  const length = number(numbers[1], 4);
  return paths === 1 ? `the shortest path, ${length}` : `${paths} shortest paths, ${length} each`;
}

function sourceLabel({ points, total }, atlas) {
  if (atlas && total > 1) return 'sources, and their sheets';
  return points.length > 1 ? 'sources' : 'source';
}

// of the first sources, after which colors come again; with fields rather than a ramp
const cellStops = (count) => Array.from({ length: Math.min(count, 12) }, (_, i) => cssColor(cellColor(i)))
  .flatMap((color) => [color, color, color, color]);

export function legendItems({ state, source, curve, curves, viewer, path, atlas, appearance, hasWave }) {
  const { gradient, hasDisk, laplacian, laplacianScale } = appearance;
  if (!source || !curve) return [];
  const { show, look } = state;
  const { colors } = viewer;
  const hasCurve = curve.numbers[0] > 0;
  const items = [];
  if (source.points.length > 0)
    items.push({ kind: 'dot', color: colors.source, rim: colors.casing, label: sourceLabel(source, atlas) });
  if (source.hasBorder) items.push({ kind: 'line', color: colors.source, label: 'the border, as a source' });
  const scale = branchScale(state);
  const hasEdgeCurve = show.edgeCurve && hasCurve && Boolean(curves.edgeCurve);
  const colored = show.width && hasCurve && (show.faceCurve || hasEdgeCurve);
  if (colored)
    items.push({ kind: 'scale', label: `cut locus by ${scale.label.toLowerCase()}, in ${scale.unit}:`, ends: scale.ends, stops: stops(branchColor, 4) });
  if (show.faceCurve && hasCurve && !colored) items.push({ kind: 'line', color: colors.curve, label: 'cut locus' });
  if (hasEdgeCurve && !colored) items.push({ kind: 'line', color: colors.edges, label: 'cut locus along mesh edges' });
  if (show.hidden && hasCurve && (show.faceCurve || hasEdgeCurve))
    items.push({ kind: 'line', color: show.faceCurve ? colors.hidden : viewer.edgeCurve.hiddenStyle, label: 'its parts behind the surface' });
  if (hasWave) items.push({ kind: 'fill', color: colors.source, label: 'wave from the source' });
  items.push({ kind: 'dot', color: colors.casing, rim: colors.text, label: 'farthest point' });
  if (path) items.push({ kind: 'line', color: colors.path, label: pathLabel(path) });
  if (show.gradient && gradient) items.push({ kind: 'line', color: colors.arrows, label: 'away from the source' });
  if (hasDisk) {
    items.push({ kind: 'fill', color: '#8fc792', label: 'unique shortest paths' });
    items.push({ kind: 'dot', color: colors.nearest, rim: colors.casing, label: 'nearest point of the cut locus' });
  }
  if (look.color === 'distance')
    items.push({ kind: 'scale', label: 'distance:', ends: ['0', number(source.farthestDistance)], stops: stops(distanceColors[look.map]) });
  if (look.color === 'cells' && source.total > 1)
    items.push({ kind: 'scale', label: 'nearest source:', ends: ['1', `${source.total}`], stops: cellStops(source.total) });
  if (look.color === 'laplacian' && laplacian)
    items.push({ kind: 'scale', label: 'Laplacian:', ends: [`−${number(laplacianScale, 2)}`, number(laplacianScale, 2)], stops: stops(laplacianColor) });
  if (show.isolines)
    items.push({ kind: 'thin', color: colors.soft, label: `equal distance, every ${number(source.farthestDistance / 25, 2)}` });
  if (look.wireframe) items.push({ kind: 'thin', color: colors.off, label: 'edges of the mesh' });
  if (atlas) {
    items.push({ kind: 'thin', color: colors.edges, label: 'seams' });
    items.push({ kind: 'line', color: colors.curve, label: 'seams of the sheet' });
  }
  return items;
}
