// The page's side of the worker: commands give promises; `cancel` ends what runs, whatever it is.

export class Cancelled extends Error {}

export class Engine {
  constructor(onStage, onProgress) {
    Object.assign(this, { onStage, onProgress });
    this.pending = new Map();
    this.nextId = 1;
    this.recipe = null; // what the worker has loaded, to load it again
    this.start();
  }

  start() {
    this.worker = new Worker(new URL('worker.js', import.meta.url));
    this.worker.onmessage = ({ data }) => {
      if (data.share !== undefined) this.onProgress(data.stage, data.share);
      else if (data.stage) this.onStage(data.stage);
      else this.settle(data);
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      const message = event.message || 'the worker cannot be started';
      this.failAll(new Error(`The page cannot compute: ${message}`));
    };
  }

  settle({ id, result, error, cause, fatal }) {
    const entry = this.pending.get(id);
    if (!entry) return;
    this.pending.delete(id);
    if (error === undefined) {
      entry.resolve(result);
      return;
    }
    if (fatal) this.restart();
    entry.reject(Object.assign(new Error(fatal ? `out of memory or broken (${error})` : error), { cause, fatal }));
  }

  failAll(error) {
    for (const { reject } of this.pending.values()) reject(error);
    this.pending.clear();
  }

  get isBusy() {
    return this.pending.size > 0;
  }

  run(command, parameters = {}) {
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

  restart(keepsMesh = true) {
    // what the old worker still says is of no interest
    this.worker.onmessage = null;
    this.worker.onerror = (event) => event.preventDefault();
    this.worker.terminate();
    this.start();
    if (this.recipe && keepsMesh) this.run('load', { recipe: this.recipe }).catch(() => {});
  }

  // Ends all work. The mesh is loaded again, unless another one follows.
  cancel(keepsMesh = true) {
    const pending = [...this.pending.values()];
    this.pending.clear();
    this.restart(keepsMesh);
    for (const { reject } of pending) reject(new Cancelled('cancelled'));
  }
}
