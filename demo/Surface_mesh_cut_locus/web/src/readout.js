// The values at a point of the surface: nearest vertex, distance, angle between the gradients around it, and the nearest
// branch.
import { number } from './words.js';

export class Readout {
  setMesh(positions, triangles) {
    this.positions = positions;
    this.triangles = triangles;
    this.start = null;
  }

  // the faces of each vertex, when they are first asked for
  facesOf(v) {
    const { triangles } = this;
    if (!this.start) {
      this.start = new Uint32Array(this.positions.length / 3 + 1);
      for (const w of triangles) ++this.start[w + 1];
      for (let i = 1; i < this.start.length; ++i) this.start[i] += this.start[i - 1];
      const next = this.start.slice();
      this.faces = new Uint32Array(triangles.length);
      triangles.forEach((w, i) => { this.faces[next[w]++] = Math.floor(i / 3); });
    }
    return this.faces.subarray(this.start[v], this.start[v + 1]);
  }

  // of unit length, of the function that is linear on the face; null if there is none
  gradient(face, distance) {
    const [a, b, c] = [0, 1, 2].map((k) => this.triangles[3 * face + k]);
    const p = (v, k) => this.positions[3 * v + k];
    const u = [0, 1, 2].map((k) => p(b, k) - p(a, k)), v = [0, 1, 2].map((k) => p(c, k) - p(a, k));
    const dot = (x, y) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    const [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
    const du = distance[b] - distance[a], dv = distance[c] - distance[a];
    const det = uu * vv - uv * uv;
    if (!(det > 0) || !Number.isFinite(du + dv)) return null;
    const s = (vv * du - uv * dv) / det, t = (uu * dv - uv * du) / det;
    const g = [0, 1, 2].map((k) => s * u[k] + t * v[k]);
    const norm = Math.hypot(...g);
    return norm > 0 ? g.map((x) => x / norm) : null;
  }

  largestAngle(v, distance) {
    const gradients = Array.from(this.facesOf(v), (f) => this.gradient(f, distance)).filter(Boolean);
    let least = 1;
    for (let i = 0; i < gradients.length; ++i)
      for (let j = 0; j < i; ++j)
        least = Math.min(least, gradients[i][0] * gradients[j][0] + gradients[i][1] * gradients[j][1] + gradients[i][2] * gradients[j][2]);
    return Math.acos(Math.max(least, -1));
  }

  // `radius` is the unit of the view in that of the file
  values({ face, coordinates, place, pixel }, distance, curve, radius) {
    const vertices = [0, 1, 2].map((k) => this.triangles[3 * face + k]);
    const vertex = vertices[coordinates.indexOf(Math.max(...coordinates))];
    const nearest = curve && nearestSegment(curve.segments, place);
    return {
      vertex,
      distance: coordinates.reduce((sum, b, k) => sum + b * distance[vertices[k]], 0),
      angle: this.largestAngle(vertex, distance),
      branch: nearest && { ...nearest, away: nearest.away * radius, isHere: nearest.away < 2 * pixel, width: curve.width[nearest.segment], gap: curve.gap[nearest.segment] },
    };
  }
}

// The segment nearest to a point in space, and where.
export function nearestSegment(segments, p) {
  let best = null, least = Infinity;
  for (let i = 0; i < segments.length; i += 6) {
    let dot = 0, square = 0;
    for (let k = 0; k < 3; ++k) {
      const along = segments[i + 3 + k] - segments[i + k];
      dot += along * (p[k] - segments[i + k]);
      square += along * along;
    }
    const t = square > 0 ? Math.min(Math.max(dot / square, 0), 1) : 0;
    let off = 0;
    for (let k = 0; k < 3; ++k) off += (segments[i + k] + t * (segments[i + 3 + k] - segments[i + k]) - p[k]) ** 2;
    if (off < least) [least, best] = [off, { segment: i / 6, t }];
  }
  if (!best) return null;
  const at = 6 * best.segment;
  return {
    ...best,
    away: Math.sqrt(least),
    place: [0, 1, 2].map((k) => segments[at + k] + best.t * (segments[at + 3 + k] - segments[at + k])),
  };
}

// The library gives it in the place of an angle where no branch is, but cells of two sources meet.
const gapBetweenSources = 2 * Math.PI;

function describeBranch({ gap, width }, isLaplacian) {
  if (gap > gapBetweenSources - 0.01) return 'between two sources';
  return isLaplacian ? `angle ${degrees(gap)}` : `${number(100 * width)} % wide`;
}

const degrees = (radians) => `${Math.round(180 / Math.PI * radians)}°`;

export function describeValues({ vertex, distance, angle, branch }, isLaplacian) {
  const lines = [
    `vertex ${vertex}`,
    Number.isFinite(distance) ? `${number(distance, 4)} from the source` : 'not connected to the source',
    `gradients around it up to ${degrees(angle)} apart`,
  ];
  if (branch)
    lines.push(`${branch.isHere ? 'on a branch' : `nearest branch ${number(branch.away)} away`}, ${describeBranch(branch, isLaplacian)}`);
  return lines.join('\n');
}
