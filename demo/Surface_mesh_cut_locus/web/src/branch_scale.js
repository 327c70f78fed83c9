// What the colors of the branches stand for: which number of a segment, from which to which value.

// On a logarithmic scale: shapes have branches of a few percent and more, finer ones are those of the mesh.
const least = 0.005, largest = 0.5;
const width = {
  quantity: 'width',
  label: 'Width of the branches',
  ends: [`${100 * least}\u00a0%`, `${100 * largest}\u00a0% of the diagonal`],
  place: (share) => Math.log(Math.max(share, 1e-9) / least) / Math.log(largest / least),
};

const angle = (label) => ({
  quantity: 'gap',
  label,
  ends: ['0', 'π radians'],
  place: (radians) => radians / Math.PI,
});

export function branchScale({ method }) {
  return method === 'laplacian' ? angle('Angle of the branches') : width;
}
