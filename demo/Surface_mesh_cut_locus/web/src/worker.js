// Runs the library in a thread of its own. It takes messages { id, command, ...arguments } and answers each with
// { id, result } or { id, error, cause }; meanwhile { stage } and { stage, share } tell how far it is.
import { arrays, causeNames, curveNames } from './arrays.js';
import { keptParts } from './state.js';

/** @type {any} */
const scope = self;
const base = new URL('.', scope.location.href);

const stageNames = ['preprocessing', 'distance', 'strength', 'tree', 'homology', 'filter',
  'flattening', 'cutting'];
let stageTimes = {};
let stageStart = 0;
let lastShare = 0; // when it was told
const betweenShares = 60; // milliseconds

const settings = {
  locateFile: (name) => new URL(name, base).href,
  printErr: () => {},
  onStage(stage, starts) {
    const now = performance.now();
    const name = stageNames[stage];
    if (starts) {
      stageStart = now;
      scope.postMessage({ stage: name });
    } else {
      stageTimes[name] = (stageTimes[name] || 0) + now - stageStart;
    }
  },
  onProgress(stage, share) {
    const now = performance.now();
    if (now - lastShare < betweenShares) return;
    lastShare = now;
    scope.postMessage({ stage: stageNames[stage], share });
  },
};

// What cannot be loaded is said to each command.
const ready = (async () => {
  try {
    scope.importScripts(new URL('cut_locus.js', base).href);
    return await scope.createCutLocus(settings);
  } catch (error) {
    throw Object.assign(new Error(error.message || String(error)), { cause: 'notLoaded', fatal: true });
  }
})();
ready.catch(() => {});

const typedArrays = { f32: Float32Array, f64: Float64Array, u32: Uint32Array, u8: Uint8Array };

// A copy of an array of the module, which can be handed over to the page.
function arrayOf(module, [number, type]) {
  const size = module._array_size(number);
  const Type = typedArrays[type];
  const result = new Type(size);
  if (size > 0) result.set(new Type(module.HEAPU8.buffer, module._array_data(number), size));
  return result;
}

function arraysOf(module, named) {
  return Object.fromEntries(Object.entries(named).map(([name, array]) => [name, arrayOf(module, array)]));
}

function setThresholds(module, p) {
  const number = (value) => (value === null ? NaN : value);
  const share = p.width === null ? null : p.width / 100;
  module._set_thresholds(number(share), keptParts.indexOf(p.keep), number(p.angle), number(p.laplacian), number(p.minimumEdges),
    number(p.minimumLength), p.policy === 'grow' ? 1 : 0, p.smoothing);
}

function check(module, success) {
  if (success) return;
  const error = new Error(module.UTF8ToString(module._last_error()));
  error.cause = causeNames[module._last_cause()];
  throw error;
}

function call(module, name, types, values) {
  check(module, module.ccall(name, 'number', types, values));
}

const commands = {
  load(module, { recipe }) {
    if (recipe.sample) {
      call(module, 'load_sample', ['string', 'number'], [recipe.sample, recipe.faces]);
    } else {
      const name = `/mesh.${recipe.extension}`;
      module.FS.writeFile(name, new Uint8Array(recipe.bytes));
      try {
        call(module, 'load_file', ['string'], [name]);
      } finally {
        module.FS.unlink(name);
      }
    }
    return {
      positions: arrayOf(module, arrays.positions),
      triangles: arrayOf(module, arrays.triangles),
      numbers: arrayOf(module, arrays.meshNumbers),
      component: arrayOf(module, arrays.component),
      repairs: new TextDecoder().decode(arrayOf(module, arrays.repairs)),
    };
  },

  solve(module, { solver, method, sources, border, curves, parameters, relativeError = 0 }) {
    stageTimes = {};
    const start = performance.now();
    call(module, 'prepare', ['string', 'string'], [solver, method]);
    module._clear_sources();
    for (const { face, coordinates } of sources) module._add_source(face, ...coordinates);
    check(module, module._set_sources(border ? 1 : 0, relativeError));
    const milliseconds = performance.now() - start;
    const result = commands.curves(module, { curves, parameters });
    result.solveMilliseconds = milliseconds;
    result.stages = stageTimes;
    result.distance = arrayOf(module, arrays.distance);
    for (const name of ['sourceNumbers', 'borderSegments', 'nearestSource']) result[name] = arrayOf(module, arrays[name]);
    return result;
  },

  // The mesh of another worker, to be simplified.
  takeMesh(module, { unit, ...given }) {
    const { positions, triangles, component } = given;
    check(module, module._resize_mesh(positions.length, triangles.length, component.length));
    for (const [name, [number, type]] of Object.entries(arrays.given))
      new typedArrays[type](module.HEAPU8.buffer, module._array_data(number), given[name].length).set(given[name]);
    check(module, module._take_mesh(unit));
    return {};
  },

  simplify(module, { faces }) {
    check(module, module._simplify(faces));
    return { faces: module._number_of_simplified_faces() };
  },

  // On the simplified mesh, and drawn on the whole one.
  preview(module, { solver, method, sources, border, curve, parameters, relativeError, wantsValues }) {
    const start = performance.now();
    call(module, 'prepare', ['string', 'string'], [solver, method]);
    module._clear_sources();
    for (const { face, coordinates } of sources) check(module, module._add_preview_source(face, ...coordinates));
    check(module, module._set_sources(border ? 1 : 0, relativeError));
    setThresholds(module, parameters);
    check(module, module._compute_preview_curve(curve));
    const result = arraysOf(module, arrays.preview);
    result.numbers = arrayOf(module, arrays[curveNames[curve]].numbers);
    result.sourceNumbers = arrayOf(module, arrays.sourceNumbers);
    if (wantsValues) {
      check(module, module._compute_preview_distances());
      Object.assign(result, arraysOf(module, arrays.previewValues));
    }
    result.milliseconds = performance.now() - start;
    return result;
  },

  curves(module, { curves, parameters }) {
    const start = performance.now();
    const result = {};
    setThresholds(module, parameters);
    for (const i of curves) {
      const isComputed = module._compute_curve(i);
      // sources that edges of the mesh cannot separate have the curve through the faces alone
      if (!isComputed && curves.length > 1 && curveNames[i] === 'edgeCurve' && causeNames[module._last_cause()] === 'noFaceAtSource') continue;
      check(module, isComputed);
      result[curveNames[i]] = arraysOf(module, arrays[curveNames[i]]);
    }
    result.milliseconds = performance.now() - start;
    return result;
  },

  cut(module, { parameters, curve, parameterization }) {
    setThresholds(module, parameters);
    check(module, module._cut_open(curve, parameterization === 'logmap' ? 1 : 0));
    return { ...arraysOf(module, arrays.atlas), curve: arraysOf(module, arrays[curveNames[curve]]) };
  },

  cells(module, { parameters, curve }) {
    setThresholds(module, parameters);
    check(module, module._divide_into_cells(curve));
    return arraysOf(module, arrays.cells);
  },

  laplacian(module) {
    check(module, module._compute_laplacian());
    return arrayOf(module, arrays.laplacian);
  },

  gradient(module) {
    check(module, module._compute_gradient());
    return arrayOf(module, arrays.gradient);
  },

  paths(module, { end }) {
    check(module, module._find_paths(end.face, ...end.coordinates));
    return arraysOf(module, arrays.paths);
  },

  write(module, { curve, format }) {
    call(module, 'write_curve', ['number', 'string'], [curve, format]);
    return arrayOf(module, arrays.text);
  },
};

// All buffers of a result are moved to the page, not copied.
function buffersOf(result, buffers = []) {
  if (ArrayBuffer.isView(result)) buffers.push(result.buffer);
  else if (result && typeof result === 'object') Object.values(result).forEach((value) => buffersOf(value, buffers));
  return buffers;
}

scope.onmessage = async ({ data }) => {
  try {
    const module = await ready;
    const result = commands[data.command](module, data);
    scope.postMessage({ id: data.id, result }, buffersOf(result));
  } catch (error) {
    // what is not an error of the library leaves the module in an unknown state
    const fatal = error.fatal || error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    scope.postMessage({ id: data.id, error: error.message || String(error), cause: error.cause, fatal });
  }
};
