// What the colors of the branches stand for: which number of a segment, from which to which value.

// On a logarithmic scale: shapes have branches of a few percent and more, finer ones are those of the mesh.
const least = 0.005, largest = 0.5;
const width = {
  quantity: 'width',
  label: 'Width of the branches',
  unit: '% of the diagonal',
  ends: [`${100 * least}`, `${100 * largest}`],
  place: (share) => Math.log(Math.max(share, 1e-9) / least) / Math.log(largest / least),
};

const angle = (label) => ({
  quantity: 'gap',
  label,
  unit: 'radians',
  ends: ['0', 'π'],
  place: (radians) => radians / Math.PI,
});

export function branchScale({ method }) {
  return method === 'laplacian' ? angle('Angle of the branches') : width;
}
