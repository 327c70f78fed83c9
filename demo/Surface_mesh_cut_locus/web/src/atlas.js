// From what the library returns for a cut surface to what is drawn and exported.

// Copies of the seams: on the model, and a little above the atlas, which lies in the plane z = 0.
export function seamsOf({ origin, border, uv }, positions) {
  const seams = new Float32Array(3 * border.length), atlasSeams = new Float32Array(3 * border.length);
  border.forEach((v, i) => {
    for (let k = 0; k < 3; ++k) seams[3 * i + k] = positions[3 * origin[v] + k];
    atlasSeams.set([uv[2 * v], uv[2 * v + 1], 0.01], 3 * i);
  });
  return { seams, atlasSeams };
}
