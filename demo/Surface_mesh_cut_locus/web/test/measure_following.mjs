// How often a page follows a source that moves: measure_following.mjs PAGE_FOLDER [FACES]...
// On tori of so many faces, the source goes around a circle on the screen, a step for each picture that has been drawn.
// Rows: as it is for whoever looks at it (`drawing`; `first`: the browser still compiles), waiting for the pixels of each
// picture, and with nothing drawn at all. In each: pictures, and previews, per second, and, as medians in milliseconds, what
// computing takes in the worker, picking the place under the pointer, and drawing: until the picture is handed over, or, in
// the row `waiting`, until it is there. A browser without a graphics card draws in software, on the processors that compute:
// what lies between `drawing` and `notDrawing` is that.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';
import { serve } from '../serve.mjs';

const [pageFolder, ...rest] = process.argv.slice(2);
const sizes = rest.length > 0 ? rest.map(Number) : [20000, 100000];
const scratch = await mkdtemp(join(tmpdir(), 'cut_locus_page_'));
const { server, address } = await serve(pageFolder);
const context = await openBrowser(join(scratch, 'profile'));
const page = context.pages()[0] || await context.newPage();
page.setDefaultTimeout(120000);

// all of it runs in the page: what this program asks for would take time, too
async function measure() {
  const seconds = 5;
  const { app, viewer } = window.cutLocusPage;
  const { follower } = app;
  const nextFrame = () => new Promise((resolve) => { requestAnimationFrame(resolve); });
  const median = (a) => (a.length > 0 ? Number(a.sort((x, y) => x - y)[a.length >> 1].toFixed(1)) : null);
  const gl = viewer.renderer.getContext();
  const pixel = new Uint8Array(4);
  const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const { width, height } = viewer.boxOf(viewer.model);
  const start = viewer.sourceMarkers[0].position.clone().project(viewer.camera);
  const at = [(start.x + 1) / 2 * width, (1 - start.y) / 2 * height];
  const { draw } = viewer;
  const update = app.previewSources;
  const run = async (draws) => {
    const parts = { computing: [], picking: [], drawing: [] };
    const timed = (name, action) => {
      const begin = performance.now();
      const result = action();
      parts[name].push(performance.now() - begin);
      return result;
    };
    viewer.draw = function drawn(...args) {
      if (draws) timed('drawing', () => { draw.apply(this, args); if (draws === 'waits') wait(); });
    };
    let previews = 0;
    app.previewSources = async function previewed(...args) {
      const result = await update.apply(this, args);
      parts.computing.push(app.times.follow);
      ++previews;
      return result;
    };
    follower.start(0);
    const end = performance.now() + 1000 * seconds;
    const before = follower.updates;
    const begin = performance.now();
    for (let t = 0; performance.now() < end; t += 0.05) {
      const place = [at[0] + 40 * Math.sin(t), at[1] + 40 * (1 - Math.cos(t))];
      follower.move(() => timed('picking', () => viewer.pointer.onModel(...place)));
      await nextFrame();
    }
    const rate = (n) => Number((1000 * n / (performance.now() - begin)).toFixed(1));
    const result = { pictures: rate(follower.updates - before), previews: rate(previews) };
    await follower.end();
    for (const [name, times] of Object.entries(parts)) result[name] = median(times);
    viewer.draw = draw;
    app.previewSources = update;
    return result;
  };
  const first = await run(true); // the browser compiles
  return { first, drawing: await run(true), waiting: await run('waits'), notDrawing: await run(false) };
}

for (const faces of sizes) {
  await page.goto('about:blank');
  await page.goto(`${address}#sample=torus&faces=${faces}&occlusion=false`);
  await page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
  await page.waitForFunction(() => document.body.dataset.busy === 'false');
  await page.waitForTimeout(1000);
  await page.waitForFunction(() => window.cutLocusPage.app.preview?.isSettled ?? true);
  for (const isolines of [true, false]) {
    // the last one has left the source elsewhere: on its circle, there must be surface everywhere
    await page.evaluate(async (shown) => {
      const { appearance } = window.cutLocusPage.app;
      await appearance.setShown('isolines', shown);
      appearance.look('source');
    }, isolines);
    await page.waitForTimeout(500);
    const rows = await page.evaluate(measure);
    for (const [name, row] of Object.entries(rows)) console.log(JSON.stringify({ faces, isolines, name, ...row }));
  }
}
await context.close();
server.close();
await rm(scratch, { recursive: true, force: true });
