// For everybody: what axe-core finds, names and roles, announcements, the keyboard alone.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

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
    await d.page.keyboard.press('?');
    assert.deepEqual(await violations(d), [], 'help');
    await d.page.keyboard.press('Escape');
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
