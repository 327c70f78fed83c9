// For everybody: what axe-core finds, names and roles, announcements, the keyboard alone.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { patience } from '../page_driver.mjs';

const axeSource = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function violations(d) {
  await d.page.evaluate(axeSource);
  const found = await d.page.evaluate(() => window.axe.run(document,
    { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] }));
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.map((n) => n.target.join(' ')).join(', ')}`);
}

export const tests = {
  async 'axe-core finds nothing, in light and dark, on a desktop and on a phone'(d) {
    for (const size of [[1440, 900], [390, 844]]) {
      await d.resize(...size);
      await d.open('#sample=torus&faces=5000&show=width,disk&color=distance');
      if (size[0] < 640) await d.page.click('#panel-toggle');
      for (const scheme of ['light', 'dark']) {
        await d.page.emulateMedia({ colorScheme: scheme });
        await d.page.waitForTimeout(150);
        assert.deepEqual(await violations(d), [], `${size}, ${scheme}`);
      }
      await d.page.emulateMedia({ colorScheme: 'light' });
    }
    await d.resize();
    await d.open('#sample=torus&faces=5000&method=laplacian&cut=1');
    assert.deepEqual(await violations(d), [], 'cut open');
    await d.page.focus('#model-view');
    await d.page.keyboard.press('?');
    assert.deepEqual(await violations(d), [], 'help');
    await d.page.keyboard.press('Escape');
    await d.open('#embed&sample=torus&faces=5000');
    assert.deepEqual(await violations(d), [], 'in a frame');
  },

  async 'the picture has a role and a description that follows the result'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const canvas = page.locator('#canvas');
    assert.equal(await canvas.getAttribute('role'), 'img');
    const description = () => page.evaluate(() =>
      document.getElementById(document.getElementById('canvas').getAttribute('aria-describedby')).textContent);
    assert.match(await description(), /genus 1: the cut locus has 2 independent loops/);
    // the result is announced, once
    assert.equal(await page.getAttribute('#result-note', 'role'), 'status');
    await page.click('text="Capsule"');
    await d.settle();
    assert.match(await description(), /genus 0/);
    assert.match(await page.innerText('#result-note'), /genus 0/);
  },

  async 'letters do something only while a view has the focus'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const before = await d.result();
    for (const id of ['fit', 'cut', 'look-transparency', 'help-button']) {
      await page.focus(`#${id}`);
      for (const key of ['s', 'a', 't', 'm', 'c', 'w', '2', 'd', 'v', '?', '+']) await page.keyboard.press(key);
    }
    await page.evaluate(() => document.activeElement.blur());
    for (const key of ['s', 'a', 'c', '3', '?']) await page.keyboard.press(key);
    await d.settle();
    const after = await d.result();
    assert.deepEqual([after.point, after.sources, after.edges], [before.point, before.sources, before.edges]);
    assert.ok(!await page.locator('#help').isVisible());
    assert.ok(!await d.app(({ app }) => app.state.isCut || app.path || app.wave.isPlaying));
    await page.focus('#model-view');
    await page.keyboard.press('s');
    await d.settle();
    assert.notDeepEqual((await d.result()).point, before.point);
  },

  async 'keys aim at a crosshair, and at the nearest point of the surface where that meets a hole'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await page.selectOption('#view', 'top');
    await d.settle();
    assert.ok(!await page.locator('#crosshair').isVisible());
    await page.focus('#fit');
    await page.keyboard.press('Shift+Tab'); // from the buttons after it
    await page.focus('#model-view');
    await page.keyboard.press('Shift'); // the focus is that of the keyboard
    // each picture hides the target until the view rests
    const middleOf = async (id) => (await page.waitForFunction((selector) => {
      const element = document.querySelector(selector), box = element.getBoundingClientRect();
      return !element.hidden && [box.x + box.width / 2, box.y + box.height / 2];
    }, id, { timeout: patience })).jsonValue();
    const cross = await middleOf('#crosshair'), target = await middleOf('#crosshair-target'); // the middle is the hole
    const away = Math.hypot(...cross.map((x, k) => x - target[k]));
    assert.ok(away > 20 && away < 250, `${away}`);
    await d.picture('crosshair.png');
    await page.keyboard.press('i');
    assert.match(await page.innerText('#readout'), /from the source/);
    assert.equal(await page.getAttribute('#readout', 'role'), 'status');
    await page.keyboard.press('s');
    await d.settle();
    const box = await page.locator('#model-view').boundingBox();
    const [x, y] = await d.seenAt(await d.app(({ app }) => app.toView(app.source.points[0])));
    const off = Math.hypot(box.x + x * box.width - target[0], box.y + y * box.height - target[1]);
    assert.ok(off < 3, `the source is ${off} pixels off the target`);
    // no point of the surface is seen nearer to the middle
    assert.ok(await d.app(({ viewer }, [u, v, r]) => {
      for (let i = 0; i < 40; ++i)
        if (viewer.pointer.onModel(u + r * Math.cos(i), v + r * Math.sin(i))) return false;
      return true;
    }, [cross[0] - box.x, cross[1] - box.y, away - 8]));
    // on the surface itself there is the crosshair alone
    for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowUp');
    await d.settle();
    await page.waitForFunction(() => {
      const { viewer } = window.cutLocusPage;
      const isOnSurface = Boolean(viewer.pointer.onModel(...viewer.pixelAt(viewer.controls.target)));
      return document.getElementById('crosshair-target').hidden === isOnSurface;
    }, null, { timeout: patience }); // a slow machine draws the next picture later
    await page.mouse.click(...cross);
    await page.focus('#cut');
    assert.ok(!await page.locator('#crosshair').isVisible());
  },

  async 'all controls are reached by the tabulator key, in the order of the page'(d) {
    const { page } = d;
    await page.evaluate(() => { document.activeElement.blur(); window.scrollTo(0, 0); });
    const reached = new Set();
    for (let i = 0; i < 90; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim()));
    }
    for (const id of ['width', 'open', 'method', 'look-transparency', 'cut', 'export', 'model-view', 'fit', 'view'])
      assert.ok(reached.has(id), `${id} is not among ${[...reached].join(', ')}`);
  },
};
