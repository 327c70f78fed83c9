// The numbers of the arrays of results, as in core/interface.cpp, and what they hold.
export const arrays = {
  positions: [0, 'f32'],
  triangles: [1, 'u32'],
  meshNumbers: [2, 'f64'],
  distance: [3, 'f32'],
  sourceNumbers: [4, 'f64'],
  laplacian: [5, 'f32'],
  gradient: [6, 'f32'],
  edgeCurve: { segments: [7, 'f32'], strength: [8, 'f32'], numbers: [9, 'f64'] },
  faceCurve: { segments: [10, 'f32'], strength: [11, 'f32'], numbers: [12, 'f64'] },
  text: [13, 'u8'],
  atlas: {
    origin: [14, 'u32'],
    triangles: [15, 'u32'],
    border: [16, 'u32'],
    uv: [17, 'f32'],
    numbers: [18, 'f64'],
  },
};

export const curveNames = ['edgeCurve', 'faceCurve'];
