// Who comes for the first time sees what a cut locus is: three sentences, and a wave that stops there.
import assert from 'node:assert/strict';
import { isReddish, colorsAt, curvePixels } from './look.mjs';

async function openFirst(d, motion = 'no-preference') {
  await d.page.emulateMedia({ reducedMotion: motion });
  if (d.page.url().startsWith(d.address)) await d.page.evaluate(() => localStorage.clear());
  await d.page.goto('about:blank');
  await d.page.goto(d.address);
  await d.page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
  await d.idle();
}

const wave = (d) => d.app(({ app: { wave: { share, isPlaying } } }) => ({ share, isPlaying }));

async function shareOfRed(d, pixels) {
  const colors = await colorsAt(d, pixels);
  return colors.filter(isReddish).length / Math.max(pixels.length, 1);
}

export const tests = {
  async 'the first screen says what a cut locus is, and plays a wave once'(d) {
    const { page } = d;
    await openFirst(d);
    const text = await page.innerText('#intro');
    assert.equal(text.match(/[.]/g).length, 3, text);
    assert.match(text, /cut locus/);
    assert.ok(await page.locator('#drag-hint').isVisible());
    assert.ok((await wave(d)).isPlaying);
    await page.waitForFunction(() => window.cutLocusPage.app.wave.share > 0.1);
    assert.match(await page.innerText('#legend'), /wave from the source/);
    await d.picture('wave.png');
    await d.app(({ app }) => { app.wave.share = Math.max(app.wave.share, 0.9); }); // the rest is the same
    await page.waitForFunction(() => !window.cutLocusPage.app.wave.isPlaying, null, { timeout: 60000 });
    assert.deepEqual(await wave(d), { share: 1, isPlaying: false });
    assert.doesNotMatch(await page.innerText('#legend'), /wave/);
    await d.picture('first_screen.png');
    // the hint is beside the source, and goes with the first press
    const hint = await page.locator('#drag-hint').boundingBox();
    const [x, y] = await d.app(({ viewer }) => viewer.pixelAt(viewer.sourceMarkers[0].position));
    const stage = await page.locator('#stage').boundingBox();
    const off = Math.max(hint.x - stage.x - x, stage.x + x - hint.x - hint.width, 0);
    assert.ok(off < 30 && Math.abs(hint.y + hint.height / 2 - stage.y - y) < 4, `${hint.x}, ${hint.y}; the source is at ${x}, ${y}`);
    await d.click(0.5, 0.95);
    assert.ok(!await page.locator('#drag-hint').isVisible());
    for (const [name, size] of [['phone', [390, 844]], ...(d.pictureFolder ? [['landscape', [844, 390]]] : [])]) {
      await d.resize(...size);
      await openFirst(d, 'reduce');
      assert.ok(await page.locator('#intro').isVisible() && await page.locator('#wave-play').isVisible(), name);
      await page.fill('#wave-front', '400');
      await d.picture(`first_screen_${name}.png`);
    }
    await d.resize();
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    // a link has been chosen by somebody: nothing moves
    await d.open('#sample=torus&faces=5000');
    assert.deepEqual(await wave(d), { share: 1, isPlaying: false });
    assert.ok(!await page.locator('#drag-hint').isVisible());
  },

  async 'nothing moves for who does not want that, and the slider shows the same'(d) {
    const { page } = d;
    await openFirst(d, 'reduce');
    await page.waitForTimeout(300);
    assert.deepEqual(await wave(d), { share: 1, isPlaying: false });
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await d.open('#sample=torus&faces=5000&show=-isolines,-hidden');
    const { seen } = await curvePixels(d);
    assert.ok(await shareOfRed(d, seen) > 0.9);
    // by distances: the wave stops at the curve, which is there when it arrives
    const near = await d.app(({ app }) => Math.min(...app.curve.distance) / app.source.farthestDistance);
    assert.ok(near > 0.2 && near < 0.9, `${near}`);
    await page.fill('#wave-front', String(Math.floor(1000 * near) - 20));
    await page.waitForTimeout(100);
    assert.ok(await shareOfRed(d, seen) < 0.1);
    assert.match(await page.getAttribute('#wave-front', 'aria-valuetext'), /at distance [\d.]+/);
    const part = Number(((1 + near) / 2).toFixed(3));
    await page.fill('#wave-front', String(1000 * part));
    await page.waitForTimeout(100);
    const shown = await d.app(({ viewer: { faceCurve } }) => {
      const { geometry } = faceCurve.visibleLines;
      return geometry.drawRange.count / geometry.userData.indicesOfSegment;
    });
    const expected = await d.app(({ app }, s) => app.curve.distance.filter((x) => x <= s * app.source.farthestDistance).length, part);
    assert.ok(Math.abs(shown - expected) <= 1, `${shown} segments are shown, ${expected} have been reached`);
    // colors of the branches stay with them
    await page.check('#show-width');
    await d.settle();
    await page.fill('#wave-front', '1000');
    await page.waitForTimeout(100);
    assert.ok(await d.app(({ viewer: { faceCurve }, app }) => {
      const { geometry } = faceCurve.visibleLines;
      return geometry.drawRange.count === geometry.userData.indicesOfSegment * app.curve.distance.length;
    }));
    // a new source has no old wave
    await page.fill('#wave-front', '300');
    await d.click(...await d.placeOnSurface());
    assert.deepEqual(await wave(d), { share: 1, isPlaying: false });
    assert.equal(await page.inputValue('#wave-front'), '1000');
  },

  async 'who has read what it is does not read it again'(d) {
    const { page } = d;
    await openFirst(d, 'reduce');
    assert.ok(await page.locator('#intro').isVisible());
    await page.click('#intro-close');
    assert.ok(!await page.locator('#intro').isVisible());
    await page.goto('about:blank');
    await page.goto(d.address);
    assert.ok(await page.locator('#wave').isVisible() && !await page.locator('#intro').isVisible());
    // Help begins at its top
    await page.click('#help-button');
    assert.ok(await page.evaluate(() => document.getElementById('help').scrollTop === 0
      && document.getElementById('help-title').getBoundingClientRect().top > 0));
    const figure = await page.locator('#figure svg').boundingBox();
    assert.ok(figure.width > 300 && figure.height > 90, JSON.stringify(figure));
    await d.picture('help.png');
    await page.keyboard.press('Escape');
  },
};
