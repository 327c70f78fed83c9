// Errors in words that say what is wrong with the mesh and what to do about it.

// what is wrong with the mesh and the sources, by the cause that the library names; `element` is a face or a vertex
const byCause = {
  emptyMesh: () => 'There is no surface in this file: it has no faces.',
  faceWithoutArea: (element) => `The ${element} of this mesh has no area. Remove degenerate faces first and open it again.`,
  nonManifold: (element) =>
    `The faces do not form a surface: at the ${element} several sheets touch in a point. Split that vertex first.`,
  sameSources: () => 'Two sources have a point in common: choose another point, or let the border be no source.',
  noFaceAtSource: () => 'Sources are too close to each other for a curve that is made of edges of the mesh, or starts from them: '
    + 'choose another point, a finer mesh, or the curve through the faces of the method “the smooth shape”.',
  notLoaded: () => 'The part of the page that computes could not be loaded. Is the network there?',
  workerFailed: (element, words) => `The part of the page that computes has stopped (${words}). It starts again with what you do next.`,
  sourcesApart: () => 'Sources must be on the same part of the mesh: no path leads from one part to another.',
};

// and what has words alone, as what is wrong with the file
/** @type {[RegExp, (match: string[]) => string][]} */
const byWords = [
  [/have a point in common/, () => byCause.sameSources()],
  [/an edge belongs to more than two faces/,
    () => 'The faces do not form an oriented surface: an edge belongs to more than two faces, or to two of opposite orientation.'],
  [/meets others at a vertex that is not manifold/,
    () => 'The faces do not form a surface: at some vertex several sheets touch in a point. Split that vertex first.'],
  [/(face #\d+) has a vertex twice/,
    (m) => `The ${m[1]} of this mesh has the same vertex twice. Remove degenerate faces first and open it again.`],
  [/(face #\d+) refers to a vertex that does not exist/,
    (m) => `The file is damaged: its ${m[1]} refers to a vertex that is not there.`],
  [/no face of it has an area/, () => 'No face of this mesh has an area.'],
  [/there are no (vertices|faces)/,
    () => 'There is no surface in this file: it has no faces.'],
  [/out of bounds|unreachable|null function|signature mismatch/,
    () => 'The computation broke down here, which is an error of the program. Move the source a little, or take another method.'],
  [/memory|Array buffer allocation|Invalid array length|too large/i,
    () => 'The mesh is too large for the memory that a page can have. Simplify it, or use the program cut_locus.'],
  [/(cannot read|it is damaged)/,
    () => 'The file cannot be read: it is damaged, or its content does not match the ending of its name.'],
];

export function explain({ message, cause }) {
  if (Object.hasOwn(byCause, cause)) return byCause[cause]((message.match(/(face|vertex) #\d+/) || ['mesh'])[0], message);
  for (const [pattern, text] of cause && cause !== 'other' ? [] : byWords) {
    const match = message.match(pattern);
    if (match) return text(match);
  }
  const plain = message.replace(/'\/mesh\.\w+': /, '').replace(/\s*\(CGAL::[^)]*\([^)]*\)[^)]*\)/, '');
  return plain.charAt(0).toUpperCase() + plain.slice(1) + (/[.!?]$/.test(plain) ? '' : '.');
}

export const extensions = ['off', 'obj', 'ply', 'stl', 'ts', 'vtp'];
export const largestFile = 500e6;

export const extensionOf = (name) => name.split('.').pop().toLowerCase();

// What can be told before a file is read, or null.
export function objectionTo(file) {
  const extension = extensionOf(file.name);
  if (!extensions.includes(extension))
    return `“${file.name}” cannot be opened: its name must end in .off, .obj, .ply, .stl, .ts or .vtp.`;
  if (file.size === 0) return `“${file.name}” is empty.`;
  if (file.size > largestFile)
    return `“${file.name}” has ${Math.round(file.size / 1e6)} MB: that is too large for a page. Simplify it, or use the program cut_locus.`;
  return null;
}
