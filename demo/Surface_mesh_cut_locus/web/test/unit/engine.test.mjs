import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Canceled, Engine } from '../../src/engine.js';
import { explain } from '../../src/messages.js';

// What the page says to a worker, and what it answers when the test says so.
class FakeWorker {
  constructor(log) {
    Object.assign(this, { log, isOver: false });
    log.push(this);
    this.messages = [];
  }

  postMessage(message) {
    this.messages.push(message);
  }

  terminate() {
    this.isOver = true;
  }

  answer(result) {
    const { id } = this.messages.at(-1);
    this.onmessage({ data: { id, ...result } });
  }

  fail(message) {
    this.onerror({ message, preventDefault() {} });
  }
}

function start() {
  const workers = [];
  return { workers, engine: new Engine(() => {}, () => {}, () => new FakeWorker(workers)) };
}

const commandsOf = ({ messages }) => messages.map(({ command }) => command);

test('a worker that cannot be loaded fails what waits, and is tried again by the next command alone', async () => {
  const { workers, engine } = start();
  for (let n = 1; n <= 3; ++n) {
    const loading = engine.load({ sample: 'torus' });
    assert.equal(workers.length, n);
    workers.at(-1).fail('');
    await assert.rejects(loading, (error) => error.fatal && /has stopped/.test(explain(error)));
    assert.ok(!engine.isBusy);
  }
});

test('after a crash the next command has the mesh again', async () => {
  const { workers, engine } = start();
  const loading = engine.load({ sample: 'torus' });
  workers[0].answer({ result: {} });
  await loading;
  const solving = [engine.run('solve'), engine.run('curves')];
  workers[0].fail('crashed');
  for (const promise of solving) await assert.rejects(promise, /crashed/);
  assert.ok(workers[0].isOver);
  assert.equal(workers.length, 1);
  const again = engine.run('solve');
  assert.deepEqual(commandsOf(workers[1]), ['load', 'solve']);
  workers[1].answer({ result: 7 });
  assert.equal(await again, 7);
});

test('a module that is not there, or breaks down, says so, and the worker is given up', async () => {
  for (const [cause, words] of [['notLoaded', /could not be loaded/], [undefined, /computation broke down/]]) {
    const { workers, engine } = start();
    const loading = engine.load({ sample: 'torus' });
    workers[0].answer({ error: 'unreachable', cause, fatal: true });
    await assert.rejects(loading, (error) => words.test(explain(error)));
    assert.ok(workers[0].isOver && !engine.isBusy);
  }
});

test('canceling ends all, and the mesh is loaded again', async () => {
  const { workers, engine } = start();
  const loading = engine.load({ sample: 'torus' });
  workers[0].answer({ result: {} });
  await loading;
  const solving = engine.run('solve');
  engine.cancel();
  await assert.rejects(solving, Canceled);
  assert.deepEqual(commandsOf(workers[1]), ['load']);
});
