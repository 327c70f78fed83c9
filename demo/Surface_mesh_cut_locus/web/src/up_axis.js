// Which axis points up in a mesh: files do not say, and y and z are both in use.

const bins = 32;
const leastAsymmetry = 0.02; // a mesh has as much

// Areas along an axis, and how much of them looks straight down at its low end.
function profile(positions, triangles, axis) {
  let low = Infinity, high = -Infinity;
  for (let i = axis; i < positions.length; i += 3) {
    low = Math.min(low, positions[i]);
    high = Math.max(high, positions[i]);
  }
  const areas = new Float64Array(bins);
  let total = 0, base = 0;
  const [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => 3 * triangles[t + i]);
    const u = [0, 1, 2].map((i) => positions[b + i] - positions[a + i]);
    const v = [0, 1, 2].map((i) => positions[c + i] - positions[a + i]);
    const along = u[j] * v[k] - u[k] * v[j];
    const area = Math.hypot(along, u[k] * v[axis] - u[axis] * v[k], u[axis] * v[j] - u[j] * v[axis]);
    const place = ((positions[a + axis] + positions[b + axis] + positions[c + axis]) / 3 - low) / (high - low || 1);
    areas[Math.min(Math.floor(bins * place), bins - 1)] += area;
    total += area;
    if (place < 0.03 && along < -0.95 * area) base += area;
  }
  let asymmetry = 0;
  for (let i = 0; i < bins; ++i) asymmetry += Math.abs(areas[i] - areas[bins - 1 - i]);
  return { asymmetry: Math.max(asymmetry / (2 * total || 1), leastAsymmetry), base: base / (total || 1), extent: high - low };
}

// For z against y, as logarithms of odds, by a look at 24 files: what stands is tall, has another upper than lower
// side, where a left is like a right one, and often a flat base.
const weights = { extent: 1.5, asymmetry: 0.6, base: 12 };

// Before that, files of scanners and modellers have y up; those of printers and of geologists z.
const before = { stl: 0.2, ts: 1 };
const otherwise = -0.45;

export function guessUp(positions, triangles, extension = '') {
  const y = profile(positions, triangles, 1), z = profile(positions, triangles, 2);
  const odds = weights.extent * Math.log((z.extent || 1e-3) / (y.extent || 1e-3))
    + weights.asymmetry * Math.log(z.asymmetry / y.asymmetry)
    + weights.base * (z.base - y.base) + (before[extension] ?? otherwise);
  return odds > 0 ? 'z' : 'y';
}
