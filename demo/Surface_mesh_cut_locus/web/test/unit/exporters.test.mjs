import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cutOpen, toObj, toPly, toVtp, uncut } from '../../src/exporters.js';

// two triangles, one of which no path leads to
const mesh = {
  positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0]),
  triangles: new Uint32Array([0, 1, 2, 3, 4, 5]),
  numbers: [0, 0, 0, 1],
};
const distance = new Float32Array([0, 1, 1, Infinity, Infinity, NaN]);
const atlas = {
  triangles: mesh.triangles,
  uv: new Float32Array(12),
  parents: new Uint32Array([0, 1, 2, 3, 4, 5].flatMap((v) => [v, v, v])),
  weights: new Float32Array([0, 1, 2, 3, 4, 5].flatMap(() => [1, 0, 0])),
};

test('no file has a distance that is not finite', () => {
  for (const surface of [uncut(mesh, distance), cutOpen(mesh, atlas, distance)]) {
    assert.deepEqual([...surface.distance], [0, 1, 1, -1, -1, -1]);
    for (const text of [toVtp(surface), toObj(surface)]) assert.doesNotMatch(text, /inf|nan/i);
    assert.match(toVtp(surface), /Name="distance" format="ascii">\n0 1 1 -1 -1 -1\n/);
    const ply = toPly(surface);
    const header = new TextDecoder().decode(ply).indexOf('end_header\n') + 11;
    const view = new DataView(ply, header);
    const size = surface.uv ? 36 : 28;
    assert.deepEqual([0, 1, 2, 3, 4, 5].map((i) => view.getFloat32(size * i + 24, true)), [0, 1, 1, -1, -1, -1]);
  }
});
