// From where one looks: the sides of the mesh, and the view that shows most of a curve.
import * as THREE from 'three';

// right, forward and up, for each axis that may be up
const frames = {
  z: [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)],
  y: [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 0, -1), new THREE.Vector3(0, 1, 0)],
};

const sides = { front: [0, -1, 0], back: [0, 1, 0], left: [-1, 0, 0], right: [1, 0, 0], top: [0, -1e-4, 1], bottom: [0, -1e-4, -1] };

export const isSide = (name) => name in sides;

export const upVector = (up) => frames[up][2].clone();

// A direction from the center to the eye: at an angle around the axis, from the front, and one above the ground.
export function direction(up, around, above) {
  const [right, forward, high] = frames[up];
  const flat = Math.cos(above);
  return new THREE.Vector3()
    .addScaledVector(right, flat * Math.sin(around))
    .addScaledVector(forward, -flat * Math.cos(around))
    .addScaledVector(high, Math.sin(above));
}

export function sideDirection(up, name) {
  const [x, y, z] = sides[name];
  const [right, forward, high] = frames[up];
  return new THREE.Vector3().addScaledVector(right, x).addScaledVector(forward, y).addScaledVector(high, z).normalize();
}

// some points of the curve, evenly along it
function samplesOf(segments, count) {
  const total = segments.length / 6;
  const lengths = new Float64Array(total + 1);
  for (let i = 0; i < total; ++i) {
    const s = segments.subarray(6 * i, 6 * i + 6);
    lengths[i + 1] = lengths[i] + Math.hypot(s[3] - s[0], s[4] - s[1], s[5] - s[2]);
  }
  const points = [];
  for (let i = 0, k = 0; k < count && lengths[total] > 0; ++k) {
    while (lengths[i + 1] < (k + 0.5) / count * lengths[total]) ++i;
    const s = segments.subarray(6 * i, 6 * i + 6);
    points.push(new THREE.Vector3(s[0] + s[3], s[1] + s[4], s[2] + s[5]).multiplyScalar(0.5));
  }
  return points;
}

// How well a point is seen on a surface that faces the eye by this cosine: hardly at the rim, and behind it not at all.
const clarity = (toward) => (toward > 0.08 ? 0.85 + 0.15 * Math.min(1, 2.5 * toward) : 0);

// The direction from which most of the curve is seen, and the sources with it: points, and where the surface faces there,
// with its outer side if it has one.
export function bestDirection(probe, geometry, up, segments, sources, hasOuterSide) {
  const faceCount = geometry.index.count / 3;
  const around = faceCount > 40000 ? 8 : 16; // each is a small picture
  const camera = new THREE.PerspectiveCamera(35, 1, 1.5, 6.5);
  camera.up.copy(upVector(up));
  const points = samplesOf(segments, 160);
  const slack = 0.03;
  let best = direction(up, 0.6, 0.35), most = -Infinity;
  for (const above of [0.32, -0.15, 0.8])
    for (let i = 0; i < around; ++i) {
      const eye = direction(up, 2 * Math.PI * (i + 0.35) / around, above);
      camera.position.copy(eye).multiplyScalar(3.9);
      camera.lookAt(0, 0, 0);
      probe.look(geometry, camera, 96, 96);
      const seen = points.filter((p) => probe.sees(p, slack)).length / Math.max(points.length, 1);
      const shown = sources.reduce((sum, { point, normal }) => {
        const cosine = normal.dot(camera.position.clone().sub(point).normalize());
        const toward = hasOuterSide ? cosine : Math.abs(cosine);
        return sum + (probe.sees(point, 2 * slack, false) ? clarity(toward) : 0);
      }, 0);
      // A source that is seen counts for more than all of the curve. What is usual, a little from above and from the front,
      // is better if all else is equal.
      const score = seen + 1.25 * shown / Math.max(sources.length, 1) + 0.04 * Math.cos(2 * Math.PI * (i + 0.35) / around)
        - 0.1 * Math.abs(above - 0.32);
      if (score > most) {
        most = score;
        best = eye;
      }
    }
  return best;
}
