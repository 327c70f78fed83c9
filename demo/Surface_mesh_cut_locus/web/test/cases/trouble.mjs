// What fails is told, and the page goes on: the worker, its module, the graphics card.
import assert from 'node:assert/strict';

// the page, whose first result may never come
async function openBroken(d) {
  await d.page.goto('about:blank');
  await d.page.goto(`${d.address}#sample=torus&faces=5000&occlusion=false`);
  await d.page.waitForSelector('#message:not([hidden])');
}

async function solvesAgain(d) {
  await d.page.waitForFunction(() => window.cutLocusPage.app.isSolved);
  await d.idle();
  assert.equal((await d.result()).genus, 1);
  assert.ok(!await d.page.locator('#message').isVisible());
}

export const tests = {
  async 'a worker, or a module, that cannot be loaded is told, and tried again'(d) {
    const { page } = d;
    for (const [file, words] of [['worker.js', /has stopped/], ['cut_locus.js', /could not be loaded/], ['cut_locus.wasm', /could not be loaded/]]) {
      await page.route(`**/${file}`, (route) => route.fulfill({ status: 404, body: 'not found' }));
      await openBroken(d);
      assert.match(await page.innerText('#message-text'), words, file);
      assert.equal(await page.evaluate(() => document.body.dataset.busy), 'false');
      // again in vain, without waiting for ever
      await page.click('#message-retry');
      await page.waitForFunction(() => document.body.dataset.busy === 'false' && !document.getElementById('message').hidden);
      await page.unroute(`**/${file}`);
      await page.click('#message-retry');
      await solvesAgain(d);
    }
  },

  async 'after a crash of the worker the next click has a result'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await d.app(({ app }) => {
      const { worker } = app.engine;
      const waiting = app.solve();
      worker.onerror(new ErrorEvent('error', { message: 'out of memory' }));
      return waiting;
    });
    assert.match(await page.innerText('#message-text'), /has stopped \(out of memory\)/);
    const { point } = await d.result();
    await d.click(...await d.placeOnSurface());
    assert.notDeepEqual((await d.result()).point, point);
    assert.ok(!await page.locator('#message').isVisible());
    await d.setWidth('3');
  },
};
