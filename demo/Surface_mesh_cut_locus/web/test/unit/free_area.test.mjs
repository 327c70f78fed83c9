import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bestArea, freeAreas, freeCorner } from '../../src/free_area.js';
import { generator } from './random.mjs';

const view = { width: 800, height: 600 };

test('areas keep clear of what lies above, unless nothing is left', () => {
  const { below } = generator(11);
  for (let round = 0; round < 500; ++round) {
    const boxes = Array.from({ length: below(4) }, () => {
      const left = below(700), top = below(500);
      return { left, top, right: left + 20 + below(200), bottom: top + 20 + below(150) };
    });
    const areas = freeAreas(view, boxes);
    const isWhole = areas.length === 1 && areas[0].right - areas[0].left === 800 && areas[0].bottom - areas[0].top === 600;
    for (const area of areas) {
      assert.ok(area.left >= 0 && area.top >= 0 && area.right <= 800 && area.bottom <= 600);
      if (!isWhole)
        for (const box of boxes)
          assert.ok(box.right <= area.left || box.left >= area.right || box.bottom <= area.top || box.top >= area.bottom);
    }
  }
});

test('the middle of the best area is told from that of the view', () => {
  const { width, height, shift } = bestArea(view, [{ left: 600, top: 0, right: 800, bottom: 600 }], (size) => size.width * size.height);
  assert.deepEqual([width, height], [592, 600]);
  assert.ok(Math.abs(shift[0] - (296 / 800 - 0.5)) < 1e-12 && shift[1] === 0);
});

test('a square takes the first corner that is free, or none', () => {
  const box = (left, top, right, bottom) => ({ left, top, right, bottom });
  assert.deepEqual(freeCorner(view, 90, []), [705, 505]);
  assert.deepEqual(freeCorner(view, 90, [box(600, 500, 800, 600)]), [5, 505]);
  assert.deepEqual(freeCorner(view, 90, [box(0, 550, 800, 600)]), [705, 5]);
  assert.deepEqual(freeCorner(view, 90, [box(0, 550, 800, 600), box(790, 0, 800, 20)]), [5, 5]);
  assert.equal(freeCorner(view, 90, [box(0, 300, 800, 600), box(0, 0, 800, 20)]), null);
});
