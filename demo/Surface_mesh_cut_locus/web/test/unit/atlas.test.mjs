import assert from 'node:assert/strict';
import { test } from 'node:test';
import { coordinatesInFace, seamsOf, valuesAt } from '../../src/atlas.js';
import { sheetsOf } from '../../src/sheets.js';
import { generator } from './random.mjs';

// a square of two faces, cut along its diagonal: two sheets
const mesh = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0), triangles: Uint32Array.of(0, 1, 2, 0, 2, 3) };
const copies = [0, 1, 2, 0, 2, 3];
const atlas = {
  parents: Uint32Array.from(copies.flatMap((v) => [v, v, v])),
  weights: Float32Array.from(copies.flatMap(() => [1, 0, 0])),
  triangles: Uint32Array.of(0, 1, 2, 3, 4, 5),
  faces: Uint32Array.of(0, 1),
  border: Uint32Array.of(0, 1, 1, 2, 2, 0),
  uv: Float32Array.of(-0.9, 0, -0.1, 0, -0.1, 0.8, 0.1, 0, 0.9, 0.8, 0.1, 0.8),
};

test('a linear function on a face is the same on its parts', () => {
  const { next } = generator(7);
  for (let i = 0; i < 300; ++i) {
    // a part of the face of vertices 4, 7, 9, and a point in it
    const share = () => {
      const b = [next(), next(), next()];
      const sum = b[0] + b[1] + b[2];
      return b.map((x) => x / sum);
    };
    const corners = [4, 7, 9];
    const parts = [share(), share(), share()];
    const divided = { parents: parts.flatMap(() => corners), weights: parts.flat() };
    const values = Array.from({ length: 10 }, next);
    const inPart = share();
    const seen = valuesAt(divided, values);
    const expected = inPart.reduce((sum, b, k) => sum + b * seen[k], 0);
    const inFace = coordinatesInFace(divided, [0, 1, 2], inPart, corners);
    assert.ok(Math.abs(inFace.reduce((sum, b, k) => sum + b * values[corners[k]], 0) - expected) < 1e-6);
  }
});

test('what is not finite stays where it is', () => {
  assert.deepEqual([...valuesAt(atlas, [1, Infinity, 3, 4])], [1, Infinity, 3, 1, 3, 4]);
});

test('seams are at the same places on the surface and on the sheet', () => {
  const { seams, atlasSeams } = seamsOf(atlas, mesh.positions);
  assert.deepEqual([...seams.subarray(0, 6)], [0, 0, 0, 1, 0, 0]);
  assert.deepEqual([...atlasSeams.subarray(3, 5)], [...atlas.uv.subarray(2, 4)]);
});

test('each sheet has the number of its source, and its place', () => {
  const sources = [{ face: 1, coordinates: [0, 1, 0] }, { face: 0, coordinates: [0.2, 0.3, 0.5] }];
  const sheets = sheetsOf(atlas, mesh, sources, [0, 0, 0, 0]);
  assert.deepEqual(sheets.map(({ source, vertices }) => [source, vertices]), [[1, [0, 1, 2]], [0, [3, 4, 5]]]);
  const off = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  assert.ok(off(sheets[1].place, [0.9, 0.8]) < 1e-6, sheets[1].place);
  assert.ok(off(sheets[0].place, [-0.9 * 0.2 - 0.1 * 0.8, 0.4]) < 1e-6, sheets[0].place);
});

test('a sheet of the border has the source of most of its vertices', () => {
  const sheets = sheetsOf(atlas, mesh, [], [4, 5, 6, 6]);
  assert.deepEqual(sheets.map(({ source }) => source), [0, 6]); // of the first, no vertex is off the border
});
