// What the numbers of a result mean, in words.

export const count = (n) => Math.round(n).toLocaleString('en');

export function number(x, digits = 3) {
  return Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : '–';
}

export function milliseconds(ms) {
  if (!Number.isFinite(ms)) return '–';
  if (ms >= 1000) return `${(ms / 1000).toPrecision(3)} s`;
  return `${ms >= 100 ? Math.round(ms) : ms.toFixed(1)} ms`;
}

const several = (n, one, more) => `${count(n)} ${n === 1 ? one : more}`;

// A length, rounded to what is known of it: `error` more or less.
export function rounded(x, error) {
  if (!Number.isFinite(x)) return '–';
  if (!(error > 0)) return number(x);
  const unit = 10 ** Math.floor(Math.log10(error));
  const digits = Math.max(0, -Math.floor(Math.log10(error)));
  const at = (y) => (Math.round(y / unit) * unit).toFixed(Math.min(digits, 20));
  if (x < error) return `less than ${at(x + error)}`;
  return `${at(x)}\u00a0±\u00a0${at(Math.max(error, unit))}`;
}

// by the status of a cut locus: 0 is that of one with branches
const emptyNotes = {
  1: 'The cut locus is one point: either all shortest paths meet there, as on a sphere, or no branch is as wide as '
    + 'Detail asks for. Move Detail toward “more branches” to see whether there are narrower ones.',
  2: 'The cut locus has no branches: either all shortest paths end at the border, as in a flat disk, or no branch is as '
    + 'wide as Detail asks for. Move Detail toward “more branches” to see.',
};

export const coarse = 300; // faces; fewer show the polyhedron rather than a smooth shape

// What makes the result doubtful, and what to do about it.
export function doubts({ curve, lacksEdgeCurve, source, faceCount, state, defaults }) {
  const [edges, , leaves, , , , , , , status, corridors] = curve.numbers;
  if (emptyNotes[status]) return [emptyNotes[status]];
  const result = [];
  const { method, parameters, solver } = state;
  const width = parameters.width === null ? null : parameters.width / 100;
  if (method === 'default' && width !== null && defaults.width > 0 && width < 0.6 * defaults.width)
    result.push(`Branches narrower than ${number(100 * defaults.width)} % may come from the mesh instead of the shape. `
      + '“Auto” leaves them out.');
  else if (method === 'default' && faceCount < coarse && defaults.width > 0)
    result.push(`With ${count(faceCount)} faces the shape is rough: branches are where they are to about an edge. A finer `
      + 'mesh says more.');
  if (method === 'polyhedral' && leaves > 40 && width === null)
    result.push('Each corner of the polyhedron has a branch. If the mesh stands for a smooth shape, choose that under Method.');
  if (solver !== 'exact')
    result.push('These distances are approximate, and so is the curve. Exact ones are under Method.');
  if (!source.hasBorder && source.borderLoops > 0 && leaves > 2 * source.borderLoops && edges > 0)
    result.push(`Shortest paths go around the ${source.borderLoops === 1 ? 'hole' : `${count(source.borderLoops)} holes`}: `
      + 'branches behind them are real for this surface. Holes that are none of the shape should be filled first.');
  if (lacksEdgeCurve)
    result.push('There is no curve along mesh edges: sources are too close to each other for one.');
  if (corridors > 0)
    result.push(`In ${several(corridors, 'place', 'places')} the mesh is too coarse to keep two branches apart.`);
  return result;
}

// Only one point has an injectivity radius.
export const isOnePoint = (source) => !source.hasBorder && source.total === 1;

// One sentence on what there is.
export function summary({ curve, source, edgeLength }) {
  const [edges, cycles, leaves, , , radius] = curve.numbers;
  const border = source.borderLoops > 0 ? ` with ${several(source.borderLoops, 'border', 'borders')}` : '';
  const shape = `Surface of genus ${source.genus}${border}`;
  if (edges === 0) return `${shape}.`;
  const loops = cycles > 0 ? `${several(cycles, 'independent loop', 'independent loops')} and ` : '';
  return `${shape}: the cut locus has ${loops}${several(leaves, 'free end', 'free ends')}. `
    + (isOnePoint(source) ? `Injectivity radius ${rounded(radius, edgeLength / 2)}.`
      : `Its nearest point to the sources is ${rounded(radius, edgeLength / 2)} away.`);
}

export function numberRows({ curve, source, edgeLength, state, defaults }) {
  const [edges, cycles, leaves, branchings, length, radius] = curve.numbers;
  const least = curve.numbers[11]; // 0 if it is not known
  const { width } = state.parameters;
  const detail = state.method === 'laplacian' ? 'with these thresholds'
    : width !== null ? `of branches of ${number(width)} % and more`
      : defaults.width > 0 ? `of branches of ${number(100 * defaults.width)} % and more` : 'of the branches shown';
  const bound = least > 0 && least < radius - edgeLength / 2 ? `; with all weak branches at least ${number(least)}` : '';
  return [
    [isOnePoint(source) ? 'injectivity radius' : 'nearest to the sources', edges > 0 ? `${rounded(radius, edgeLength / 2)}` : '–', edges > 0 ? detail + bound : ''],
    ['farthest point', `${number(source.farthestDistance, 4)}`, source.total > 1 ? 'away from the nearest source' : 'away from the source'],
    ['length of the curve', edges > 0 ? number(length, 3) : '–', ''],
    ['genus', count(source.genus), ''],
    ...(source.total > 1 ? [['sources', count(source.total), '']] : []),
    ...(source.borderLoops > 0 ? [['borders', count(source.borderLoops), '']] : []),
    ['loops', count(cycles), ''],
    ['free ends', count(leaves), ''],
    ['branchings', count(branchings), ''],
  ];
}

// What the user should know of the quality of an atlas.
export function describeAtlas([flipped, overlapping, overlap, change, isInjective, sheets], faceCount, parameterization = 'injective') {
  const parts = [];
  const share = overlap > 0 ? `, on ${number(100 * overlap, 2)}\u00a0% of it` : '';
  if (overlapping > 0) parts.push(`${count(overlapping)} of ${count(faceCount)} faces lie over others${share}`);
  if (flipped > 0) parts.push(`${count(flipped)} of ${count(faceCount)} faces are turned over`);
  parts.push(`areas change by ${number(100 * change, 2)}\u00a0%`);
  const text = `${parts.join('; ')}.`;
  if (parameterization === 'logmap') return { isInjective: Boolean(isInjective), text: `Distances from the source are true; ${text}` };
  if (!isInjective) return { isInjective: false, text: `Not one to one: ${text} A source elsewhere may give a better sheet.` };
  const what = sheets > 1 ? `${count(sheets)} sheets, one for each cell: none overlaps` : 'The sheet does not overlap';
  return { isInjective: true, text: `${what}; ${text}` };
}
