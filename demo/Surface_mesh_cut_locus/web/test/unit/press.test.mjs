import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Press } from '../../src/press.js';

const at = (x, y, rest = {}) => ({ pointerId: 1, pointerType: 'touch', isPrimary: true, button: 0, clientX: x, clientY: y, ...rest });

test('a tap may move by ten pixels, a click of the mouse by four', () => {
  for (const [pointerType, reach] of [['touch', 10], ['mouse', 4], ['pen', 6], ['', 4]])
    for (const moved of [0, reach, reach + 1]) {
      const press = new Press();
      press.down(at(50, 50, { pointerType }));
      press.move(at(50 + moved, 50, { pointerType }));
      assert.equal(press.up(at(50 + moved, 50, { pointerType })), moved <= reach, `${pointerType} ${moved}`);
    }
});

test('one that comes back is none', () => {
  const press = new Press();
  press.down(at(50, 50));
  assert.ok(press.move(at(90, 50)));
  assert.ok(!press.up(at(50, 50)));
});

test('two fingers are none, whichever is lifted first', () => {
  for (const order of [[1, 2], [2, 1]]) {
    const press = new Press();
    press.down(at(50, 50));
    press.down(at(80, 50, { pointerId: 2, isPrimary: false }));
    assert.deepEqual(order.map((pointerId) => press.up(at(50, 50, { pointerId }))), [false, false]);
    press.down(at(50, 50));
    assert.ok(press.up(at(50, 50)));
  }
});

test('other buttons and other pointers are none', () => {
  const press = new Press();
  press.down(at(50, 50, { button: 2 }));
  assert.ok(!press.up(at(50, 50)));
  press.down(at(50, 50));
  assert.ok(!press.up(at(50, 50, { pointerId: 7 })));
  assert.ok(press.up(at(50, 50)));
});
