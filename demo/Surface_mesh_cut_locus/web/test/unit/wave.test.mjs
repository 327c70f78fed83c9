import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Wave } from '../../src/wave.js';

function start() {
  const shown = [];
  let waiting = null;
  const wave = new Wave((share, isPlaying) => shown.push([share, isPlaying]), (action) => { waiting = action; });
  const frame = (now) => {
    const action = waiting;
    waiting = null;
    if (action) action(now);
    return Boolean(action);
  };
  return { wave, shown, frame };
}

test('it plays once from the start to the end', () => {
  const { wave, shown, frame } = start();
  wave.play();
  let now = 0;
  while (frame(now)) now += 100;
  assert.deepEqual(shown[0], [0, true]);
  assert.deepEqual(shown.at(-1), [1, false]);
  assert.ok(now >= 5000 && now < 5300, `${now}`);
  for (let i = 1; i < shown.length; ++i) assert.ok(shown[i][0] >= shown[i - 1][0]);
});

test('it can be stopped, moved, and goes on from there', () => {
  const { wave, shown, frame } = start();
  wave.play();
  for (const now of [0, 100, 200]) frame(now);
  wave.toggle();
  assert.ok(!shown.at(-1)[1] && shown.at(-1)[0] > 0 && shown.at(-1)[0] < 0.1);
  frame(300);
  const stopped = shown.length;
  assert.ok(!frame(400));
  assert.equal(shown.length, stopped);
  wave.moveTo(0.5);
  wave.toggle();
  frame(1000);
  frame(1100);
  assert.ok(wave.share > 0.5 && wave.share < 0.55);
});

test('a page that has been hidden does not jump, and other sources end it', () => {
  const { wave, frame } = start();
  wave.play();
  frame(0);
  frame(60000);
  assert.ok(wave.share < 0.1);
  wave.end();
  assert.deepEqual([wave.share, wave.isPlaying], [1, false]);
});
