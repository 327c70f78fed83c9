// Arrows on the surface, as segments: six numbers each.

const most = 6000;

// Along vectors at some of the vertices, evenly taken, as long as these times `length`, and a little above the surface.
export function arrowsAlong(vectors, positions, normals, length) {
  const count = positions.length / 3;
  const step = Math.max(1, Math.ceil(count / most));
  const lines = [];
  for (let v = 0; v < count; v += step) {
    const at = [0, 1, 2].map((k) => positions[3 * v + k] + 0.15 * length * normals[3 * v + k]);
    const along = [0, 1, 2].map((k) => length * vectors[3 * v + k]);
    const across = [0, 1, 2].map((k) => {
      const i = (k + 1) % 3, j = (k + 2) % 3;
      return normals[3 * v + i] * along[j] - normals[3 * v + j] * along[i];
    });
    const tip = at.map((x, k) => x + along[k]);
    lines.push(...at, ...tip);
    for (const side of [-1, 1]) lines.push(...tip, ...tip.map((x, k) => x - 0.3 * along[k] + side * 0.15 * across[k]));
  }
  return Float32Array.from(lines);
}
