import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Address } from '../../src/address.js';

test('the address changes at most 100 times in 30 seconds, and has the last link in the end', async () => {
  const written = [];
  const address = new Address((hash) => written.push([performance.now(), hash]));
  const end = performance.now() + 1500;
  let last = 0;
  while (performance.now() < end) {
    address.set(`#${++last}`);
    await wait(5);
  }
  await wait(450);
  assert.equal(written.at(-1)[1], `#${last}`);
  assert.equal(written[0][1], '#1');
  for (let i = 1; i < written.length; ++i) assert.ok(written[i][0] - written[i - 1][0] >= 300, `${written.join('; ')}`);
});

test('what waits is written when it is asked for, and once', () => {
  const written = [];
  const address = new Address((hash) => written.push(hash));
  for (const hash of ['#a', '#b', '#c']) address.set(hash);
  address.flush();
  address.flush();
  assert.deepEqual(written, ['#a', '#c']);
});

test('a browser that refuses does not stop the page', () => {
  let refuses = true;
  const written = [];
  const address = new Address((hash) => {
    if (refuses) throw new Error('SecurityError');
    written.push(hash);
  });
  address.set('#a');
  refuses = false;
  address.set('#b');
  address.flush();
  assert.deepEqual(written, ['#b']);
});
