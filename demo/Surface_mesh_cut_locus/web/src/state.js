// All that a link restores: the sample, the source, the method with its thresholds, what is shown, and the view.

export const methods = ['direction', 'polyhedral', 'laplacian'];

export function defaultState() {
  return {
    sample: 'torus', // or null: a file
    faces: 20000,
    file: null,
    source: null, // { face, coordinates }
    solver: 'exact',
    method: 'direction',
    // null is the default of the library
    parameters: {
      width: null, // in percent of the diagonal of the bounding box
      angle: null,
      laplacian: null,
      minimumEdges: null,
      minimumLength: null,
      policy: 'prune',
      smoothing: 4,
    },
    show: {
      isolines: true,
      laplacian: false,
      gradient: false,
      width: false,
      hidden: true,
      disk: false,
      edgeCurve: false,
      faceCurve: true,
      checker: true,
    },
    isCut: false,
    view: null,
  };
}

const round = (x, digits) => Number(x.toPrecision(digits));

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
  if (state.source) items.set('source', [state.source.face, ...state.source.coordinates.map(rounded)].join());
  items.set('solver', state.solver);
  items.set('method', state.method);
  for (const [name, value] of Object.entries(state.parameters))
    if (value !== standard.parameters[name]) items.set(name, value);
  const differing = Object.keys(state.show).filter((name) => state.show[name] !== standard.show[name]);
  if (differing.length > 0) items.set('show', differing.map((name) => (state.show[name] ? '' : '-') + name).join());
  if (state.isCut) items.set('cut', '1');
  if (state.view) items.set('view', state.view.map((x) => round(x, 4)).join());
  return `#${items.toString().replace(/%2C/g, ',')}`;
}

function numbersIn(text, count) {
  const numbers = (text || '').split(',').map(Number);
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
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
  const source = numbersIn(items.get('source'), 4);
  if (source && Number.isInteger(source[0]) && source[0] >= 0)
    state.source = { face: source[0], coordinates: source.slice(1) };
  if (['exact', 'heat', 'graph'].includes(items.get('solver'))) state.solver = items.get('solver');
  if (methods.includes(items.get('method'))) state.method = items.get('method');
  if (state.solver !== 'exact') state.method = 'laplacian';
  for (const name of ['width', 'angle', 'laplacian', 'minimumEdges', 'minimumLength', 'smoothing']) {
    const value = Number(items.get(name));
    if (items.has(name) && Number.isFinite(value) && (name !== 'width' || value >= 0)) state.parameters[name] = value;
  }
  if (items.get('policy') === 'grow') state.parameters.policy = 'grow';
  for (const item of (items.get('show') || '').split(',')) {
    const name = item.replace(/^-/, '');
    if (name in state.show) state.show[name] = !item.startsWith('-');
  }
  state.isCut = items.get('cut') === '1';
  state.view = numbersIn(items.get('view'), 6);
  return state;
}
