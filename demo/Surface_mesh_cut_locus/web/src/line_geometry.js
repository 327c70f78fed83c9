// Wide lines for three.js's LineMaterial. A graphics card draws an instance for each segment. Drawing in software, browsers take as
// long for an instance as for hundreds of vertices: then all vertices of each segment are in the buffers.
import * as THREE from 'three';

// around a segment: the half of a round end, the two halves of the line, and the other end
const corners = [[-1, 2], [1, 2], [-1, 1], [1, 1], [-1, 0], [1, 0], [-1, -1], [1, -1]];
const texture = [-1, 2, 1, 2, -1, 1, 1, 1, -1, -1, 1, -1, -1, -2, 1, -2];
const triangles = [0, 2, 1, 2, 3, 1, 2, 4, 3, 4, 5, 3, 4, 6, 5, 6, 7, 5];
const trianglesWithoutEnds = triangles.slice(6, 12);
const positions = corners.flatMap(([x, y]) => [x, y, 0]);
const size = corners.length;

function repeated(pattern, count) {
  const result = new Float32Array(pattern.length * count);
  for (let i = 0; i < count; ++i) result.set(pattern, i * pattern.length);
  return new THREE.BufferAttribute(result, pattern.length / size);
}

function indices(pattern, count) {
  const result = new Uint32Array(pattern.length * count);
  for (let i = 0; i < count; ++i)
    for (let k = 0; k < pattern.length; ++k) result[pattern.length * i + k] = size * i + pattern[k];
  return new THREE.BufferAttribute(result, 1);
}

// the first three of six numbers of each segment, or the other three, at all of its vertices
function fill(result, values, end) {
  for (let i = 0; i < values.length / 6; ++i)
    for (let k = 0; k < size; ++k)
      for (let c = 0; c < 3; ++c) result[3 * (size * i + k) + c] = values[6 * i + 3 * end + c];
  return result;
}

const ofEnd = (values, end, count) => new THREE.BufferAttribute(fill(new Float32Array(3 * size * count), values, end), 3);

// Whether there is a graphics card, as far as browsers tell.
export function hasCard(gl) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return !/swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function instancedGeometry(segments, colors, pattern, hasRoom) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex(pattern);
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('uv', new THREE.Float32BufferAttribute(texture, 2));
  const add = (name, values) => {
    const array = new Float32Array((hasRoom ? 2 : 1) * values.length);
    array.set(values);
    const buffer = new THREE.InstancedInterleavedBuffer(array, 6, 1);
    for (const [end, suffix] of ['Start', 'End'].entries())
      geometry.setAttribute(name + suffix, new THREE.InterleavedBufferAttribute(buffer, 3, 3 * end));
  };
  add('instance', segments);
  if (colors) add('instanceColor', colors);
  geometry.instanceCount = segments.length / 6;
  return geometry;
}

// Six numbers for each segment: its ends, and, if given, the colors there. There may be room for more of them. Round ends
// have two thirds of the triangles, and can be left out.
export function lineGeometry(segments, colors = null, { isInstanced = false, hasRoom = false, hasEnds = true } = {}) {
  const pattern = hasEnds ? triangles : trianglesWithoutEnds;
  if (isInstanced) return instancedGeometry(segments, colors, pattern, hasRoom);
  const count = (hasRoom ? 2 : 1) * segments.length / 6;
  const geometry = new THREE.BufferGeometry();
  geometry.userData.indicesOfSegment = pattern.length;
  geometry.setIndex(indices(pattern, count));
  geometry.setAttribute('position', repeated(positions, count));
  geometry.setAttribute('uv', repeated(texture, count));
  for (const [end, name] of ['Start', 'End'].entries()) {
    geometry.setAttribute(`instance${name}`, ofEnd(segments, end, count));
    if (colors) geometry.setAttribute(`instanceColor${name}`, ofEnd(colors, end, count));
  }
  setShown(geometry, segments.length / 6);
  return geometry;
}

// Of the segments, only so many of the first ones are drawn.
export function setShown(geometry, count) {
  if (geometry.isInstancedBufferGeometry) geometry.instanceCount = count;
  else geometry.setDrawRange(0, geometry.userData.indicesOfSegment * count);
}

function write(buffer, length) {
  buffer.clearUpdateRanges();
  buffer.addUpdateRange(0, length);
  buffer.needsUpdate = true;
}

// Other segments, without colors, if there is room for them. Only these are sent to the graphics card.
export function refill(geometry, segments) {
  const starts = geometry.getAttribute('instanceStart');
  const copies = geometry.isInstancedBufferGeometry ? 1 : size; // of each segment
  if (!starts || starts.count * 6 < copies * segments.length) return false;
  if (geometry.isInstancedBufferGeometry) {
    starts.data.array.set(segments);
    write(starts.data, segments.length);
  } else {
    for (const [end, attribute] of [starts, geometry.getAttribute('instanceEnd')].entries()) {
      fill(attribute.array, segments, end);
      write(attribute, size * segments.length / 2);
    }
  }
  setShown(geometry, segments.length / 6);
  return true;
}
