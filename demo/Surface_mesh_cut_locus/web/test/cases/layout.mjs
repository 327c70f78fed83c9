// The page at the sizes of a desktop, a small laptop and a phone, in light and dark.
import assert from 'node:assert/strict';

const sizes = { desktop: [1440, 900], laptop: [1024, 700], phone: [390, 844], landscape: [844, 390] };

const boxOf = (d, selector) => d.page.locator(selector).boundingBox();

const overlaps = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

export const tests = {
  async 'at every size the surface has most of the room, and the result is on it'(d) {
    for (const [name, [width, height]] of Object.entries(sizes)) {
      await d.resize(width, height);
      await d.open(`#sample=torus&faces=5000${d.pictureFolder ? '&occlusion=true' : ''}`);
      await d.page.evaluate(() => { document.getElementById('result-fold').open = innerWidth > 1200; });
      const stage = await boxOf(d, '#stage');
      assert.ok(stage.width * stage.height > 0.6 * width * height, `${name}: the surface has ${stage.width} x ${stage.height}`);
      for (const part of ['#result', '#legend', '#tools']) {
        const box = await boxOf(d, part);
        assert.ok(box.x >= stage.x && box.y >= stage.y && box.x + box.width <= stage.x + stage.width + 1
          && box.y + box.height <= stage.y + stage.height + 1, `${name}: ${part} is not within the stage`);
      }
      assert.ok(!overlaps(await boxOf(d, '#result'), await boxOf(d, '#tools')), `${name}: buttons under the result`);
      assert.match(await d.page.innerText('#result'), /Injectivity radius [\d.]+\s±/);
      const overflow = await d.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(overflow <= 0, `${name}: ${overflow} pixels too wide`);
      for (const scheme of d.pictureFolder ? ['light', 'dark'] : []) {
        await d.page.emulateMedia({ colorScheme: scheme });
        for (const side of ['front', 'back']) {
          await d.page.selectOption('#view', side);
          await d.picture(`${name}_${scheme}_${side}.png`);
        }
      }
      await d.page.emulateMedia({ colorScheme: 'light' });
    }
    await d.resize();
  },

  async 'nothing that lies above the picture covers the mesh, nor the sheet'(d) {
    for (const [name, [width, height]] of Object.entries(sizes)) {
      if (name === 'laptop') continue; // is laid out as a desktop
      await d.resize(width, height);
      await d.open('#sample=genus-3&faces=5000');
      await d.page.evaluate(() => { document.getElementById('result-fold').open = false; });
      for (const isCut of [false, true]) {
        if (isCut) {
          await d.page.focus('#model-view');
          await d.page.keyboard.press('c');
          await d.page.waitForFunction(() => window.cutLocusPage.app.atlas);
          await d.settle();
          assert.ok(await d.page.locator('#cut-info').isVisible(), `${name}: nothing is said about the sheet`);
          // nor is any of the legend left out
          assert.ok(await d.page.evaluate(() => {
            const legend = document.getElementById('legend');
            return legend.scrollHeight <= legend.clientHeight;
          }), `${name}: the legend has no room`);
        } else {
          await d.page.click('#fit');
        }
        const covered = await d.app(({ app, viewer }) => {
          viewer.draw();
          const boxes = ['tools', 'result', 'legend', 'cut-info'].map((id) => document.getElementById(id).getBoundingClientRect());
          const p = viewer.farthestMarker.position.clone();
          const isCovered = (pane) => {
            const box = pane.element.getBoundingClientRect();
            p.project(pane.camera);
            const x = box.left + (p.x + 1) / 2 * box.width, y = box.top + (1 - p.y) / 2 * box.height;
            return Math.max(Math.abs(p.x), Math.abs(p.y)) > 1 || boxes.some((b) => x > b.left && x < b.right && y > b.top && y < b.bottom);
          };
          let count = 0;
          for (let i = 0; i < viewer.positions.length; i += 3) {
            p.fromArray(viewer.positions, i);
            count += isCovered(viewer.model);
          }
          const { uv } = app.atlas || { uv: [] };
          for (let i = 0; i < uv.length; i += 2) {
            p.set(uv[i], uv[i + 1], 0);
            count += isCovered(viewer.plane);
          }
          return count;
        });
        assert.equal(covered, 0, `${name}, ${isCut ? 'cut' : 'closed'}: ${covered} vertices are covered`);
      }
    }
    await d.resize();
  },

  async 'the panel can be hidden, and comes back'(d) {
    await d.open('#sample=torus&faces=5000');
    const width = async () => (await boxOf(d, '#canvas')).width;
    const before = await width();
    await d.page.click('#panel-hide');
    assert.equal(await width(), 1000);
    assert.ok(!await d.page.locator('#panel').isVisible());
    assert.equal(await d.page.evaluate(() => document.activeElement.id), 'panel-show');
    assert.ok(!overlaps(await boxOf(d, '#result'), await boxOf(d, '#tools')));
    await d.picture('panel_hidden.png');
    await d.page.keyboard.press('Enter');
    assert.equal(await width(), before);
    assert.ok(await d.page.locator('#width').isVisible());
  },

  async 'the page fills the screen, and comes back'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const isFull = () => page.evaluate(() => document.fullscreenElement === document.documentElement);
    await page.click('#full-screen');
    await page.waitForFunction(() => document.fullscreenElement);
    await page.waitForFunction(() => document.getElementById('full-screen').ariaPressed === 'true');
    assert.ok(await isFull());
    await page.focus('#full-screen');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => !document.fullscreenElement && document.getElementById('full-screen').ariaPressed === 'false');
    await d.resize();
  },

  async 'on a phone on its side, the legend of all layers leaves the surface its height'(d) {
    await d.resize(...sizes.landscape);
    await d.open('#sample=genus-3&faces=5000&color=distance&show=width,disk,edgeCurve,gradient&wireframe=true');
    const [legend, result, stage] = [await boxOf(d, '#legend'), await boxOf(d, '#result'), await boxOf(d, '#stage')];
    assert.ok(!overlaps(legend, result) && legend.y + legend.height <= stage.height, JSON.stringify([legend, result]));
    assert.ok(legend.width < 0.35 * stage.width && result.width < 0.35 * stage.width);
    assert.ok(await d.page.evaluate(() => document.getElementById('legend').scrollWidth <= document.getElementById('legend').clientWidth));
    const height = await d.app(({ viewer }) => {
      viewer.draw();
      const p = viewer.farthestMarker.position.clone();
      let low = 1, high = -1;
      for (let i = 0; i < viewer.positions.length; i += 3) {
        p.fromArray(viewer.positions, i).project(viewer.camera);
        low = Math.min(low, p.y);
        high = Math.max(high, p.y);
      }
      return (high - low) / 2;
    });
    assert.ok(height > 0.6, `the surface has ${height} of the height`);
    await d.picture('landscape_layers.png');
    await d.resize();
  },

  async 'magnified four times, all is there, one below the other'(d) {
    await d.resize(320, 256);
    for (const cut of ['', '&cut=1']) {
      await d.open(`#sample=torus&faces=5000${cut}`);
      assert.ok(await d.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'it has to be scrolled sideways');
      const boxes = await Promise.all(['#canvas', '#tools', '#result', '#legend', '#panel'].map((id) => boxOf(d, id)));
      assert.ok(boxes[0].height >= 150);
      boxes.forEach((a, i) => boxes.slice(0, i).forEach((b) => assert.ok(!overlaps(a, b), JSON.stringify(boxes))));
      await d.picture(`magnified${cut ? '_cut' : ''}.png`);
      await d.page.click('#panel-toggle');
      await d.page.locator('#export').scrollIntoViewIfNeeded();
      assert.ok((await boxOf(d, '#export')).y < 256);
      const text = await d.page.evaluate(() => [...document.querySelectorAll('#panel *')].filter((e) => e.checkVisibility() && e.getBoundingClientRect().right > 321).map((e) => e.id || e.tagName));
      assert.deepEqual(text, []);
      await d.page.evaluate(() => window.scrollTo(0, 0));
    }
    await d.resize();
  },

  async 'in forced colors, what is on is told from what is off, and the keys keep their colors'(d) {
    await d.page.emulateMedia({ forcedColors: 'active' });
    await d.open('#sample=torus&faces=5000&cut=1');
    const background = (selector) => d.page.$eval(selector, (e) => getComputedStyle(e).backgroundColor);
    assert.notEqual(await background('#modes input:checked + span'), await background('#modes input:not(:checked) + span'));
    assert.notEqual(await background('#cut[aria-pressed=true]'), await background('#fit'));
    assert.equal(await background('.face-curve'), 'rgb(200, 20, 31)');
    assert.equal(await background('#legend i.dot'), 'rgb(20, 80, 210)');
    await d.picture('forced_colors.png');
    await d.page.emulateMedia({ forcedColors: 'none' });
  },

  async 'in a frame there is the picture, and a link to all the rest'(d) {
    const { page } = d;
    await d.resize(480, 320);
    await page.goto('about:blank');
    await page.goto(`${d.address}#embed&sample=genus-3&faces=5000&occlusion=false`);
    await page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
    await d.idle();
    for (const id of ['#panel', '#modes', '#intro']) assert.ok(!await page.locator(id).isVisible(), id);
    for (const id of ['#wave-play', '#fit', '#legend']) assert.ok(await page.locator(id).isVisible(), id);
    assert.equal((await boxOf(d, '#canvas')).width, 480);
    await d.click(...await d.placeOnSurface());
    await d.noMessage();
    await d.picture('embedded.png');
    assert.match(await d.hash(), /embed=1/);
    const link = await page.getAttribute('#embed-open', 'href');
    assert.match(link, /sample=genus-3/);
    assert.doesNotMatch(link, /embed/);
    assert.equal(await page.getAttribute('#embed-open', 'target'), '_blank');
    await d.resize();
  },

  async 'groups fold, and only what everybody needs is open at first'(d) {
    await d.page.goto('about:blank');
    await d.page.goto(`${d.address}#sample=torus&faces=5000`);
    await d.page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
    await d.idle();
    assert.ok(await d.page.locator('#width').isVisible());
    for (const hidden of ['#method', '#solver', '#times', '#export']) assert.ok(!await d.page.locator(hidden).isVisible(), hidden);
    await d.page.click('#method-group summary');
    assert.ok(await d.page.locator('#method').isVisible());
    // the first slider is that of the detail
    assert.equal(await d.page.evaluate(() => document.querySelector('#panel input[type=range]:not(#wave-front)').id), 'width');
  },

  async 'on a phone, the panel is a sheet that unfolds, and everything is large enough for fingers'(d) {
    await d.resize(...sizes.phone);
    await d.open('#sample=torus&faces=5000');
    const height = async () => (await boxOf(d, '#canvas')).height;
    assert.ok(await height() > 600, `the canvas has ${await height()} pixels`);
    assert.ok(await d.page.locator('#width').isVisible());
    assert.ok(!await d.page.locator('#open').isVisible());
    await d.page.click('#panel-toggle');
    await d.page.waitForTimeout(150);
    assert.ok(await height() > 380, `with the sheet, the canvas has ${await height()} pixels`);
    assert.equal(await d.page.getAttribute('#panel-toggle', 'aria-expanded'), 'true');
    await d.page.locator('#method').scrollIntoViewIfNeeded();
    assert.ok(await d.page.locator('#method').isVisible());
    await d.picture('phone_sheet.png');
    const small = await d.page.evaluate(() => {
      const targets = [...document.querySelectorAll('button, select, summary, input[type=number], input[type=range], label:has(input)')];
      return targets.filter((t) => t.checkVisibility()).map((t) => [t.id || t.textContent.trim().slice(0, 20), t.getBoundingClientRect().height])
        .filter(([, h]) => h < 43.5);
    });
    assert.deepEqual(small, []);
    await d.page.click('#panel-toggle');
    // a tap shows values, as there is no pointer that could rest
    await d.page.locator('#modes label:has-text("Paths")').click();
    const [x, y] = await d.placeOnSurface();
    const view = await boxOf(d, '#model-view');
    const session = await d.page.context().newCDPSession(d.page);
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x: view.x + x * view.width, y: view.y + y * view.height }] });
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await d.settle();
    assert.match(await d.page.innerText('#readout'), /from the source/);
    assert.match(await d.page.innerText('#legend'), /the shortest path/);
    await d.picture('phone_path.png');
    await d.page.focus('#model-view');
    await d.page.keyboard.press('c');
    await d.page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.settle();
    assert.ok(!await d.page.locator('#readout').isVisible());
    await d.picture('phone_atlas.png');
    const [model, atlas] = [await boxOf(d, '#model-view'), await boxOf(d, '#atlas-view')];
    assert.ok(atlas.y >= model.y + model.height - 1 && atlas.width === model.width);
    await d.resize();
  },
};
