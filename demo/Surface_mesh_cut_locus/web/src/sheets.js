// The sheets of an atlas: one, or, of several sources, one for each cell.

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

const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];

// Where a point of a face of the mesh is on the sheets: a vertex of the part of the face that it is in, and its place.
function placeOf({ triangles, faces, parents, weights, uv }, { face, coordinates }, corners) {
  const inFace = (v) => corners.map((corner) =>
    [0, 1, 2].reduce((sum, k) => sum + (parents[3 * v + k] === corner ? weights[3 * v + k] : 0), 0));
  let best = null, most = -Infinity;
  for (let f = faces.indexOf(face); f >= 0; f = faces.indexOf(face, f + 1)) {
    const vertices = triangles.subarray(3 * f, 3 * f + 3);
    const [a, b, c] = Array.from(vertices, inFace);
    const volume = dot(a, cross(b, c));
    const shares = [cross(b, c), cross(c, a), cross(a, b)].map((normal) => dot(coordinates, normal) / volume);
    const least = Math.min(...shares); // at least 0 in the part that has the point
    if (!(least > most)) continue;
    most = least;
    best = { vertex: vertices[0], place: [0, 1].map((k) => shares.reduce((sum, s, i) => sum + s * uv[2 * vertices[i] + k], 0)) };
  }
  return best;
}

// The number of the source of a sheet that no point is in, but a part of the border: that of most of its vertices off the
// seams, which are as near to others; and the vertex in its middle.
function sheetOfBorder(vertices, { parents, weights, uv }, onBorder, nearest) {
  const votes = new Map();
  for (const v of vertices)
    for (let k = 3 * v; !onBorder.has(v) && k < 3 * v + 3; ++k)
      votes.set(nearest[parents[k]], (votes.get(nearest[parents[k]]) || 0) + weights[k]);
  const [source] = [...votes].reduce((best, vote) => (vote[1] > best[1] ? vote : best), [0, 0]);
  const middle = [0, 1].map((k) => vertices.reduce((sum, v) => sum + uv[2 * v + k], 0) / vertices.length);
  const off = (v) => Math.hypot(uv[2 * v] - middle[0], uv[2 * v + 1] - middle[1]);
  const at = vertices.reduce((best, v) => (off(v) < off(best) ? v : best));
  return { source, place: [uv[2 * at], uv[2 * at + 1]] };
}

// Of each sheet the number of its source, from 0 on, the place at which it is marked, and its vertices. `sources` are the
// points, before the borders; `nearest` are the sources of the vertices of the mesh.
export function sheetsOf(atlas, { triangles }, sources, nearest) {
  const first = firstVertices(atlas);
  const members = new Map();
  first.forEach((key, v) => (members.has(key) ? members.get(key).push(v) : members.set(key, [v])));
  const marked = new Map();
  sources.forEach((point, source) => {
    const found = placeOf(atlas, point, Array.from(triangles.subarray(3 * point.face, 3 * point.face + 3)));
    if (found) marked.set(first[found.vertex], { source, place: found.place });
  });
  const onBorder = new Set(atlas.border);
  return Array.from(members, ([key, vertices]) =>
    ({ ...(marked.get(key) || sheetOfBorder(vertices, atlas, onBorder, nearest)), vertices }));
}
