import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chainsOf } from '../../src/chains.js';
import { generator } from './random.mjs';

const keyOf = (p, q) => [p.join(), q.join()].sort().join(' ');

test('chains have each segment once, and end only where curves end or branch', () => {
  const { below } = generator(3);
  for (let round = 0; round < 200; ++round) {
    const edges = new Map();
    const degree = new Map();
    for (let i = below(40); i >= 0; --i) {
      const p = [below(5), below(3), 0], q = [below(5), below(3), 0];
      if (p.join() === q.join() || edges.has(keyOf(p, q))) continue;
      edges.set(keyOf(p, q), [...p, ...q]);
      for (const end of [p, q]) degree.set(end.join(), (degree.get(end.join()) || 0) + 1);
    }
    const chains = chainsOf([...edges.values()].flat());
    const found = chains.flatMap((chain) => chain.slice(1).map((q, i) => keyOf(chain[i], q)));
    assert.deepEqual(found.sort(), [...edges.keys()].sort());
    for (const chain of chains) {
      const isLoop = chain[0].join() === chain.at(-1).join();
      for (const p of chain.slice(1, -1)) assert.equal(degree.get(p.join()), 2);
      if (!isLoop) for (const p of [chain[0], chain.at(-1)]) assert.notEqual(degree.get(p.join()), 2);
    }
  }
});
