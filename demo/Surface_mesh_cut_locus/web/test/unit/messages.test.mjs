// Errors, links and samples in words.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { causeNames } from '../../src/arrays.js';
import { Link } from '../../src/link.js';
import { explain, extensionOf, objectionTo } from '../../src/messages.js';
import { farthestFace } from '../../src/samples.js';
import { describeAtlas, milliseconds, rounded } from '../../src/words.js';

test('every cause of the library has words that end in a sentence', () => {
  for (const cause of causeNames) {
    const text = explain({ cause, message: 'at face #3 something is wrong' });
    assert.match(text, /^[A-Z“].*[.!?]$/s, `${cause}: ${text}`);
  }
  assert.match(explain({ cause: 'faceWithoutArea', message: 'CGAL: face #17 has no area' }), /face #17/);
  assert.match(explain({ message: 'toString' }), /^ToString\.$/); // no word of the page's own
});

test('names of causes are those of the library, in its order', async () => {
  const header = await readFile(new URL('../../../../../include/CGAL/Cut_loci/Invalid_input.h', import.meta.url), 'utf8');
  const [, body] = header.match(/enum class Cause[^{]*\{([^}]*)\}/);
  const names = body.replace(/\/\/.*/g, '').split(',').map((name) => name.trim()).filter(Boolean);
  assert.deepEqual(causeNames, names.map((name) => name.toLowerCase().replace(/_(\w)/g, (_, c) => c.toUpperCase())));
});

test('files that the page cannot read are refused before they are read', () => {
  assert.equal(extensionOf('a.b.OFF'), 'off');
  assert.equal(objectionTo({ name: 'a.obj', size: 10 }), null);
  assert.match(objectionTo({ name: 'a.docx', size: 10 }), /docx|OFF/);
  assert.match(objectionTo({ name: 'a.off', size: 1e12 }), /MB|large/);
});

test('what a link says that is not understood is named once', () => {
  assert.deepEqual(new Link([]).notes, []);
  assert.match(new Link(['x', 'x']).notes[0], /“x” is not/);
  assert.match(new Link(['x', 'y']).notes[0], /“x”, “y” are not/);
});

test('the farthest face is one of the largest part', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 0, 0, 10, 0, 0, 9, 1, 0, 0, -1, 0];
  const triangles = [0, 1, 2, 3, 4, 5, 0, 6, 1];
  assert.equal(farthestFace(positions, triangles, [1, 0, 0], [0, 1, 0]), 0);
  assert.equal(farthestFace(positions, triangles, [0, -1, 0], [0, 1, 0]), 2);
  assert.equal(farthestFace(positions, triangles, [1, 0, 0], []), 1);
});

test('lengths have as many digits as are known', () => {
  assert.equal(rounded(1.23456, 0.02), '1.23\u00a0±\u00a00.02');
  assert.equal(rounded(123.4, 20), '120\u00a0±\u00a020');
  assert.match(rounded(0.001, 0.02), /^less than/);
  assert.equal(rounded(Infinity, 0.1), '–');
  assert.deepEqual([0.04, 5.25, 250.4, 2504].map(milliseconds), ['0.0 ms', '5.3 ms', '250 ms', '2.50 s']);
});

test('a sheet that is not one to one is told what to do', () => {
  assert.match(describeAtlas([0, 0, 0, 0.1, 1, 1], 100).text, /does not overlap; areas change by 10/);
  const bad = describeAtlas([3, 0, 0, 0.1, 0, 1], 100);
  assert.ok(!bad.isInjective && /3 of 100 faces are turned over.*A source elsewhere/.test(bad.text));
});
