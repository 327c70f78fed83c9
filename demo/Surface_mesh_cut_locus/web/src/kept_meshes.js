// Meshes of one's own, kept in this browser: the last ones that were opened. A link has their name alone, and finds them here.

const most = 3;
const largest = 100e6; // bytes

const promiseOf = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

export class KeptMeshes {
  // Without a database, as where a browser does not allow one, nothing is kept.
  constructor(database = globalThis.indexedDB) {
    this.database = database;
  }

  async store(mode, action) {
    const opening = this.database.open('cut-locus', 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore('meshes', { keyPath: 'name' }).createIndex('opened', 'opened');
    const connection = await promiseOf(opening);
    try {
      return await action(connection.transaction('meshes', mode).objectStore('meshes'));
    } finally {
      connection.close();
    }
  }

  // false if it is not kept
  async put(name, bytes) {
    if (bytes.byteLength > largest) return false;
    try {
      await this.store('readwrite', async (meshes) => {
        await promiseOf(meshes.put({ name, bytes, opened: Date.now() }));
        const names = await promiseOf(meshes.index('opened').getAllKeys()); // the oldest one first
        await Promise.all(names.slice(0, -most).map((old) => promiseOf(meshes.delete(old))));
      });
      return true;
    } catch {
      return false;
    }
  }

  // the bytes of the file of that name, or null
  async get(name) {
    try {
      const mesh = await this.store('readonly', (meshes) => promiseOf(meshes.get(name)));
      return mesh ? mesh.bytes : null;
    } catch {
      return null;
    }
  }

  async clear() {
    try {
      await this.store('readwrite', (meshes) => promiseOf(meshes.clear()));
    } catch {
      // there is nothing
    }
  }
}
