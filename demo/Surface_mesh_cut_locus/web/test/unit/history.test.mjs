import assert from 'node:assert/strict';
import { test } from 'node:test';
import { History } from '../../src/history.js';
import { generator } from './random.mjs';

test('steps go back and forth as a list of states does', () => {
  const { below } = generator(5);
  const history = new History();
  let states = [], at = -1;
  for (let i = 0; i < 5000; ++i) {
    const action = below(4);
    if (action < 2) {
      const state = { x: below(6) };
      history.push(state);
      if (at < 0 || states[at].x !== state.x) {
        states = [...states.slice(0, at + 1), state].slice(-100);
        at = states.length - 1;
      }
    } else if (action === 2) {
      assert.equal(history.canUndo, at > 0);
      assert.deepEqual(history.undo(), at > 0 ? states[--at] : null);
    } else {
      assert.equal(history.canRedo, at < states.length - 1);
      assert.deepEqual(history.redo(), at < states.length - 1 ? states[++at] : null);
    }
  }
});

test('a step that replaces the last one takes its place', () => {
  const history = new History();
  for (const x of [1, 2]) history.push({ x });
  history.push({ x: 3 }, true);
  assert.deepEqual(history.undo(), { x: 1 });
  assert.deepEqual(history.redo(), { x: 3 });
});
