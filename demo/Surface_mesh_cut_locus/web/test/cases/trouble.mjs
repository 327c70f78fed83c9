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

// of two pictures, those that differ by more than a shade
const differingPixels = (d, ...pictures) => d.page.evaluate(async (list) => {
  const [a, b] = await Promise.all(list.map(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
  }));
  let count = 0;
  for (let i = 0; i < a.length; i += 4) count += [0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 12);
  return count;
}, pictures.map((picture) => picture.toString('base64')));

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

  async 'a graphics card that is lost is told, and what it has drawn comes back with it'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&color=distance&occlusion=true&wireframe=true&source=10,0.3,0.3,0.4,2000,0.2,0.3,0.5&cut=1');
    await page.waitForTimeout(500); // the shadows of hollows come when the view rests
    const before = await d.shot('context_before.png');
    await d.app(({ viewer }) => {
      window.lostContext = viewer.renderer.getContext().getExtension('WEBGL_lose_context');
      window.lostContext.loseContext();
    });
    await page.waitForSelector('#message:not([hidden])');
    assert.match(await page.innerText('#message-text'), /does not draw/);
    await page.mouse.move(500, 300); // nothing throws meanwhile
    await d.app(({ viewer }) => viewer.draw());
    await d.app(() => window.lostContext.restoreContext());
    await page.waitForSelector('#message', { state: 'hidden' });
    await page.mouse.move(2, 2);
    const different = await differingPixels(d, before, await d.shot('context_after.png'));
    assert.ok(different < 100, `${different} pixels are other ones`); // the shadows of hollows have noise
    // and it goes on: the view that shows most of the curve is looked for with the card, too
    await page.selectOption('#view', 'best');
    await d.click(...await d.placeOnSurface());
    await d.noMessage();
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
