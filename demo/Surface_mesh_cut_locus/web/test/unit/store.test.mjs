import assert from 'node:assert/strict';
import { test } from 'node:test';
import { defaultState } from '../../src/state.js';
import { Store } from '../../src/store.js';

test('nobody writes into the state but by the store', () => {
  const store = new Store(defaultState());
  for (const write of [(s) => { s.isCut = true; }, (s) => { s.look.color = 'cells'; }, (s) => { delete s.show; }])
    assert.throws(() => write(store.state), TypeError);
  store.set({ sources: [{ face: 1, coordinates: [1, 0, 0] }], look: { color: 'cells' } });
  for (const write of [(s) => { s.sources[0].coordinates[0] = 2; }, (s) => { s.sources.push(0); }, (s) => { s.look.up = 'y'; }])
    assert.throws(() => write(store.state), TypeError);
});

test('views get what has changed, once, and the state as it is then', () => {
  const store = new Store(defaultState());
  const told = [];
  const end = store.subscribe((state, changed) => told.push([changed, state.look.color, state.isCut]));
  store.set({ look: { color: 'cells' } });
  store.set({ look: { color: 'cells' }, isCut: false });
  store.set({ isCut: true, look: { axes: false }, method: 'default' });
  assert.deepEqual(told, [[['look'], 'cells', false], [['isCut', 'look'], 'cells', true]]);
  assert.equal(store.state.look.up, 'auto');
  end();
  store.set({ isCut: false });
  assert.equal(told.length, 2);
});

test('what was read before stays as it was', () => {
  const store = new Store(defaultState());
  const before = store.state;
  store.set({ parameters: { width: 3 }, method: 'laplacian' });
  assert.deepEqual(before, defaultState());
  store.set({ parameters: before.parameters, method: before.method });
  assert.deepEqual(store.state, before);
});

test('not a number is as good a value as any', () => {
  const store = new Store({ group: { x: NaN }, y: -Infinity });
  let count = 0;
  store.subscribe(() => ++count);
  store.set({ group: { x: NaN }, y: -Infinity });
  assert.equal(count, 0);
  store.set({ y: null });
  assert.equal(count, 1);
});
