// The numbers of the arrays of results, as in core/interface.cpp, and what they hold.
/** @type {any} */
export const arrays = {
  positions: [0, 'f32'],
  triangles: [1, 'u32'],
  meshNumbers: [2, 'f64'],
  distance: [3, 'f32'],
  sourceNumbers: [4, 'f64'],
  laplacian: [5, 'f32'],
  gradient: [6, 'f32'],
  edgeCurve: { segments: [7, 'f32'], width: [8, 'f32'], gap: [9, 'f32'], distance: [35, 'f32'], numbers: [10, 'f64'] },
  faceCurve: { segments: [11, 'f32'], width: [12, 'f32'], gap: [13, 'f32'], distance: [36, 'f32'], numbers: [14, 'f64'] },
  text: [15, 'u8'],
  atlas: {
    parents: [16, 'u32'],
    weights: [28, 'f32'],
    triangles: [17, 'u32'],
    faces: [27, 'u32'],
    border: [18, 'u32'],
    uv: [19, 'f32'],
    numbers: [20, 'f64'],
  },
  cells: { parents: [37, 'u32'], weights: [38, 'f32'], triangles: [39, 'u32'], source: [40, 'u32'] },
  component: [21, 'u32'],
  repairs: [22, 'u8'],
  paths: { points: [23, 'f32'], numbers: [24, 'f64'] },
  borderSegments: [25, 'f32'],
  nearestSource: [26, 'u32'],
  given: { positions: [29, 'f32'], triangles: [30, 'u32'], component: [31, 'u32'] }, // the mesh of another worker
  preview: { segments: [32, 'f32'] },
  previewValues: { distance: [33, 'f32'], nearestSource: [34, 'u32'] },
};

export const curveNames = ['edgeCurve', 'faceCurve'];

// what the library says is wrong, in its order
export const causeNames = ['other', 'emptyMesh', 'noTriangle', 'invalidCoordinate', 'faceWithoutArea', 'nonManifold',
  'noSource', 'invalidSource', 'sameSources', 'sourcesApart', 'noFaceAtSource', 'invalidDistance', 'invalidParameter',
  'parameterOfOtherMethod', 'invalidCutLocus', 'notConvex', 'noDisk', 'tooInaccurate'];
