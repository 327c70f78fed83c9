// The surfaces that the module generates; `start` tells where among its faces the first source is.
export const samples = [
  { name: 'torus', label: 'Torus', start: 0 },
  { name: 'bumpy-sphere', label: 'Bumpy sphere', start: 0.3 },
  { name: 'genus-3', label: 'Genus 3', start: 0.02 },
  { name: 'capsule', label: 'Capsule', start: 0.47 },
];

export const sampleSizes = [5000, 20000, 100000, 400000];
