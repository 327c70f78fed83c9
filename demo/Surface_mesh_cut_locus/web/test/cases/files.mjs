// Files: all that the program opens, with a line on what was repaired; others are refused in plain words.
import assert from 'node:assert/strict';
import { readFile, truncate, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { causeNames } from '../../src/arrays.js';
import { readObj, surfaceTopology } from '../topology.mjs';

const off = (points, faces) =>
  `OFF\n${points.length} ${faces.length} 0\n${points.map((p) => p.join(' ')).join('\n')}\n${faces.map((f) => `${f.length} ${f.join(' ')}`).join('\n')}\n`;

const cubePoints = [0, 1].flatMap((z) => [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]]);
const quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

const causesOfLibrary = new URL('../../../../../include/CGAL/Cut_loci/Invalid_input.h', import.meta.url);

export const tests = {
  async 'what is wrong with an input is named in the order of the library'() {
    const [, causes] = (await readFile(causesOfLibrary, 'utf8')).match(/enum class Cause \{([^}]*)\}/);
    const names = [...causes.matchAll(/^ *([A-Z_]+)/gm)].map(([, name]) => name);
    assert.deepEqual(causeNames.map((name) => name.replace(/[A-Z]/g, '_$&').toUpperCase()), names);
  },

  async 'files of all formats give the same surface'(d) {
    await d.open('#sample=torus&faces=5000');
    const points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    const faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    const lines = (rows, prefix = '') => rows.map((row) => prefix + row.join(' ')).join('\n');
    const contents = {
      'o.off': off(points, faces),
      'o.obj': `${lines(points, 'v ')}\n${lines(faces.map((f) => f.map((v) => v + 1)), 'f ')}\n`,
      'o.ply': 'ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n'
        + `element face 8\nproperty list uchar int vertex_indices\nend_header\n${lines(points)}\n${lines(faces, '3 ')}\n`,
      'o.STL': `solid o\n${faces.map((f) => 'facet normal 0 0 0\nouter loop\n'
        + `${f.map((v) => `vertex ${points[v].join(' ')}\n`).join('')}endloop\nendfacet\n`).join('')}endsolid o\n`,
      'o.ts': `GOCAD TSurf 1\nTFACE\n${points.map((p, i) => `VRTX ${i} ${p.join(' ')}`).join('\n')}\n${lines(faces, 'TRGL ')}\nEND\n`,
    };
    for (const [name, content] of Object.entries(contents)) {
      await d.openFile(name, content);
      await d.noMessage();
      assert.match(await d.page.innerText('#mesh-info'), new RegExp(`^${name}: 6 vertices, 8 faces$`));
      assert.equal((await d.result()).genus, 0);
    }
    // files have no size to choose
    assert.ok(!await d.page.locator('#faces').isVisible());
  },

  async 'what is no triangle mesh is made one, and a line says how'(d) {
    const { page } = d;
    await d.openFile('quads.off', off(cubePoints, quads));
    await d.noMessage();
    assert.match(await page.innerText('#repairs'), /Repaired: 6 polygons triangulated/);
    assert.match(await page.innerText('#mesh-info'), /8 vertices, 12 faces/);
    // one face the wrong way around, one twice
    const wrong = quads.map((q, i) => (i === 2 ? [...q].reverse() : q));
    await d.openFile('wrong.off', off(cubePoints, [...wrong, wrong[0]]));
    await d.noMessage();
    assert.match(await page.innerText('#repairs'), /face reversed|faces reversed/);
    assert.match(await page.innerText('#repairs'), /removed/);
    assert.equal((await d.result()).genus, 0);
    // three faces at an edge
    await d.openFile('book.off', off([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]]));
    await d.noMessage();
    assert.match(await page.innerText('#repairs'), /not manifold/);
    // what needs no repair says nothing
    await d.openFile('cube.off', off(cubePoints, quads.flatMap(([a, b, c, e]) => [[a, b, c], [a, c, e]])));
    assert.ok(!await page.locator('#repairs').isVisible());
  },

  async 'of several parts, the source lies on the largest'(d) {
    const shift = cubePoints.map(([x, y, z]) => [x + 40, y, z]);
    const triangles = quads.flatMap(([a, b, c, e]) => [[a, b, c], [a, c, e]]);
    const other = triangles.slice(0, 8).map((t) => t.map((v) => v + 8));
    await d.openFile('two.off', off([...cubePoints, ...shift], [...other, ...triangles]));
    assert.match(await d.page.innerText('#mesh-info'), /2 separate parts/);
    const { point } = await d.result();
    assert.ok(point[0] < 2, `the source is at ${point}`);
    await d.page.selectOption('#view', 'front');
  },

  async 'bad files are refused in plain words'(d) {
    const cases = [
      ['damaged.ply', 'ply\nthis is nothing', /cannot be read/],
      ['empty.obj', '', /is empty/],
      ['picture.gif', 'GIF89a', /must end in .off, .obj, .ply, .stl, .ts or .vtp/],
      ['flat.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n', /has an area/],
      ['points.off', 'OFF\n3 0 0\n0 0 0\n1 0 0\n2 0 0\n', /no faces/],
    ];
    for (const [name, content, words] of cases) assert.match(await d.openFile(name, content) || 'no message', words, name);
    const large = join(d.scratch, 'large.ply');
    await writeFile(large, '');
    await truncate(large, 600e6);
    await d.page.setInputFiles('#file', large);
    await d.page.waitForTimeout(200);
    assert.match(await d.page.innerText('#message-text'), /too large for a page/);
    await d.page.click('text="Torus"');
    await d.settle();
    assert.equal((await d.result()).genus, 1);
    assert.ok(!await d.page.locator('#message').isVisible());
  },

  async 'a file can be dropped on the page'(d) {
    await d.page.evaluate(() => {
      const text = 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n';
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'dropped.off'));
      const fire = (type) => document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      fire('dragenter');
      if (document.getElementById('drop').hidden) throw new Error('the page does not invite to drop');
      fire('drop');
    });
    await d.page.waitForTimeout(200);
    await d.idle();
    assert.match(await d.page.innerText('#mesh-info'), /^dropped.off: 4 vertices, 4 faces$/);
    assert.ok(!await d.page.locator('#drop').isVisible());
  },

  async 'a second file can be dropped, also while the first one is read, and of two at once one is shown'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const drop = (names) => page.evaluate((list) => {
      const faces = ['3 0 2 1', '3 0 1 3', '3 1 2 3', '3 0 3 2'].join('\n');
      const dataTransfer = new DataTransfer();
      for (const name of list) dataTransfer.items.add(new File([`OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n${faces}\n`], name));
      for (const type of ['dragenter', 'dragover', 'drop'])
        document.getElementById('model-view').dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }, names);
    const shows = async (name) => {
      await page.waitForFunction((n) => document.getElementById('mesh-info').textContent.startsWith(`${n}:`), name);
      await d.idle();
      await d.noMessage();
    };
    for (const name of ['one.off', 'two.off', 'one.off']) {
      await drop([name]);
      await shows(name);
    }
    await drop(['three.off']);
    await drop(['four.off']);
    await shows('four.off');
    await page.waitForTimeout(300);
    await shows('four.off');
    await drop(['five.off', 'six.off']);
    await shows('five.off');
    // said when the file has been read and kept
    await page.waitForFunction(() => /at a time: this is “five.off”/.test(document.getElementById('message-text').textContent));
  },

  async 'a surface with a border is taken, too'(d) {
    const n = 12;
    const points = [], faces = [];
    for (let i = 0; i <= n; ++i)
      for (let j = 0; j < n; ++j) {
        const angle = 2 * Math.PI * (j + i / 2) / n;
        points.push([Math.cos(angle), Math.sin(angle), 0.4 * i]);
        if (i === n) continue;
        const [a, b] = [i * n + j, i * n + (j + 1) % n];
        faces.push([a, b, a + n], [b, b + n, a + n]);
      }
    assert.equal(await d.openFile('tube.off', off(points, faces)), null);
    await d.unfold('result-fold');
    assert.match(await d.page.innerText('#numbers'), /borders\s*2/);
    await d.page.click('#cut');
    await d.settle();
    await d.noMessage();
    assert.deepEqual(surfaceTopology(readObj(String(await d.exported('cut', 'obj')))), { euler: 1, loops: 1 });
  },

  async 'a mesh of one’s own is there again when the page is loaded, until it is forgotten'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const torus = String(await d.exported('surface', 'obj'));
    assert.equal(await d.openFile('my torus.obj', torus), null);
    await d.click(...await d.placeOnSurface());
    const { point, length } = await d.result();
    await d.hash();
    await page.reload();
    await page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
    await d.idle();
    const again = await d.result();
    again.point.forEach((x, k) => assert.ok(Math.abs(x - point[k]) < 1e-6));
    assert.ok(Math.abs(again.length - length) < 1e-6 * length);
    assert.ok(!await page.locator('#invitation').isVisible());
    // three of them
    const hash = await d.hash();
    const small = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';
    for (const name of ['a.obj', 'b.obj']) await d.openFile(name, small);
    const kept = (name) => d.app(async ({ app }, n) => Boolean(await app.kept.get(n)), name);
    assert.ok(await kept('my torus.obj') && await kept('a.obj') && await kept('b.obj'));
    await d.openFile('c.obj', small);
    await page.waitForFunction(async () => !await window.cutLocusPage.app.kept.get('my torus.obj'));
    assert.ok(await kept('c.obj'));
    await d.unfold('about');
    await page.click('#forget');
    await page.waitForSelector('#message:not([hidden])');
    assert.ok(!await kept('c.obj'));
    await page.goto('about:blank');
    await page.goto(d.address + hash);
    await page.waitForSelector('#invitation:not([hidden])');
    assert.match(await page.innerText('#invitation'), /my torus.obj/);
  },
};
