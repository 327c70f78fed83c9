// The files that the page itself writes; the curves are written by the library.

// The surface with the distance at its vertices, binary. Positions are those of the file, in single precision or better.
export function meshToPly({ positions, triangles, numbers }, distance) {
  const vertexCount = positions.length / 3, faceCount = triangles.length / 3;
  const header = new TextEncoder().encode(
    'ply\nformat binary_little_endian 1.0\n'
    + `element vertex ${vertexCount}\nproperty double x\nproperty double y\nproperty double z\nproperty float distance\n`
    + `element face ${faceCount}\nproperty list uchar uint vertex_indices\nend_header\n`);
  const bytes = new ArrayBuffer(header.length + 28 * vertexCount + 13 * faceCount);
  new Uint8Array(bytes).set(header);
  const view = new DataView(bytes, header.length);
  let at = 0;
  for (let v = 0; v < vertexCount; ++v) {
    for (let k = 0; k < 3; ++k, at += 8) view.setFloat64(at, numbers[k] + numbers[3] * positions[3 * v + k], true);
    view.setFloat32(at, distance ? distance[v] : NaN, true);
    at += 4;
  }
  for (let f = 0; f < faceCount; ++f) {
    view.setUint8(at, 3);
    at += 1;
    for (let k = 0; k < 3; ++k, at += 4) view.setUint32(at, triangles[3 * f + k], true);
  }
  return bytes;
}

// The cut surface: a record `v` and a record `vt`, in [0, 1], for each of its vertices.
export function atlasToObj({ positions, numbers }, { origin, triangles, uv }) {
  const lines = [];
  for (let i = 0; i < origin.length; ++i) {
    const p = [0, 1, 2].map((k) => Number((numbers[k] + numbers[3] * positions[3 * origin[i] + k]).toPrecision(9)));
    lines.push(`v ${p.join(' ')}`);
  }
  for (let i = 0; i < origin.length; ++i) lines.push(`vt ${(1 + uv[2 * i]) / 2} ${(1 + uv[2 * i + 1]) / 2}`);
  for (let f = 0; f < triangles.length; f += 3) {
    const corners = [0, 1, 2].map((k) => `${triangles[f + k] + 1}/${triangles[f + k] + 1}`);
    lines.push(`f ${corners.join(' ')}`);
  }
  lines.push('');
  return lines.join('\n');
}

export function download(content, name, type = 'application/octet-stream') {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
