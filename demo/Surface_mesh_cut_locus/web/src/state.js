// All that a link restores: the sample, the sources, the method with its thresholds, what is shown and how, and the view.

export const methods = ['direction', 'polyhedral', 'laplacian'];
export const keptParts = ['all', 'voronoi', 'medial']; // in the order of `Kept_part` in core/solvers.h

export function defaultState() {
  return {
    sample: 'torus', // or null: a file
    faces: 20000,
    file: null,
    sources: null, // of each { face, coordinates }
    border: 'no', // whether the border is a source: 'also' with these, or 'only'
    solver: 'exact',
    method: 'direction',
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
      up: 'auto',
      theme: 'auto',
    },
    isCut: false,
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
  if (state.view) items.set('view', state.view.map((x) => round(x, 4)).join());
  return `#${items.toString().replace(/%2C/g, ',')}`;
}

function numbersIn(text) {
  const numbers = (text || '').split(',').map(Number);
  return text && numbers.every(Number.isFinite) ? numbers : [];
}

function sourcesIn(text) {
  const numbers = numbersIn(text);
  const sources = [];
  for (let i = 0; i + 4 <= numbers.length; i += 4)
    sources.push({ face: numbers[i], coordinates: numbers.slice(i + 1, i + 4) });
  const isValid = sources.length > 0 && sources.every(({ face }) => Number.isInteger(face) && face >= 0);
  return isValid ? sources : null;
}

const looks = {
  color: ['plain', 'distance', 'cells', 'laplacian'],
  shading: ['smooth', 'flat'],
  up: ['auto', 'y', 'z'],
  theme: ['auto', 'light', 'dark'],
};

function readLook(items, look) {
  for (const [name, allowed] of Object.entries(looks)) if (allowed.includes(items.get(name))) look[name] = items.get(name);
  for (const name of ['wireframe', 'occlusion', 'axes'])
    if (['true', 'false'].includes(items.get(name))) look[name] = items.get(name) === 'true';
  const transparency = Number(items.get('transparency'));
  if (transparency >= 0 && transparency <= 0.9) look.transparency = transparency;
}

// What is missing, or makes no sense, is left as it is by default.
export function fromHash(hash) {
  const state = defaultState();
  const items = new URLSearchParams(hash.replace(/^#/, ''));
  if (items.has('file')) {
    state.sample = null;
    state.file = items.get('file');
  }
  if (items.has('sample')) state.sample = items.get('sample');
  const faces = Number(items.get('faces'));
  if (faces >= 100 && faces <= 2e6) state.faces = faces;
  state.sources = sourcesIn(items.get('source'));
  if (['exact', 'heat', 'graph'].includes(items.get('solver'))) state.solver = items.get('solver');
  if (methods.includes(items.get('method'))) state.method = items.get('method');
  if (state.solver !== 'exact') state.method = 'laplacian';
  for (const name of ['width', 'angle', 'laplacian', 'minimumEdges', 'minimumLength', 'smoothing']) {
    const value = Number(items.get(name));
    if (items.has(name) && Number.isFinite(value) && (name !== 'width' || value >= 0)) state.parameters[name] = value;
  }
  if (items.get('policy') === 'grow') state.parameters.policy = 'grow';
  if (keptParts.includes(items.get('keep'))) state.parameters.keep = items.get('keep');
  if (['also', 'only'].includes(items.get('border'))) state.border = items.get('border');
  for (const item of (items.get('show') || '').split(',')) {
    const name = item.replace(/^-/, '');
    if (name in state.show) state.show[name] = !item.startsWith('-');
  }
  state.isCut = items.get('cut') === '1';
  readLook(items, state.look);
  const view = numbersIn(items.get('view'));
  if (view.length === 6) state.view = view;
  return state;
}
