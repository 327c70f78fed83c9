import assert from 'node:assert/strict';
import { test } from 'node:test';
import { arrowsAlong } from '../../src/arrows.js';

test('an arrow leads along its vector, and its barbs lie beside it in the surface', () => {
  const lines = arrowsAlong([0, 2, 0], [5, 6, 7], [0, 0, 1], 0.1);
  assert.equal(lines.length, 18);
  const at = (i) => [...lines.subarray(3 * i, 3 * i + 3)];
  const minus = (a, b) => a.map((x, k) => x - b[k]);
  const near = (a, b) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) < 1e-6, `${a} ${b}`));
  near(minus(at(1), at(0)), [0, 0.2, 0]);
  near(at(0), [5, 6, 7.015]);
  near(minus(at(3), at(2)), [0.03, -0.06, 0]);
  near(minus(at(5), at(4)), [-0.03, -0.06, 0]);
});

test('of many vertices, at most 6000 have one', () => {
  const zeros = new Float32Array(3 * 20001);
  const count = arrowsAlong(zeros, zeros, zeros, 1).length / 18;
  assert.ok(count > 4000 && count <= 6000, `${count}`);
});
