// The surfaces that the module generates. The first source is where the surface reaches farthest in the direction
// `start`: at the side, so that most of the cut locus is seen.
export const samples = [
  { name: 'torus', label: 'Torus', start: [1, 0, 0] },
  { name: 'bumpy-sphere', label: 'Bumpy sphere', start: [1, 0.1, -0.4] },
  { name: 'genus-3', label: 'Genus 3', start: [-1, -0.1, 0] },
  { name: 'capsule', label: 'Capsule', start: [1, 0.7, 0.01] },
];

export const fileStart = [1, -0.2, 0.2];

// In its face the first source is off all symmetries, where many shortest paths would be equally long.
export const startCoordinates = [0.37, 0.34, 0.29];

export const sampleSizes = [5000, 20000, 100000, 400000];

// The face that reaches farthest in a direction, of the largest part of the mesh: `component` is that of each face.
export function farthestFace(positions, triangles, direction, component) {
  const largest = largestOf(component);
  let best = 0, farthest = -Infinity;
  for (let f = 0; f < triangles.length; f += 3) {
    if (component.length > 0 && component[f / 3] !== largest) continue;
    let sum = 0;
    for (let i = 0; i < 3; ++i)
      for (let k = 0; k < 3; ++k) sum += direction[k] * positions[3 * triangles[f + i] + k];
    if (sum > farthest) {
      farthest = sum;
      best = f / 3;
    }
  }
  return best;
}

function largestOf(component) {
  const sizes = new Map();
  for (const c of component) sizes.set(c, (sizes.get(c) || 0) + 1);
  return [...sizes].reduce((best, entry) => (entry[1] > best[1] ? entry : best), [0, -1])[0];
}
