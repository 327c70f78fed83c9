// Drives the page in a browser as a user does: test_page.mjs PAGE_FOLDER [PICTURE_FOLDER [TESTS]]
// TESTS is a regular expression that the names of the tests to run match.
import assert from 'node:assert/strict';
import { mkdir, mkdtemp, readFile, rm, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';
import { serve } from '../serve.mjs';
import { curveTopology, readObj, surfaceTopology } from './topology.mjs';

const [pageFolder, pictureFolder, wanted = ''] = process.argv.slice(2);
const patience = 120000; // milliseconds: machines of continuous integration are slow

const scratch = await mkdtemp(join(tmpdir(), 'cut_locus_page_'));
const { server, address } = await serve(pageFolder);
const context = await openBrowser(join(scratch, 'profile'));
const page = context.pages()[0] || await context.newPage();
page.setDefaultTimeout(patience);
const pageErrors = [];
const requests = new Set();
page.on('pageerror', (error) => pageErrors.push(error.message));
page.on('request', (request) => requests.add(new URL(request.url()).origin));

const idle = () => page.waitForFunction(() => document.body.dataset.busy === 'false', null, { timeout: patience });
const result = () => page.evaluate(() => {
  const { app } = window.cutLocusPage;
  const curve = app.curves[app.shownCurve];
  if (!curve) throw new Error(`there is no curve: ${document.getElementById('message').innerText}`);
  const [edges, cycles, leaves, , length, radius] = curve.numbers;
  return { edges, cycles, leaves, length, radius, genus: app.source.genus, point: app.source.point, times: app.times };
});

async function setWidth(percent) {
  await page.fill('#width-number', percent);
  await page.waitForFunction((w) => window.cutLocusPage.app.drawn.width === Number(w)
    && !window.cutLocusPage.app.isUpdating, percent, { timeout: patience });
  await idle();
}

async function open(hash) {
  await page.goto('about:blank');
  await page.goto(address + hash);
  await page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved, null, { timeout: patience });
  await idle();
}

async function openFile(name, content) {
  const path = join(scratch, name);
  await writeFile(path, content);
  await page.setInputFiles('#file', path);
  await page.waitForTimeout(200);
  await idle();
  return (await page.locator('#message').isVisible()) ? page.locator('#message-text').innerText() : null;
}

async function exported(kind) {
  await page.selectOption('#export-kind', kind);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export')]);
  return readFile(await download.path());
}

async function picture(name) {
  await page.waitForTimeout(300);
  const file = pictureFolder ? { path: join(pictureFolder, name) } : {};
  return page.screenshot(file);
}

const tests = {
  async 'a sample is loaded and has the cycles of its genus'() {
    await open('#sample=torus&faces=5000');
    const { genus, cycles } = await result();
    assert.deepEqual({ genus, cycles }, { genus: 1, cycles: 2 });
    for (const [name, expected] of [['Genus 3', 3], ['Capsule', 0], ['Bumpy sphere', 0], ['Torus', 1]]) {
      await page.click(`text="${name}"`);
      await page.waitForTimeout(100);
      await idle();
      const found = await result();
      assert.deepEqual([name, found.genus, found.cycles], [name, expected, 2 * expected]);
    }
  },

  async 'a click puts the source where it is'() {
    const before = await result();
    const box = await page.locator('#canvas').boundingBox();
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.72 * box.height);
    await page.waitForTimeout(100);
    await idle();
    const after = await result();
    assert.notDeepEqual(after.point, before.point);
    const distanceToRay = await page.evaluate(() => {
      const { viewer } = window.cutLocusPage;
      const seen = viewer.sourceMarker.position.clone().project(viewer.camera);
      return Math.hypot(seen.x, seen.y - (1 - 2 * 0.72));
    });
    assert.ok(distanceToRay < 0.01, `the source is ${distanceToRay} off the click`);
    assert.equal(after.cycles, 2);
  },

  async 'a drag turns the model and leaves the source'() {
    const before = await result();
    const view = await page.evaluate(() => window.cutLocusPage.viewer.getView());
    const box = await page.locator('#canvas').boundingBox();
    await page.mouse.move(box.x + 300, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 420, box.y + 340, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(200);
    assert.deepEqual((await result()).point, before.point);
    assert.notDeepEqual(await page.evaluate(() => window.cutLocusPage.viewer.getView()), view);
  },

  async 'a smaller width gives more branches, also those that were not computed, and the same cycles'() {
    assert.ok(await page.isChecked('#width-auto'));
    const standard = await result();
    const shown = Number(await page.inputValue('#width-number'));
    assert.ok(shown > 0.1 && shown < 20, `by default ${shown} %`);
    assert.match(await page.innerText('#width-note'), new RegExp(`Automatic: ${shown} %`));
    assert.equal(await page.getAttribute('#width', 'aria-valuetext'), `${shown} % of the diagonal`);
    const found = [];
    for (const width of ['50', '20', String(shown), '0.3', '0.02']) {
      await setWidth(width);
      found.push(await result());
      assert.equal(found.at(-1).cycles, 2);
    }
    const edges = found.map((f) => f.edges), lengths = found.map((f) => f.length);
    for (let i = 1; i < found.length; ++i) assert.ok(lengths[i] >= lengths[i - 1] - 1e-9, `lengths ${lengths}`);
    assert.ok(Math.abs(lengths[2] - standard.length) < 1e-2 * standard.length, `lengths ${lengths}, ${standard.length}`);
    assert.ok(edges[4] > 2 * edges[2], `edges ${edges}`);
    assert.ok(!await page.isChecked('#width-auto'));
    await page.fill('#width-number', '1000');
    await page.keyboard.press('Tab');
    assert.equal(await page.inputValue('#width-number'), '50');
    await page.click('#defaults');
    await page.waitForFunction(() => window.cutLocusPage.app.drawn.width === null && !window.cutLocusPage.app.isUpdating);
    assert.equal((await result()).edges, standard.edges);
  },

  async 'all methods and all solvers give the cycles of the torus'() {
    const { leaves } = await result();
    for (const [solver, method] of [['exact', 'laplacian'], ['heat', null], ['graph', null], ['exact', 'polyhedral'],
      ['exact', 'direction']]) {
      await page.selectOption('#solver', solver);
      await page.waitForTimeout(50);
      await idle();
      assert.equal(await page.locator('#method').isDisabled(), solver !== 'exact');
      if (method) await page.selectOption('#method', method);
      await page.waitForTimeout(50);
      await idle();
      assert.equal(await page.inputValue('#method'), method || 'laplacian');
      assert.equal(await page.locator('#width').isVisible(), ['direction', 'polyhedral'].includes(method));
      const found = await result();
      assert.deepEqual([solver, method, found.cycles], [solver, method, 2]);
      if (method !== 'polyhedral') continue;
      assert.ok(found.leaves > leaves + 100, `${found.leaves} leaves for ${leaves}`);
      assert.match(await page.innerText('#width-note'), /all branches/);
      await setWidth('20');
      assert.ok((await result()).leaves < leaves + 10);
      await page.click('#defaults');
      await idle();
    }
    // a solver of distances does not change the method for the others
    await page.selectOption('#solver', 'heat');
    await page.selectOption('#solver', 'exact');
    await page.waitForTimeout(50);
    await idle();
    assert.equal(await page.inputValue('#method'), 'direction');
  },

  async 'a plain polyhedron stands for itself'() {
    const corners = [0, 1].flatMap((z) => [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]]);
    const faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7],
      [2, 7, 6], [3, 0, 4], [3, 4, 7]];
    const cube = `OFF\n8 12 0\n${corners.map((c) => c.join(' ')).join('\n')}\n${faces.map((f) => `3 ${f.join(' ')}`).join('\n')}\n`;
    assert.equal(await openFile('cube.off', cube), null);
    assert.match(await page.innerText('#width-note'), /a gap of 0.5 radians/);
    assert.equal(await page.inputValue('#width-number'), '');
    const { edges, leaves } = await result();
    assert.ok(edges >= 8 && leaves >= 4, `${edges} edges, ${leaves} leaves`);
    await page.check('#show-width');
    assert.match(await page.innerText('#legend-scale'), /π radians/);
    await page.selectOption('#method', 'polyhedral');
    await page.waitForTimeout(100);
    await idle();
    assert.match(await page.innerText('#legend-scale'), /0.5\s%[^]*50\s% of the diagonal/);
    assert.equal((await result()).cycles, 0);
    await page.uncheck('#show-width');
    assert.ok(!await page.locator('#legend-scale').isVisible());
  },

  async 'a cut locus without branches is explained'() {
    await open('#sample=torus&faces=5000');
    assert.ok(!await page.locator('#result-note').isVisible());
    assert.equal(await openFile('square.off', 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n'), null);
    assert.match(await page.innerText('#result-note'), /no branches: either all shortest paths end at the border/);
    assert.match(await page.innerText('#numbers'), /injectivity radius\s*–/);
  },

  async 'all layers can be shown at once'() {
    await open('#sample=torus&faces=5000');
    await page.uncheck('#show-hidden');
    for (const name of ['hidden', 'edgeCurve', 'width', 'laplacian', 'gradient', 'disk']) {
      const before = await picture('layer.png');
      await page.check(`#show-${name}`);
      await page.waitForTimeout(200);
      await idle();
      assert.ok(!before.equals(await picture('layer.png')), `${name} is not seen`);
    }
    await picture('layers_wide.png');
    await page.setViewportSize({ width: 800, height: 700 });
    await picture('layers_narrow.png');
    await page.setViewportSize({ width: 390, height: 844 });
    await picture('layers_phone.png');
    const height = async () => (await page.locator('#canvas').boundingBox()).height;
    assert.ok(await height() > 450, `the canvas has ${await height()} pixels`);
    await page.click('#panel-toggle');
    await page.waitForTimeout(100);
    assert.ok(await height() > 760, `the canvas has ${await height()} pixels`);
    await picture('layers_phone_folded.png');
    await page.click('#panel-toggle');
    assert.ok(await page.locator('#method').isVisible());
    await page.setViewportSize({ width: 1440, height: 900 });
  },

  async 'the curve is exported whole'() {
    await open('#sample=torus&faces=5000');
    const { edges, cycles } = await result();
    const obj = readObj(String(await exported('polylines-obj')));
    assert.deepEqual(curveTopology(obj), { components: 1, cycles });
    assert.equal(obj.lines.reduce((sum, line) => sum + line.length - 1, 0), edges);
    const ply = String(await exported('polylines-ply'));
    assert.match(ply, new RegExp(`^ply\\nformat ascii 1.0\\n[^]*element edge ${edges}\\n`));
    assert.ok(String(await exported('polylines-txt')).split('\n').length > 2);
    const surface = await exported('mesh-ply');
    assert.match(surface.subarray(0, 300).toString('latin1'), /element vertex 2560\n/);
    assert.deepEqual([...(await exported('png')).subarray(1, 4)], [0x50, 0x4e, 0x47]);
  },

  async 'the surface is cut to a disk with texture coordinates'() {
    for (const sample of ['torus', 'genus-3', 'bumpy-sphere']) {
      await open(`#sample=${sample}&faces=5000`);
      await page.click('#cut');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas, null, { timeout: patience });
      await idle();
      const mesh = readObj(String(await exported('atlas-obj')));
      assert.deepEqual(surfaceTopology(mesh), { euler: 1, loops: 1 });
      assert.equal(mesh.textureCoordinates.length, mesh.points.length);
      assert.ok(mesh.textureCoordinates.every((uv) => uv.every((x) => x >= -1e-6 && x <= 1 + 1e-6)));
      await picture(`atlas_${sample}.png`);
    }
    await page.click('#cut');
    assert.equal(await page.evaluate(() => window.cutLocusPage.app.atlas), null);
  },

  async 'a link restores what was seen'() {
    await open('#sample=torus&faces=5000');
    const box = await page.locator('#canvas').boundingBox();
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.72 * box.height);
    await page.waitForTimeout(100);
    await idle();
    await page.selectOption('#method', 'laplacian');
    await page.waitForTimeout(100);
    await idle();
    await page.fill('#angle-number', '1.1');
    await page.check('#show-disk');
    await page.waitForTimeout(600);
    await idle();
    const before = await result();
    const hash = await page.evaluate(() => location.hash);
    await open(hash);
    const after = await result();
    assert.equal(after.edges, before.edges);
    assert.equal(after.length, before.length);
    assert.equal(await page.inputValue('#angle-number'), '1.1');
    assert.ok(await page.isChecked('#show-disk'));
    assert.equal(await page.evaluate(() => location.hash), hash);
  },

  async 'a link restores the width, and an old one with a strength opens'() {
    await open('#sample=torus&faces=5000&method=polyhedral&width=0.5&show=width');
    assert.equal(await page.inputValue('#width-number'), '0.5');
    assert.equal(await page.inputValue('#method'), 'polyhedral');
    assert.ok(await page.isChecked('#show-width'));
    const fine = await result();
    await open('#sample=torus&faces=5000&method=direction&width=0.5');
    const same = await result();
    assert.ok(Math.abs(same.length - fine.length) < 1e-2 * fine.length, `${same.length}, ${fine.length}`);
    await open('#sample=torus&faces=5000&solver=exact&method=direction&strength=7&show=strength,disk');
    assert.ok(!await page.locator('#message').isVisible());
    assert.ok(await page.isChecked('#width-auto'));
    assert.ok(await page.isChecked('#show-disk'));
    assert.doesNotMatch(await page.evaluate(() => location.hash), /strength/);
  },

  async 'a link to a file says so until it is opened'() {
    await page.goto('about:blank');
    await page.goto(`${address}#file=square.off&solver=exact&method=polyhedral`);
    await page.waitForTimeout(5000);
    assert.match(await page.innerText('#message-text'), /about the file “square.off”/);
    assert.equal(await openFile('square.off', 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n'), null);
    assert.equal(await page.inputValue('#method'), 'polyhedral');
  },

  async 'files of all formats give the same surface'() {
    const points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    const faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    const lines = (rows, prefix = '') => rows.map((row) => prefix + row.join(' ')).join('\n');
    const files = {
      'o.off': `OFF\n6 8 0\n${lines(points)}\n${lines(faces, '3 ')}\n`,
      'o.obj': `${lines(points, 'v ')}\n${lines(faces.map((f) => f.map((v) => v + 1)), 'f ')}\n`,
      'o.ply': 'ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n'
        + `element face 8\nproperty list uchar int vertex_indices\nend_header\n${lines(points)}\n${lines(faces, '3 ')}\n`,
      'o.STL': `solid o\n${faces.map((f) => 'facet normal 0 0 0\nouter loop\n'
        + `${f.map((v) => `vertex ${points[v].join(' ')}\n`).join('')}endloop\nendfacet\n`).join('')}endsolid o\n`,
    };
    for (const [name, content] of Object.entries(files)) {
      assert.equal(await openFile(name, content), null, name);
      assert.match(await page.innerText('#mesh-info'), new RegExp(`^${name}: 6 vertices, 8 faces$`));
      assert.equal((await result()).genus, 0);
    }
  },

  async 'a file can be dropped on the page'() {
    await open('#sample=torus&faces=5000');
    await page.evaluate(() => {
      const text = 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n';
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'dropped.off'));
      const fire = (type) => document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      fire('dragenter');
      if (document.getElementById('drop').hidden) throw new Error('the page does not invite to drop');
      fire('drop');
    });
    await page.waitForTimeout(200);
    await idle();
    assert.match(await page.innerText('#mesh-info'), /^dropped.off: 4 vertices, 4 faces$/);
    assert.ok(!await page.locator('#drop').isVisible());
  },

  async 'a frame in which only the curve changes shows the same as a whole one'() {
    await open('#sample=torus&faces=5000&show=isolines');
    await setWidth('30');
    const canvas = (redraws) => page.evaluate(async (isWhole) => {
      const { viewer } = window.cutLocusPage;
      if (isWhole) viewer.layer.isValid = false;
      const blob = await viewer.toPng();
      return [...new Uint8Array(await crypto.subtle.digest('SHA-256', await blob.arrayBuffer()))].join();
    }, redraws);
    const kept = await canvas(false);
    assert.equal(kept, await canvas(true));
    await setWidth('0.5');
    assert.notEqual(kept, await canvas(false));
  },

  async 'bad files are refused in plain words'() {
    const cases = [
      ['quads.off', 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n', /not a triangle mesh: face #0 has 4 sides/],
      ['book.off', 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n', /more than two faces/],
      ['damaged.ply', 'ply\nthis is nothing', /cannot be read/],
      ['empty.obj', '', /is empty/],
      ['picture.gif', 'GIF89a', /must end in .off, .obj, .ply or .stl/],
      ['flat.off', 'OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 0 2 3\n', /has no area/],
    ];
    for (const [name, content, words] of cases) assert.match(await openFile(name, content) || 'no message', words, name);
    const large = join(scratch, 'large.ply');
    await writeFile(large, '');
    await truncate(large, 600e6);
    await page.setInputFiles('#file', large);
    await page.waitForTimeout(200);
    assert.match(await page.innerText('#message-text'), /too large for a page/);
    await page.click('text="Torus"');
    await page.waitForTimeout(100);
    await idle();
    assert.equal((await result()).genus, 1);
    assert.ok(!await page.locator('#message').isVisible());
  },

  async 'a surface with a border is taken, too'() {
    await open('#sample=torus&faces=5000');
    const n = 12;
    const points = [], faces = [];
    for (let i = 0; i <= n; ++i)
      for (let j = 0; j < n; ++j) {
        const angle = 2 * Math.PI * (j + i / 2) / n;
        points.push(`${Math.cos(angle)} ${Math.sin(angle)} ${0.4 * i}`);
        if (i === n) continue;
        const [a, b] = [i * n + j, i * n + (j + 1) % n];
        faces.push(`3 ${a} ${b} ${a + n}`, `3 ${b} ${b + n} ${a + n}`);
      }
    assert.equal(await openFile('tube.off', `OFF\n${points.length} ${faces.length} 0\n${points.concat(faces).join('\n')}\n`), null);
    assert.match(await page.innerText('#numbers'), /border loops\s*2/);
    await page.click('#cut');
    await page.waitForTimeout(100);
    await idle();
    assert.ok(!await page.locator('#message').isVisible());
    assert.deepEqual(surfaceTopology(readObj(String(await exported('atlas-obj')))), { euler: 1, loops: 1 });
  },

  async 'what takes long can be cancelled, and the page goes on'() {
    await open('#sample=torus&faces=5000');
    // within the page: from outside, the click may come too late
    const text = await page.evaluate(async () => {
      const element = (id) => document.getElementById(id);
      element('faces').value = '400000';
      element('faces').dispatchEvent(new Event('change'));
      while (element('busy').hidden) await new Promise((resolve) => { setTimeout(resolve, 10); });
      element('cancel').click();
      return element('busy-text').textContent;
    });
    assert.match(text, /…$/);
    await page.waitForTimeout(100);
    await idle();
    assert.match(await page.innerText('#message-text'), /Cancelled/);
    await page.click('text="Capsule"');
    await page.selectOption('#faces', '5000');
    await page.waitForTimeout(100);
    await idle();
    assert.equal((await result()).genus, 0);
  },

  async 'the keyboard does all'() {
    await open('#sample=torus&faces=5000');
    await page.focus('#canvas');
    const view = await page.evaluate(() => window.cutLocusPage.viewer.getView());
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('+');
    assert.notDeepEqual(await page.evaluate(() => window.cutLocusPage.viewer.getView()), view);
    await page.keyboard.press('ArrowUp');
    const before = await result();
    for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowDown');
    await page.keyboard.press('m');
    await page.waitForTimeout(100);
    await idle();
    assert.equal(await page.inputValue('#method'), 'polyhedral');
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(!await page.locator('#help').isVisible());
    await page.keyboard.press('2');
    await page.waitForTimeout(100);
    await idle();
    assert.equal((await result()).genus, 0);
    await page.keyboard.press('s');
    await page.waitForTimeout(100);
    await idle();
    assert.notDeepEqual((await result()).point, before.point);
  },

  async 'the page comes from one host and without errors'() {
    assert.deepEqual(pageErrors, []);
    assert.deepEqual([...requests].filter((origin) => origin !== 'null' && origin !== new URL(address).origin), []);
  },
};

let failures = 0;
if (pictureFolder) await mkdir(pictureFolder, { recursive: true });
for (const [name, test] of Object.entries(tests)) {
  if (!name.match(wanted)) continue;
  const start = performance.now();
  try {
    await test();
    console.log(`ok      ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failures;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
await context.close();
server.close();
await rm(scratch, { recursive: true, force: true });
console.log(failures === 0 ? 'The page: passed' : `The page: ${failures} tests failed`);
process.exit(failures === 0 ? 0 : 1);
