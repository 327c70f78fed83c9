// From what the library returns for a cut surface to what is drawn and exported. Its vertex i is in a face of the mesh: at
// the vertices parents[3 i], ... with the weights[3 i], ...; a copy of a vertex has all the weight there.

// At each vertex of the cut surface, from `size` numbers at each of the mesh. Where one counts that is not finite, none is.
export function valuesAt({ parents, weights }, values, size = 1) {
  const count = parents.length / 3;
  const result = new Float32Array(size * count);
  for (let i = 0; i < count; ++i)
    for (let k = 3 * i; k < 3 * i + 3; ++k)
      if (weights[k] !== 0)
        for (let c = 0; c < size; ++c) result[size * i + c] += weights[k] * values[size * parents[k] + c];
  return result;
}

// The barycentric coordinates in a face of the mesh of a point in one of its parts: `vertices` are those of the part.
export function coordinatesInFace({ parents, weights }, vertices, coordinates, corners) {
  const result = [0, 0, 0];
  vertices.forEach((v, i) => {
    for (let k = 3 * v; k < 3 * v + 3; ++k) {
      const at = weights[k] === 0 ? -1 : corners.indexOf(parents[k]);
      if (at >= 0) result[at] += coordinates[i] * weights[k];
    }
  });
  const positive = result.map((x) => Math.max(x, 0));
  const sum = positive[0] + positive[1] + positive[2];
  return sum > 0.5 ? positive.map((x) => x / sum) : null;
}

// Copies of the seams: on the model, and a little above the atlas, which lies in the plane z = 0.
export function seamsOf(atlas, positions) {
  const { border, uv } = atlas;
  const places = valuesAt(atlas, positions, 3);
  const seams = new Float32Array(3 * border.length), atlasSeams = new Float32Array(3 * border.length);
  border.forEach((v, i) => {
    seams.set(places.subarray(3 * v, 3 * v + 3), 3 * i);
    atlasSeams.set([uv[2 * v], uv[2 * v + 1], 0.01], 3 * i);
  });
  return { seams, atlasSeams };
}
