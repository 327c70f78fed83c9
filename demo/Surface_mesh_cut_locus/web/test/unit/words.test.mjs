// What the numbers say in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { describeAtlas, numberRows } from '../../src/words.js';

function radiusRow(radius, least, edges = 10) {
  const rows = numberRows({
    curve: { numbers: [edges, 0, 2, 0, 3, radius, 0, 0, 0, 0, 0, least] },
    source: { total: 1, hasBorder: false, borderLoops: 0, genus: 0, farthestDistance: 2 },
    edgeLength: 0.01,
    state: { method: 'default', parameters: { width: null } },
    defaults: { width: 0 },
  });
  return rows.find(([name]) => name === 'injectivity radius');
}

test('the radius is told with what weak branches leave open', () => {
  assert.match(radiusRow(1.5, 0.25)[2], /with all weak branches at least 0\.25$/);
});

test('there is nothing to add where it is not known, or no nearer', () => {
  for (const least of [0, 1.5, 1.4999]) assert.doesNotMatch(radiusRow(1.5, least)[2], /weak/);
  assert.deepEqual(radiusRow(1.5, 0.25, 0).slice(1), ['–', '']);
});

test('a sheet with true distances says so, and what that costs', () => {
  const { isInjective, text } = describeAtlas([3, 12, 0.01, 0.25, 0, 1], 5000, 'logmap');
  assert.equal(isInjective, false);
  assert.match(text, /^Distances from the source are true; 12 of 5,000 faces lie over others, on 1\u00a0% of it; 3 of 5,000 .*; areas change by 25\u00a0%\.$/);
});
