// What the tests do with the page, as a user does, and what they read off it.
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

export const patience = 120000; // milliseconds: machines of continuous integration are slow
const pause = 120; // milliseconds: of more than ten downloads in a second, Chromium drops the last ones without a word

const usualSize = [1000, 640];

export class Driver {
  constructor({ page, address, scratch, pictureFolder }) {
    Object.assign(this, { page, address, scratch, pictureFolder });
  }

  idle() {
    return this.page.waitForFunction(() => {
      const { app } = window.cutLocusPage;
      return document.body.dataset.busy === 'false' && !app.isUpdating;
    }, null, { timeout: patience });
  }

  // after what starts work a little later, as an event does
  async settle() {
    await this.page.waitForTimeout(100);
    await this.idle();
  }

  // the simplified mesh on which sources move is there
  async previewIsReady() {
    await this.page.waitForFunction(() => window.cutLocusPage.app.preview.isSettled, null, { timeout: patience });
    assert.ok(await this.app(({ app }) => app.preview.isReady), 'there is no simplified mesh');
  }

  result() {
    return this.page.evaluate(() => {
      const { app } = window.cutLocusPage;
      if (!app.curve) throw new Error(`there is no curve: ${document.getElementById('message').innerText}`);
      const [edges, cycles, leaves, , length, radius] = app.curve.numbers;
      const { genus, points } = app.source;
      return { edges, cycles, leaves, length, radius, genus, point: points[0], sources: points.length, times: app.times };
    });
  }

  // evaluates `action` with the page's parts
  app(action, argument) {
    return this.page.evaluate(`(${action})(window.cutLocusPage, ${JSON.stringify(argument) ?? 'undefined'})`);
  }

  view() {
    return this.app(({ viewer }) => viewer.getView());
  }

  async unfold(group) {
    await this.page.evaluate((id) => { document.getElementById(id).open = true; }, group);
  }

  async setWidth(percent) {
    await this.page.fill('#width-number', percent);
    await this.page.waitForFunction((w) => window.cutLocusPage.app.drawn.width === Number(w)
      && !window.cutLocusPage.app.isUpdating, percent, { timeout: patience });
    await this.idle();
  }

  // Folded groups are unfolded: a test is about what is in them. The shadows of hollows take time in software: who wants
  // them in a picture says so.
  async open(hash) {
    await this.page.goto('about:blank');
    await this.page.goto(this.address + hash + (hash.includes('occlusion') ? '' : '&occlusion=false'));
    await this.page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved, null, { timeout: patience });
    await this.idle();
    for (const group of ['method-group', 'look', 'export-group', 'about', 'result-fold']) await this.unfold(group);
  }

  // the message about it, or null
  async openPath(path) {
    await this.page.setInputFiles('#file', path);
    await this.page.waitForTimeout(200);
    await this.idle();
    const message = this.page.locator('#message');
    return (await message.isVisible()) ? this.page.locator('#message-text').innerText() : null;
  }

  async openFile(name, content) {
    const path = join(this.scratch, name);
    await writeFile(path, content);
    return this.openPath(path);
  }

  async exported(what, format) {
    await this.page.selectOption('#export-what', what);
    await this.page.selectOption('#export-format', format);
    await this.page.waitForTimeout(pause);
    await this.idle();
    const refused = this.page.waitForSelector('#message:not(.is-plain)', { timeout: patience }).then(
      () => this.noMessage(), () => null);
    const [download] = await Promise.all([Promise.race([this.page.waitForEvent('download'), refused]), this.page.click('#export')]);
    await this.idle();
    this.exportedName = download.suggestedFilename();
    return readFile(await download.path());
  }

  // where a place of the mesh's own picture is on the page
  async click(x, y, options = {}) {
    const box = await this.page.locator('#model-view').boundingBox();
    await this.page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    for (const key of options.keys || []) await this.page.keyboard.down(key);
    await this.page.mouse.down();
    await this.page.mouse.up();
    for (const key of options.keys || []) await this.page.keyboard.up(key);
    await this.settle();
  }

  // parts of the view, from the upper left, at which a point in space is seen
  seenAt(point) {
    return this.app(({ viewer }, p) => {
      viewer.draw(); // with the camera where it has been put last
      const v = viewer.farthestMarker.position.clone().set(...p).project(viewer.camera);
      return [(v.x + 1) / 2, (1 - v.y) / 2];
    }, point);
  }

  // A place of the view at which the surface is seen well, not near the sources: with `n`, another one.
  placeOnSurface(n = 0) {
    return this.app(({ app, viewer }, wanted) => {
      viewer.draw();
      const { width, height } = viewer.boxOf(viewer.model);
      const found = [];
      for (const y of [0.62, 0.5, 0.7, 0.42])
        for (const x of [0.4, 0.5, 0.6, 0.3, 0.7]) {
          const hit = viewer.pointer.onModel(x * width, y * height);
          const box = viewer.model.element.getBoundingClientRect();
          const isCovered = document.elementFromPoint(box.left + x * width, box.top + y * height) !== viewer.model.element;
          if (!hit || isCovered) continue;
          const off = (point) => Math.hypot(...app.toView(point).map((c, k) => c - hit.place[k]));
          const isNear = viewer.pointer.onModel(x * width + 6, y * height) && viewer.pointer.onModel(x * width, y * height + 6);
          if (isNear && app.source.points.every((p) => off(p) > 0.3)) found.push([x, y]);
        }
      return found[wanted];
    }, n);
  }

  // to be compared, and kept if pictures are wanted
  async shot(name) {
    // the shadows of hollows come when the view rests
    await this.page.waitForTimeout(await this.app(({ viewer }) => viewer.occlusionStrength > 0) ? 500 : 60);
    const file = this.pictureFolder ? { path: join(this.pictureFolder, name) } : {};
    return this.page.screenshot(file);
  }

  // for who looks at them
  async picture(name) {
    if (this.pictureFolder) await this.shot(name);
  }

  // the link, with what has changed just now
  hash() {
    return this.app(({ address }) => {
      address.flush();
      return location.hash;
    });
  }

  async resize(width = usualSize[0], height = usualSize[1]) {
    await this.page.setViewportSize({ width, height });
    await this.page.waitForTimeout(200);
  }

  async noMessage() {
    const message = this.page.locator('#message');
    if (await message.isVisible() && !(await message.getAttribute('class') || '').includes('is-plain'))
      assert.fail(`the page says: ${await message.innerText()}`);
  }
}
