// Fingers: a tap sets the source, two of them zoom and leave it where it is.
import assert from 'node:assert/strict';
import { patience } from '../page_driver.mjs';

class Fingers {
  constructor(session) {
    this.session = session;
  }

  send(type, points) {
    return this.session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  }
}

async function touch(d) {
  const box = await d.page.locator('#model-view').boundingBox();
  const fingers = new Fingers(await d.page.context().newCDPSession(d.page));
  return { fingers, onPage: ([x, y]) => [box.x + x * box.width, box.y + y * box.height] };
}

const sourcePlace = async (d) => d.seenAt(await d.app(({ app }) => app.toView(app.source.points[0])));

// Touches wait for the next picture, which takes long on a slow machine.
async function sourceMoves(d, from) {
  await d.page.waitForFunction((point) => `${window.cutLocusPage.app.source.points[0]}` !== point, `${from}`, { timeout: patience });
  await d.page.waitForFunction(() => !window.cutLocusPage.app.follower.isActive, null, { timeout: patience });
  await d.settle();
}

const plus = ([x, y], dx, dy = 0) => [x + dx, y + dy];

export const tests = {
  async 'a tap that moves by up to ten pixels sets the source'(d) {
    await d.open('#sample=torus&faces=5000');
    const { fingers, onPage } = await touch(d);
    const at = onPage(await d.placeOnSurface());
    const { point } = await d.result();
    await fingers.send('touchStart', [at]);
    await fingers.send('touchMove', [plus(at, 4, 3)]);
    await fingers.send('touchMove', [plus(at, 6, 4)]);
    await fingers.send('touchEnd', []);
    await sourceMoves(d, point);
    const tapped = (await d.result()).point;
    assert.notDeepEqual(tapped, point);
    // farther, it turns the view
    const view = await d.view();
    const other = onPage(await d.placeOnSurface());
    await fingers.send('touchStart', [other]);
    for (let i = 1; i < 6; ++i) await fingers.send('touchMove', [plus(other, 10 * i)]);
    await fingers.send('touchEnd', []);
    await d.settle();
    assert.deepEqual((await d.result()).point, tapped);
    assert.notDeepEqual(await d.view(), view);
  },

  async 'two fingers zoom, and the source stays, also where they begin on it'(d) {
    await d.open('#sample=torus&faces=5000');
    const { point } = await d.result();
    for (const isOnSource of [false, true]) {
      await d.page.selectOption('#view', 'best');
      const { fingers, onPage } = await touch(d);
      const at = onPage(isOnSource ? await sourcePlace(d) : await d.placeOnSurface());
      // a tap by two fingers
      await fingers.send('touchStart', [at]);
      await fingers.send('touchStart', [at, plus(at, 40)]);
      await fingers.send('touchEnd', []);
      await d.settle();
      assert.deepEqual((await d.result()).point, point, 'a tap by two fingers moves the source');
      const eye = () => d.app(({ viewer }) => viewer.camera.position.length());
      const before = await eye();
      await fingers.send('touchStart', [at]);
      await fingers.send('touchStart', [at, plus(at, 40)]);
      for (let i = 1; i < 8; ++i) await fingers.send('touchMove', [plus(at, -6 * i), plus(at, 40 + 6 * i)]);
      await fingers.send('touchEnd', []);
      await d.settle();
      assert.deepEqual((await d.result()).point, point, 'zooming moves the source');
      assert.ok(await eye() < 0.8 * before, `${isOnSource ? 'on the source' : 'elsewhere'}: the eye is ${await eye()} away, and was ${before}`);
      assert.ok(await d.app(({ viewer }) => viewer.controls.enabled));
    }
  },

  async 'a finger on the source drags it'(d) {
    await d.open('#sample=torus&faces=5000');
    await d.page.selectOption('#view', 'source');
    await d.settle();
    const { fingers, onPage } = await touch(d);
    const at = onPage(await sourcePlace(d));
    const { point } = await d.result();
    const view = await d.view();
    await fingers.send('touchStart', [at]);
    await d.page.waitForFunction(() => !window.cutLocusPage.viewer.controls.enabled, null, { timeout: patience }); // it is pressed
    for (let i = 1; i < 8; ++i) await fingers.send('touchMove', [plus(at, 5 * i)]);
    await fingers.send('touchEnd', []);
    await sourceMoves(d, point);
    assert.notDeepEqual((await d.result()).point, point);
    assert.deepEqual(await d.view(), view);
  },
};
