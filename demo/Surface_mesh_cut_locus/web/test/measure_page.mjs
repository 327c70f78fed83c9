// Times of a new source and of a changed threshold in the browser: measure_page.mjs PAGE_FOLDER MESH
// Medians in milliseconds, with the source in the first corner of the first face. `pixels` waits for the picture as well,
// which Chromium here draws in software.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';
import { serve } from '../serve.mjs';

const [pageFolder, mesh] = process.argv.slice(2);
const scratch = await mkdtemp(join(tmpdir(), 'cut_locus_page_'));
const { server, address } = await serve(pageFolder);
const context = await openBrowser(join(scratch, 'profile'));
const page = context.pages()[0] || await context.newPage();
await page.goto(`${address}#sample=torus&faces=5000`);
await page.waitForFunction(() => window.cutLocusPage && window.cutLocusPage.app.isSolved);
await page.setInputFiles('#file', mesh);
await page.waitForFunction(() => window.cutLocusPage.app.state.file && window.cutLocusPage.app.isSolved, null, { timeout: 300000 });
await page.waitForFunction(() => document.body.dataset.busy === 'false');

for (const method of ['default', 'laplacian']) {
  const row = await page.evaluate(async (name) => {
    const { app, viewer } = window.cutLocusPage;
    const median = (a) => Number(a.sort((x, y) => x - y)[a.length >> 1].toFixed(1));
    const pause = () => new Promise((resolve) => { setTimeout(resolve, 250); });
    const gl = viewer.renderer.getContext();
    const waitForPixels = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    const source = [], computed = [], drawn = [], pixels = [], smoothed = [];
    await app.setSolver('exact', name);
    for (let i = 0; i < 11; ++i) {
      await app.setSources([{ face: 0, coordinates: [1, 0, 0] }]);
      source.push(app.times.solve);
      await pause();
    }
    for (let i = 0; i < 20; ++i) {
      waitForPixels();
      const start = performance.now();
      if (name === 'default') await app.setParameter('width', 100 * app.defaults.width + 0.5 * i);
      else await app.setParameter('angle', 0.3 + 0.05 * i);
      waitForPixels();
      clearTimeout(app.restTimer);
      pixels.push(performance.now() - start);
      drawn.push(app.times.threshold.shown);
      computed.push(app.times.threshold.computed);
      await pause();
    }
    for (let i = 0; name === 'laplacian' && i < 5; ++i) {
      await app.updateCurves();
      smoothed.push(app.times.smoothing.computed);
    }
    return {
      method: name,
      source: median(source),
      threshold: median(computed),
      drawn: median(drawn),
      pixels: median(pixels),
      ...(smoothed.length > 0 ? { smoothed: median(smoothed) } : {}),
    };
  }, method);
  console.log(JSON.stringify(row));
}
await context.close();
server.close();
await rm(scratch, { recursive: true, force: true });
