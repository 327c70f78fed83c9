// Reads the files that the page exports, and tells their topology.

export function readObj(text) {
  const mesh = { points: [], textureCoordinates: [], faces: [], lines: [] };
  for (const line of text.split('\n')) {
    const [kind, ...words] = line.trim().split(/\s+/);
    if (kind === 'v') mesh.points.push(words.map(Number));
    else if (kind === 'vt') mesh.textureCoordinates.push(words.map(Number));
    else if (kind === 'f') mesh.faces.push(words.map((w) => Number(w.split('/')[0]) - 1));
    else if (kind === 'l') mesh.lines.push(words.map((w) => Number(w) - 1));
  }
  return mesh;
}

// those that are turned over, or have no area, in the plane of the texture coordinates: each point has one
export function flippedFaces({ faces, textureCoordinates: uv }) {
  return faces.filter(([a, b, c]) =>
    !((uv[b][0] - uv[a][0]) * (uv[c][1] - uv[a][1]) - (uv[b][1] - uv[a][1]) * (uv[c][0] - uv[a][0]) > 0)).length;
}

// How many pairs of border edges cross each other in the plane of the texture coordinates.
export function borderCrossings({ faces, textureCoordinates: uv }) {
  const edges = new Map();
  for (const face of faces)
    face.forEach((v, i) => {
      const w = face[(i + 1) % face.length];
      if (!edges.delete(`${w} ${v}`)) edges.set(`${v} ${w}`, [v, w]);
    });
  const border = [...edges.values()];
  const side = (a, b, c) => Math.sign((uv[b][0] - uv[a][0]) * (uv[c][1] - uv[a][1]) - (uv[b][1] - uv[a][1]) * (uv[c][0] - uv[a][0]));
  let crossings = 0;
  border.forEach(([a, b], i) => {
    for (const [c, d] of border.slice(0, i))
      crossings += ![c, d].includes(a) && ![c, d].includes(b) && side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  });
  return crossings;
}

// V - E + F and the number of border loops of a mesh; it throws if that is no surface.
export function surfaceTopology({ points, faces }) {
  const halfedges = new Map();
  for (const face of faces)
    face.forEach((v, i) => {
      const key = `${v} ${face[(i + 1) % face.length]}`;
      if (halfedges.has(key)) throw new Error(`the halfedge ${key} belongs to two faces`);
      halfedges.set(key, true);
    });
  const next = new Map(); // along the border
  let edgeCount = 0;
  for (const key of halfedges.keys()) {
    const [v, w] = key.split(' ');
    const hasOpposite = halfedges.has(`${w} ${v}`);
    edgeCount += hasOpposite ? 0.5 : 1;
    if (hasOpposite) continue;
    if (next.has(v)) throw new Error(`the border passes vertex ${v} twice`);
    next.set(v, w);
  }
  let loops = 0;
  const seen = new Set();
  for (const start of next.keys()) {
    if (seen.has(start)) continue;
    ++loops;
    for (let v = start; !seen.has(v); v = next.get(v)) seen.add(v);
  }
  return { euler: points.length - edgeCount + faces.length, loops };
}

// Connected components and independent cycles of a set of polylines.
export function curveTopology({ points, lines }) {
  const parent = points.map((_, i) => i);
  const find = (v) => { while (parent[v] !== v) v = parent[v] = parent[parent[v]]; return v; };
  let edges = 0;
  for (const line of lines)
    for (let i = 1; i < line.length; ++i) {
      ++edges;
      parent[find(line[i])] = find(line[i - 1]);
    }
  const components = points.filter((_, i) => find(i) === i).length;
  return { components, cycles: edges - points.length + components };
}

// the description that a binary glTF file begins with
export function readGlb(bytes) {
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
}

export function readPngSize(bytes) {
  if (bytes.readUInt32BE(0) !== 0x89504e47) throw new Error('this is no PNG file');
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}
