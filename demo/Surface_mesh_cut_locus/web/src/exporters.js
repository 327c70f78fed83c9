// The files that the page itself writes; the curves are written by the library. Positions are those of the file, in
// single precision or better.
import * as THREE from 'three';
import { valuesAt } from './atlas.js';

// Where no path leads, as on another part of the mesh: formats and programs that read them do not take what is not finite.
const unreached = -1;
const writable = (distance) => Float32Array.from(distance, (d) => (Number.isFinite(d) ? d : unreached));

// The surface as it is.
export function uncut({ positions, triangles, numbers }, distance) {
  return { positions, numbers, triangles, uv: null, distance: writable(distance) };
}

// Cut open; texture coordinates are in [0, 1].
export function cutOpen({ positions, numbers }, atlas, distance) {
  const { triangles, uv } = atlas;
  return {
    positions: valuesAt(atlas, positions, 3),
    numbers,
    triangles,
    uv: Float32Array.from(uv, (x) => (1 + x) / 2),
    distance: writable(valuesAt(atlas, distance)),
  };
}

const pointOf = ({ positions, numbers }, i) => [0, 1, 2].map((k) => numbers[k] + numbers[3] * positions[3 * i + k]);

const digits = (x) => Number(x.toPrecision(9));

export function toPly(surface) {
  const { triangles, uv, distance } = surface;
  const vertexCount = distance.length, faceCount = triangles.length / 3;
  const header = new TextEncoder().encode(
    'ply\nformat binary_little_endian 1.0\n'
    + `element vertex ${vertexCount}\nproperty double x\nproperty double y\nproperty double z\nproperty float distance\n`
    + `${uv ? 'property float s\nproperty float t\n' : ''}`
    + `element face ${faceCount}\nproperty list uchar uint vertex_indices\nend_header\n`);
  const bytes = new ArrayBuffer(header.length + (uv ? 36 : 28) * vertexCount + 13 * faceCount);
  new Uint8Array(bytes).set(header);
  const view = new DataView(bytes, header.length);
  let at = 0;
  const put = (x) => {
    view.setFloat32(at, x, true);
    at += 4;
  };
  for (let i = 0; i < vertexCount; ++i) {
    for (const x of pointOf(surface, i)) {
      view.setFloat64(at, x, true);
      at += 8;
    }
    put(distance[i]);
    if (uv) uv.subarray(2 * i, 2 * i + 2).forEach(put);
  }
  for (let f = 0; f < faceCount; ++f) {
    view.setUint8(at, 3);
    at += 1;
    for (let k = 0; k < 3; ++k, at += 4) view.setUint32(at, triangles[3 * f + k], true);
  }
  return bytes;
}

// A record `v`, and a record `vt` if it is cut, for each vertex.
export function toObj(surface) {
  const { triangles, uv, distance } = surface;
  const lines = [];
  for (let i = 0; i < distance.length; ++i) lines.push(`v ${pointOf(surface, i).map(digits).join(' ')}`);
  if (uv) for (let i = 0; i < distance.length; ++i) lines.push(`vt ${uv[2 * i]} ${uv[2 * i + 1]}`);
  for (let f = 0; f < triangles.length; f += 3) {
    const corners = [0, 1, 2].map((k) => (uv ? `${triangles[f + k] + 1}/${triangles[f + k] + 1}` : triangles[f + k] + 1));
    lines.push(`f ${corners.join(' ')}`);
  }
  lines.push('');
  return lines.join('\n');
}

function dataArray(name, type, components, values) {
  const size = components > 1 ? ` NumberOfComponents="${components}"` : '';
  return `<DataArray type="${type}" Name="${name}"${size} format="ascii">\n${values.join(' ')}\n</DataArray>`;
}

export function toVtp(surface) {
  const { triangles, uv, distance } = surface;
  const faceCount = triangles.length / 3;
  const points = Array.from(distance, (_, i) => pointOf(surface, i).map(digits).join(' '));
  const distances = dataArray('distance', 'Float32', 1, Array.from(distance));
  const texture = uv ? dataArray('texture', 'Float32', 2, Array.from(uv)) : '';
  return `<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData>
<Piece NumberOfPoints="${distance.length}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="${faceCount}">
<PointData Scalars="distance"${uv ? ' TCoords="texture"' : ''}>
${distances}
${texture}
</PointData>
<Points>
${dataArray('points', 'Float64', 3, points)}
</Points>
<Polys>
${dataArray('connectivity', 'UInt32', 1, Array.from(triangles))}
${dataArray('offsets', 'UInt32', 1, Array.from({ length: faceCount }, (_, f) => 3 * f + 3))}
</Polys>
</Piece>
</PolyData>
</VTKFile>
`;
}

// Binary glTF. Its texture coordinates have their origin at the top; the exporter names the distance `_DISTANCE`.
export async function toGltf(surface) {
  const { GLTFExporter } = await import('three/examples/jsm/exporters/GLTFExporter.js'); // few need it
  const { triangles, uv, distance } = surface;
  const geometry = new THREE.BufferGeometry();
  const positions = Float32Array.from({ length: 3 * distance.length }, () => 0);
  for (let i = 0; i < distance.length; ++i) positions.set(pointOf(surface, i), 3 * i);
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('distance', new THREE.BufferAttribute(Float32Array.from(distance), 1));
  if (uv) geometry.setAttribute('uv', new THREE.BufferAttribute(uv.map((x, i) => (i % 2 === 0 ? x : 1 - x)), 2));
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  const material = new THREE.MeshStandardMaterial({ color: 0xcccccc, side: THREE.DoubleSide });
  return new GLTFExporter().parseAsync(new THREE.Mesh(geometry, material), { binary: true });
}

export const writers = { ply: toPly, obj: toObj, vtp: toVtp, glb: toGltf };

export function download(content, name, type = 'application/octet-stream') {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
