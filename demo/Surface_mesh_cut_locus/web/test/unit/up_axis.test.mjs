import assert from 'node:assert/strict';
import { test } from 'node:test';
import { guessUp } from '../../src/up_axis.js';

// Ellipsoids at [center, radii], with z up and the front toward -y.
function figure(parts, turn = (p) => p) {
  const positions = [], triangles = [];
  const rings = 16, around = 24;
  for (const [center, radii] of parts) {
    const first = positions.length / 3;
    for (let i = 0; i <= rings; ++i)
      for (let j = 0; j < around; ++j) {
        const [a, b] = [Math.PI * i / rings, 2 * Math.PI * j / around];
        const unit = [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)];
        positions.push(...turn(unit.map((x, k) => center[k] + radii[k] * x)));
        if (i === rings) continue;
        const at = (m, n) => first + m * around + n % around;
        triangles.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return [new Float32Array(positions), new Uint32Array(triangles)];
}

const yUp = ([x, y, z]) => [x, z, -y];

const figures = {
  person: [[[0, 0, 1.7], [0.12, 0.14, 0.16]], [[0, 0, 1.1], [0.28, 0.16, 0.45]], [[-0.12, 0, 0.4], [0.1, 0.1, 0.45]], [[0.12, 0, 0.4], [0.1, 0.1, 0.45]],
    [[-0.12, -0.1, 0], [0.07, 0.16, 0.05]], [[0.12, -0.1, 0], [0.07, 0.16, 0.05]]],
  bust: [[[0, 0, 1], [0.4, 0.45, 0.5]], [[0, -0.42, 0.95], [0.1, 0.12, 0.1]], [[0, 0.05, 0.35], [0.75, 0.4, 0.28]], [[-0.45, 0, 1.05], [0.2, 0.05, 0.15]],
    [[0.45, 0, 1.05], [0.2, 0.05, 0.15]]],
  cow: [[[0, 0, 1], [1, 0.35, 0.4]], [[-1, 0, 1.4], [0.35, 0.2, 0.25]], ...[-0.6, 0.6].flatMap((x) => [-0.2, 0.2].map((y) => [[x, y, 0.4], [0.1, 0.1, 0.5]]))],
};

test('what stands is seen standing, whichever axis is up', () => {
  for (const [name, parts] of Object.entries(figures)) {
    assert.equal(guessUp(...figure(parts)), 'z', name);
    assert.equal(guessUp(...figure(parts, yUp)), 'y', name);
  }
});

test('where nothing tells, the kind of the file does', () => {
  const ball = figure([[[0, 0, 0], [1, 1, 1]]]);
  for (const [extension, up] of [['obj', 'y'], ['off', 'y'], ['stl', 'z'], ['ts', 'z']]) assert.equal(guessUp(...ball, extension), up, extension);
});

test('a mesh that is flat, or has no faces, is taken', () => {
  for (const positions of [[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 0, 0, 0, 0]])
    assert.match(guessUp(new Float32Array(positions), new Uint32Array([0, 1, 2])), /^[yz]$/);
  assert.match(guessUp(new Float32Array(0), new Uint32Array(0)), /^[yz]$/);
});
