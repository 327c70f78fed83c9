// The page is a folder of static files that works below any address, and asks nobody else for anything.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp, mkdir, readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { serve } from '../../serve.mjs';

export const tests = {
  async 'the page comes from one host and without errors'(d, { pageErrors, requests, address }) {
    assert.deepEqual(pageErrors, []);
    assert.deepEqual([...requests].filter((origin) => origin !== 'null' && !origin.startsWith('blob') && origin !== new URL(address).origin), []);
  },

  async 'the page names its version and license, and comes with its source and notices of all that is inside'(d, { pageFolder }) {
    await d.open('#sample=torus&faces=5000');
    const cmake = await readFile(new URL('../../../../../CMakeLists.txt', import.meta.url), 'utf8');
    const [, version] = cmake.match(/project\(Surface_mesh_cut_locus VERSION ([\d.]+)/);
    const text = await d.page.innerText('#license');
    assert.ok(text.includes(`Surface_mesh_cut_locus ${version}.`), text);
    assert.match(text, /GNU General Public License, version 3 or any later one, without any warranty/);
    const links = await d.page.$$eval('#license a', (list) => list.map((a) => a.getAttribute('href')));
    const read = async (link) => Buffer.from(await (await fetch(new URL(link, d.address))).arrayBuffer());
    assert.match(String(await read(links[0])), /GNU GENERAL PUBLIC LICENSE\s+Version 3/);
    const notices = String(await read(links[2]));
    for (const name of ['CGAL', 'Boost', 'Eigen', 'musl', 'Emscripten', 'three: MIT', 'three-mesh-bvh: MIT', 'd3-scale-chromatic: ISC', 'd3-interpolate: ISC', 'd3-color: ISC'])
      assert.ok(notices.includes(name), name);
    assert.ok((await read(links[1])).length > 1e5);
    const { stdout } = await promisify(execFile)('tar', ['-tzf', join(pageFolder, 'source.tar.gz')]);
    for (const file of ['LICENSE', 'include/CGAL/Surface_mesh_cut_locus.h', 'demo/Surface_mesh_cut_locus/web/src/main.js', 'scripts/viewer'])
      assert.ok(stdout.split('\n').includes(file), file);
    assert.doesNotMatch(stdout, /node_modules/);
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
