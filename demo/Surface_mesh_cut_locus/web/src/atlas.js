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

// What the user should know of the quality.
export function describeAtlas([flipped, change, isRigid], faceCount) {
  const parts = [`Areas change by ${(100 * change).toPrecision(2)} %`];
  if (!isRigid) parts.push('laid out by direction and distance: a more rigid layout would fold');
  if (flipped > 0) parts.push(`${flipped} of ${faceCount} faces are flipped`);
  return `${parts.join('; ')}.`;
}
