// The page's side of the worker: commands give promises; `cancel` ends what runs, whatever it is. A worker that breaks, or
// cannot be loaded, fails what waits for it, and the next command starts another one.

export class Canceled extends Error {}

const startWorker = () => new Worker(new URL('worker.js', import.meta.url));

export class Engine {
  constructor(onStage, onProgress, makeWorker = startWorker) {
    this.onStage = onStage;
    this.onProgress = onProgress;
    this.makeWorker = makeWorker;
    this.pending = new Map();
    this.nextId = 1;
    this.recipe = null; // what the worker has loaded, to load it again
    this.worker = null;
  }

  start() {
    const worker = this.makeWorker();
    this.worker = worker;
    worker.onmessage = ({ data }) => {
      if (data.share !== undefined) this.onProgress(data.stage, data.share);
      else if (data.stage) this.onStage(data.stage);
      else this.settle(data);
    };
    const fail = (event) => {
      event.preventDefault();
      this.abandon(Object.assign(new Error(event.message || 'the worker cannot be started'), { cause: 'workerFailed', fatal: true }));
    };
    worker.onerror = fail;
    worker.onmessageerror = fail;
  }

  stop() {
    if (!this.worker) return;
    this.worker.onmessage = null;
    this.worker.onmessageerror = null;
    this.worker.onerror = (event) => event.preventDefault();
    this.worker.terminate();
    this.worker = null;
  }

  settle({ id, result, error, cause, fatal }) {
    const entry = this.pending.get(id);
    if (!entry) return;
    this.pending.delete(id);
    if (error === undefined) {
      entry.resolve(result);
      return;
    }
    const words = fatal && !cause ? `out of memory or broken (${error})` : error;
    const failure = Object.assign(new Error(words), { cause, fatal });
    entry.reject(failure);
    if (fatal) this.abandon(failure);
  }

  // It is not started again before it is needed: one that cannot be loaded would fail without end.
  abandon(error) {
    this.stop();
    this.failAll(error);
  }

  failAll(error) {
    const waiting = [...this.pending.values()];
    this.pending.clear();
    for (const { reject } of waiting) reject(error);
  }

  get isBusy() {
    return this.pending.size > 0;
  }

  run(command, parameters = {}) {
    if (!this.worker) {
      this.start();
      if (command !== 'load') this.loadAgain();
    }
    return this.post(command, parameters);
  }

  post(command, parameters) {
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      this.pending.set(id, { resolve, reject });
      this.worker.postMessage({ id, command, ...parameters });
    });
  }

  async load(recipe) {
    const result = await this.run('load', { recipe });
    this.recipe = recipe;
    return result;
  }

  loadAgain() {
    if (this.recipe) this.post('load', { recipe: this.recipe }).catch(() => {});
  }

  // A new worker, with the mesh that the last one had, unless another one follows.
  restart(keepsMesh = true) {
    this.stop();
    this.start();
    if (keepsMesh) this.loadAgain();
  }

  // Ends all work. The mesh is loaded again, unless another one follows.
  cancel(keepsMesh = true) {
    const waiting = [...this.pending.values()];
    this.pending.clear();
    this.restart(keepsMesh);
    for (const { reject } of waiting) reject(new Canceled('canceled'));
  }
}
