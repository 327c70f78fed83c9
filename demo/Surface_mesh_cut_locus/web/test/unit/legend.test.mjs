import assert from 'node:assert/strict';
import { test } from 'node:test';
import { legendItems } from '../../src/legend_items.js';
import { defaultState } from '../../src/state.js';
import { generator } from './random.mjs';

const colors = new Proxy({}, { get: (_, name) => String(name) });

function itemsOf(change = () => {}) {
  const state = defaultState();
  const scene = {
    state,
    source: { points: [[0, 0, 0]], total: 1, hasBorder: false, farthestDistance: 2 },
    curve: { numbers: [10] },
    curves: { faceCurve: {}, edgeCurve: {} },
    viewer: { colors, edgeCurve: { hiddenStyle: 'pale' } },
    appearance: { gradient: null, hasDisk: false, laplacian: null, laplacianScale: 1 },
    path: null,
    atlas: null,
    hasWave: false,
  };
  change(scene);
  return legendItems(scene).map(({ label }) => label);
}

test('what is on the screen at first has a name', () => {
  assert.deepEqual(itemsOf(), ['source', 'cut locus', 'its parts behind the surface', 'farthest point', 'equal distance, every 0.08']);
});

test('where there is no curve, none is named', () => {
  assert.ok(itemsOf((s) => { s.curve.numbers[0] = 0; }).every((label) => !label.includes('locus')));
  assert.deepEqual(itemsOf((s) => { s.curve = null; }), []);
});

test('paths, sources and sheets are told by how many there are', () => {
  assert.ok(itemsOf((s) => { s.path = { numbers: [5, 1.25] }; }).includes('the shortest path, 1.25'));
  assert.ok(itemsOf((s) => { s.path = { numbers: [5, 1.25, 4, 1.25] }; }).includes('2 shortest paths, 1.25 each'));
  const many = (s) => Object.assign(s.source, { points: [[0], [1]], total: 2 });
  assert.ok(itemsOf(many).includes('sources'));
  assert.ok(itemsOf((s) => { many(s); s.atlas = {}; }).includes('sources, and their sheets'));
});

test('whatever is shown, nothing has two names', () => {
  const { pick } = generator(13);
  for (let i = 0; i < 500; ++i) {
    const labels = itemsOf((s) => {
      for (const name of Object.keys(s.state.show)) s.state.show[name] = pick([true, false]);
      s.state.look.color = pick(['plain', 'distance', 'cells', 'laplacian']);
      s.state.look.wireframe = pick([true, false]);
      s.state.method = pick(['default', 'laplacian']);
      s.atlas = pick([null, {}]);
      s.hasWave = pick([true, false]);
      Object.assign(s.appearance, { gradient: pick([null, []]), hasDisk: pick([true, false]), laplacian: pick([null, []]) });
    });
    assert.equal(new Set(labels).size, labels.length, labels.join());
  }
});
