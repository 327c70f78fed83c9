// The page is a folder of static files that works below any address, and asks nobody else for anything.
import assert from 'node:assert/strict';
import { cp, mkdir, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { serve } from '../../serve.mjs';

export const tests = {
  async 'the page comes from one host and without errors'(d, { pageErrors, requests, address }) {
    assert.deepEqual(pageErrors, []);
    assert.deepEqual([...requests].filter((origin) => origin !== 'null' && !origin.startsWith('blob') && origin !== new URL(address).origin), []);
  },

  async 'it works in a folder of any host'(d, { pageFolder }) {
    const root = join(d.scratch, 'host');
    const folder = join(root, 'some', 'folder of mine');
    await mkdir(folder, { recursive: true });
    await cp(pageFolder, folder, { recursive: true });
    const { server, address } = await serve(root);
    const asked = [];
    const listen = (request) => asked.push(decodeURIComponent(new URL(request.url()).pathname));
    d.page.on('request', listen);
    try {
      await d.page.goto('about:blank');
      await d.page.goto(`${address}some/folder%20of%20mine/#sample=torus&faces=5000`);
      await d.page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
      await d.idle();
      assert.equal((await d.result()).cycles, 2);
      const names = await readdir(pageFolder);
      for (const path of asked.filter((p) => p !== 'blank' && !p.startsWith('http')))
        assert.ok(path.startsWith('/some/folder of mine/') && (path.endsWith('/') || names.includes(path.split('/').pop())), path);
      assert.ok(asked.some((path) => path.endsWith('cut_locus.wasm')));
    } finally {
      d.page.off('request', listen);
      server.close();
      await d.page.goto('about:blank');
    }
  },
};
