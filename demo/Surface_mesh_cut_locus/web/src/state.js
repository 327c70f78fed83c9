// All that a link restores: the sample, the sources, the method with its thresholds, what is shown and how, and the view.

export const methods = ['default', 'polyhedral', 'laplacian'];
export const parameterizations = ['injective', 'logmap']; // as in the program
export const keptParts = ['all', 'voronoi', 'medial']; // in the order of `Kept_part` in core/solvers.h
export const maps = ['viridis', 'cividis', 'magma', 'grays']; // of distances to colors
// Which part of the mesh a plane takes away: that of larger or of smaller coordinates.
export const clips = ['no', 'x', '-x', 'y', '-y', 'z', '-z'];

export function defaultState() {
  return {
    sample: 'torus', // or null: a file
    faces: 20000,
    file: null,
    sources: null, // of each { face, coordinates }
    border: 'no', // whether the border is a source: 'also' with these, or 'only'
    solver: 'exact',
    method: 'default',
    // null is the default of the library
    parameters: {
      width: null, // in percent of the diagonal of the bounding box
      keep: 'all', // of several sources: or 'voronoi', what is between them, or 'medial', what is inside their cells
      angle: null,
      laplacian: null,
      minimumEdges: null,
      minimumLength: null,
      policy: 'prune',
      smoothing: 4,
    },
    show: {
      isolines: true,
      gradient: false,
      width: false,
      hidden: true,
      disk: false,
      edgeCurve: false,
      faceCurve: true,
      values: true,
      checker: true,
    },
    look: {
      color: 'plain',
      transparency: 0,
      shading: 'smooth',
      wireframe: false,
      occlusion: true,
      axes: true,
      projection: 'perspective',
      lineWidth: 1, // times the usual one
      map: 'viridis',
      clip: 'no',
      clipAt: 0.5, // a share of the way through the mesh
      up: 'auto',
      theme: 'auto',
    },
    isCut: false,
    parameterization: 'injective', // how it is laid flat: or 'logmap', by distances and directions from one point
    isEmbedded: false, // the picture alone, for the frame of another page
    view: null,
  };
}

const round = (x, digits) => (Math.abs(x) < 1e-9 ? 0 : Number(x.toPrecision(digits)));

// A barycentric coordinate as it is in a link.
export const rounded = (x) => round(x, 8);

export function toHash(state) {
  const items = new URLSearchParams();
  const standard = defaultState();
  if (state.sample) {
    items.set('sample', state.sample);
    items.set('faces', state.faces);
  } else if (state.file) {
    items.set('file', state.file);
  }
  if (state.sources)
    items.set('source', state.sources.flatMap(({ face, coordinates }) => [face, ...coordinates.map(rounded)]).join());
  if (state.border !== standard.border) items.set('border', state.border);
  items.set('solver', state.solver);
  items.set('method', state.method);
  for (const [name, value] of Object.entries(state.parameters))
    if (value !== standard.parameters[name]) items.set(name, value);
  const differing = Object.keys(state.show).filter((name) => state.show[name] !== standard.show[name]);
  if (differing.length > 0) items.set('show', differing.map((name) => (state.show[name] ? '' : '-') + name).join());
  for (const [name, value] of Object.entries(state.look)) if (value !== standard.look[name]) items.set(name, value);
  if (state.isCut) items.set('cut', '1');
  if (state.parameterization !== standard.parameterization) items.set('parameterization', state.parameterization);
  if (state.isEmbedded) items.set('embed', '1');
  if (state.view) items.set('view', state.view.map((x) => round(x, 4)).join());
  return `#${items.toString().replace(/%2C/g, ',')}`;
}

// null unless all of them are numbers
function numbersIn(text) {
  const numbers = text.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  return numbers.every(Number.isFinite) ? numbers : null;
}

function sourcesIn(text) {
  const numbers = numbersIn(text);
  if (!numbers || numbers.length % 4 !== 0) return null;
  const sources = [];
  for (let i = 0; i < numbers.length; i += 4) sources.push({ face: numbers[i], coordinates: numbers.slice(i + 1, i + 4) });
  // a point in its face
  const isValid = ({ face, coordinates }) => Number.isInteger(face) && face >= 0 && coordinates.every((b) => b >= 0)
    && coordinates.some((b) => b > 0);
  return sources.every(isValid) ? sources : null;
}

// How items of a link are read: each sets something in the state, and tells whether it makes sense.
const oneOf = (allowed, set) => (state, text) => {
  if (!allowed.includes(text)) return false;
  set(state, text);
  return true;
};

const numberIn = (low, high, set) => (state, text) => {
  const value = text.trim() === '' ? NaN : Number(text);
  if (!(value >= low && value <= high)) return false;
  set(state, value);
  return true;
};

const parameter = (name, low, high) => numberIn(low, high, (state, value) => { state.parameters[name] = value; });
const flag = (name) => oneOf(['true', 'false'], (state, text) => { state.look[name] = text === 'true'; });
const look = (name, allowed) => oneOf(allowed, (state, text) => { state.look[name] = text; });
const given = (read, set) => (state, text) => {
  const value = read(text);
  if (value === null) return false;
  set(state, value);
  return true;
};

const readers = {
  file: given((text) => text || null, (state, file) => Object.assign(state, { sample: null, file })),
  sample: given((text) => text || null, (state, sample) => Object.assign(state, { sample, file: null })),
  faces: numberIn(100, 2e6, (state, value) => { state.faces = Math.round(value); }),
  source: given(sourcesIn, (state, sources) => { state.sources = sources; }),
  border: oneOf(['no', 'also', 'only'], (state, text) => { state.border = text; }),
  solver: oneOf(['exact', 'heat', 'graph'], (state, text) => { state.solver = text; }),
  // links of before say `direction`
  method: oneOf(['direction', ...methods], (state, text) => { state.method = text === 'direction' ? 'default' : text; }),
  width: parameter('width', 0, 100),
  keep: oneOf(keptParts, (state, text) => { state.parameters.keep = text; }),
  angle: parameter('angle', 0, Math.PI),
  laplacian: parameter('laplacian', -Infinity, Infinity),
  minimumEdges: parameter('minimumEdges', 0, 1e9),
  minimumLength: parameter('minimumLength', 0, 1000),
  policy: oneOf(['prune', 'grow'], (state, text) => { state.parameters.policy = text; }),
  smoothing: parameter('smoothing', 0, 1000),
  show(state, text) {
    const names = text.split(',').map((item) => [item.replace(/^-/, ''), !item.startsWith('-')]);
    for (const [name, value] of names) if (Object.hasOwn(state.show, name)) state.show[name] = value;
    return names.every(([name]) => Object.hasOwn(state.show, name));
  },
  color: look('color', ['plain', 'distance', 'cells', 'laplacian']),
  transparency: numberIn(0, 0.9, (state, value) => { state.look.transparency = value; }),
  shading: look('shading', ['smooth', 'flat']),
  wireframe: flag('wireframe'),
  occlusion: flag('occlusion'),
  axes: flag('axes'),
  projection: look('projection', ['perspective', 'orthographic']),
  lineWidth: numberIn(0.5, 3, (state, value) => { state.look.lineWidth = value; }),
  map: look('map', maps),
  clip: look('clip', clips),
  clipAt: numberIn(0, 1, (state, value) => { state.look.clipAt = value; }),
  up: look('up', ['auto', 'y', 'z']),
  theme: look('theme', ['auto', 'light', 'dark']),
  cut: oneOf(['0', '1'], (state, text) => { state.isCut = text === '1'; }),
  parameterization: oneOf(parameterizations, (state, text) => { state.parameterization = text; }),
  embed: oneOf(['', '0', '1'], (state, text) => { state.isEmbedded = text !== '0'; }),
  view: given((text) => {
    const numbers = numbersIn(text);
    // the eye, which is not where it looks
    return numbers && numbers.length === 6 && [0, 1, 2].some((k) => numbers[k] !== numbers[k + 3]) ? numbers : null;
  }, (state, view) => { state.view = view; }),
};

// What a link says. What is missing, or makes no sense, is left as it is by default; `ignored` has the names of the latter.
export function fromHash(hash) {
  const state = defaultState();
  const ignored = [];
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, '')))
    if (!Object.hasOwn(readers, name) || !readers[name](state, text)) ignored.push(name);
  if (state.solver !== 'exact') state.method = 'laplacian';
  return { state, ignored };
}
