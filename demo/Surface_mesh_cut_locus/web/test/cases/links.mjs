// A link restores what was seen.
import assert from 'node:assert/strict';

const square = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';

export const tests = {
  async 'a link restores what was seen'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await d.click(...await d.placeOnSurface());
    await page.selectOption('#method', 'laplacian');
    await d.settle();
    await page.fill('#angle-number', '1.1');
    await page.check('#show-disk');
    await page.selectOption('#look-color', 'distance');
    await page.fill('#look-transparency', '0.3');
    await page.selectOption('#view', 'back');
    await page.waitForTimeout(600);
    await d.idle();
    const before = await d.result();
    const view = await d.view();
    const hash = await d.hash();
    await d.open(hash);
    const after = await d.result();
    assert.equal(after.edges, before.edges);
    assert.equal(after.length, before.length);
    assert.equal(await page.inputValue('#angle-number'), '1.1');
    assert.ok(await page.isChecked('#show-disk'));
    assert.equal(await page.inputValue('#look-color'), 'distance');
    assert.equal(await page.inputValue('#look-transparency'), '0.3');
    (await d.view()).forEach((x, k) => assert.ok(Math.abs(x - view[k]) < 1e-3, `view ${view}`));
    assert.equal(await d.hash(), hash);
  },

  async 'a link restores several sources and the cut surface'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&source=10,0.3,0.3,0.4,2000,0.2,0.3,0.5');
    const { sources, cycles } = await d.result();
    assert.deepEqual([sources, cycles], [2, 3]);
    assert.match(await d.hash(), /source=10,0.3,0.3,0.4,2000,0.2,0.3,0.5/);
    await d.open('#sample=torus&faces=5000&source=10,0.3,0.3,0.4,2000,0.2,0.3,0.5&keep=voronoi&color=cells');
    assert.equal(await page.inputValue('#keep'), 'voronoi');
    assert.equal(await page.inputValue('#look-color'), 'cells');
    assert.match(await d.hash(), /keep=voronoi/);
    await d.open('#sample=capsule&faces=5000&cut=1');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
  },

  async 'a link restores the width, and an old one with a strength opens'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&method=polyhedral&width=0.5&show=width');
    assert.equal(await page.inputValue('#width-number'), '0.5');
    assert.equal(await page.inputValue('#method'), 'polyhedral');
    assert.ok(await page.isChecked('#show-width'));
    const fine = await d.result();
    await d.open('#sample=torus&faces=5000&method=direction&width=0.5');
    const same = await d.result();
    assert.ok(Math.abs(same.length - fine.length) < 1e-2 * fine.length, `${same.length}, ${fine.length}`);
    await d.open('#sample=torus&faces=5000&solver=exact&method=direction&strength=7&show=strength,disk,laplacian');
    await d.noMessage();
    assert.ok(await page.isChecked('#width-auto'));
    assert.ok(await page.isChecked('#show-disk'));
    assert.doesNotMatch(await d.hash(), /strength/);
  },

  async 'a bad link falls back, and says so'(d) {
    const { page } = d;
    const cases = [
      ['sample=torus&faces=5000&show=toString', /“show” is not understood/, 1],
      ['sample=torus&faces=5000&border=only', /cannot be shown[^]*opens/, 1],
      ['sample=torus&faces=5000&source=99999999,1,0,0', /not on this surface/, 1],
      ['sample=teapot&faces=5000', /no sample of the name “teapot”/, 1],
    ];
    for (const [link, words, genus] of cases) {
      await d.open(`#${link}`);
      assert.equal((await d.result()).genus, genus, link);
      assert.match(await page.innerText('#message-text'), words, link);
      await d.noMessage(); // it is no error
      // and all goes on
      await d.click(...await d.placeOnSurface());
      await d.noMessage();
      assert.ok(await d.app(({ app }) => app.isSolved), link);
    }
    assert.match(await d.hash(), /sample=torus/);
  },

  async 'the address takes few changes while a slider moves, and has the last one'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const changes = await page.evaluate(async () => {
      const replace = history.replaceState;
      let n = 0;
      history.replaceState = function counted(...given) {
        ++n;
        // as Safari does
        if (n > 20) throw new DOMException('too many calls', 'SecurityError');
        return replace.apply(this, given);
      };
      const slider = document.getElementById('width-number');
      for (let i = 0; i < 120; ++i) {
        slider.value = 1 + i / 100;
        slider.dispatchEvent(new Event('input'));
        slider.dispatchEvent(new Event('change'));
        await new Promise((resolve) => { setTimeout(resolve, 20); });
      }
      await new Promise((resolve) => { setTimeout(resolve, 1000); });
      delete history.replaceState;
      return n;
    });
    assert.ok(changes > 1 && changes < 20, `${changes} changes`);
    assert.match(await d.hash(), /width=2.19/);
    await d.noMessage();
  },

  async 'a link to a file explains itself until the file is opened'(d) {
    const { page } = d;
    await page.goto('about:blank');
    await page.goto(`${d.address}#file=square.off&solver=exact&method=polyhedral&view=0,0,5,0,0,0`);
    await page.waitForSelector('#invitation:not([hidden])');
    assert.match(await page.innerText('#invitation'), /about the file “square.off”[^]*Open the file/);
    assert.ok(!await page.locator('#result').isVisible());
    await d.picture('link_to_file.png');
    assert.match(await d.hash(), /file=square.off/);
    assert.equal(await d.openFile('square.off', square), null);
    assert.ok(!await page.locator('#invitation').isVisible());
    assert.equal(await page.inputValue('#method'), 'polyhedral');
    assert.ok((await d.view())[2] > 4.9);
    await d.unfold('about');
    await page.click('#forget');
    await page.waitForSelector('#message:not([hidden])');
    await page.goto('about:blank');
    await page.goto(`${d.address}#file=square.off`);
    await page.click('#invitation-sample');
    await page.waitForFunction(() => window.cutLocusPage.app.isSolved);
    await d.idle();
    assert.equal((await d.result()).genus, 1);
  },
};
