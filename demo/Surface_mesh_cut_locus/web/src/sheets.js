// The sheets of an atlas: one, or, of several sources, one for each cell.
import { valuesAt } from './atlas.js';

// For each vertex, the first one of its sheet.
function firstVertices({ triangles, uv }) {
  const first = Uint32Array.from({ length: uv.length / 2 }, (_, v) => v);
  const find = (v) => {
    while (first[v] !== v) v = first[v] = first[first[v]];
    return v;
  };
  for (let i = 0; i < triangles.length; i += 3)
    for (const k of [1, 2]) {
      const [a, b] = [find(triangles[i]), find(triangles[i + k])];
      if (a !== b) first[Math.max(a, b)] = Math.min(a, b);
    }
  return first.map((_, v) => find(v));
}

// Of each sheet the number of its source, from 0 on, and the place at which it is marked: that of the source, or, if the
// source is a part of the border, the middle. `nearest` and `distance` are at the vertices of the mesh.
export function sheetsOf(atlas, nearest, distance) {
  const { parents, weights, border, uv } = atlas;
  const first = firstVertices(atlas);
  const away = valuesAt(atlas, distance);
  const onBorder = new Set(border);
  const sheets = new Map();
  for (let v = 0; v < first.length; ++v) {
    if (!sheets.has(first[v])) sheets.set(first[v], { vertices: [], votes: new Map() });
    const { vertices, votes } = sheets.get(first[v]);
    vertices.push(v);
    // those on a seam are as near to another source
    if (!onBorder.has(v))
      for (let k = 3 * v; k < 3 * v + 3; ++k)
        votes.set(nearest[parents[k]], (votes.get(nearest[parents[k]]) || 0) + weights[k]);
  }
  const least = (vertices, value) => vertices.reduce((best, v) => (value(v) < value(best) ? v : best));
  return Array.from(sheets.values(), ({ vertices, votes }) => {
    const [source] = [...votes].reduce((best, vote) => (vote[1] > best[1] ? vote : best), [0, 0]);
    let at = least(vertices, (v) => away[v]);
    if (onBorder.has(at)) {
      const middle = [0, 1].map((k) => vertices.reduce((sum, v) => sum + uv[2 * v + k], 0) / vertices.length);
      at = least(vertices, (v) => Math.hypot(uv[2 * v] - middle[0], uv[2 * v + 1] - middle[1]));
    }
    return { source, place: [uv[2 * at], uv[2 * at + 1]] };
  });
}
