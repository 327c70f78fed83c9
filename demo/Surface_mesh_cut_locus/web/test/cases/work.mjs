// Nothing that the user has done is lost: undo, the cut surface, other meshes, canceling, the keyboard.
import assert from 'node:assert/strict';
import { describeAtlas } from '../../src/words.js';
import { patience } from '../page_driver.mjs';
import { borderCrossings, flippedFaces as flippedFacesOf, readObj } from '../topology.mjs';

const followMilliseconds = 2000;

// of the sheet, by its coordinates
const flippedFaces = ({ app }) => {
  const { uv, triangles } = app.atlas;
  let result = 0;
  for (let f = 0; f < triangles.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [uv[2 * triangles[f + k]], uv[2 * triangles[f + k] + 1]]);
    result += !((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0);
  }
  return result;
};

// A strip along so many turns of a helix, as an OFF file: seen from above, its turns cover each other.
const ramp = (turns, columns) => {
  const points = [], faces = [];
  const angle = 2 * Math.PI / columns, rows = 4;
  for (let i = 0; i <= turns * columns; ++i)
    for (let j = 0; j < rows; ++j) {
      const radius = 1 + 0.15 * j;
      points.push([radius * Math.cos(i * angle), radius * Math.sin(i * angle), 0.1 * i * angle].join(' '));
      const a = i * rows + j, b = a + rows;
      if (i < turns * columns && j + 1 < rows) faces.push(`3 ${a} ${a + 1} ${b + 1}`, `3 ${a} ${b + 1} ${b}`);
    }
  return ['OFF', `${points.length} ${faces.length} 0`, ...points, ...faces].join('\n');
};

// the preview as it is drawn, and how far it is off the surface, in radii of the mesh
const drawnPreview = ({ app, viewer }) => {
  const { previewCurve, faceCurve, edgeCurve, pickable } = viewer;
  const visible = Object.fromEntries(Object.entries({ previewCurve, faceCurve, edgeCurve }).map(([name, c]) => [name, c.visibleLines.visible]));
  const { geometry } = previewCurve.visibleLines;
  const [starts, ends] = ['instanceStart', 'instanceEnd'].map((name) => geometry.getAttribute(name).array);
  const segments = [];
  for (let i = 0; i < 24 * geometry.drawRange.count / geometry.userData.indicesOfSegment; i += 24) segments.push(...starts.slice(i, i + 3), ...ends.slice(i, i + 3));
  let away = 0;
  const point = viewer.farthestMarker.position.clone();
  for (let i = 0; i < segments.length; i += 3)
    away = Math.max(away, pickable.geometry.boundsTree.closestPointToPoint(point.fromArray(segments, i)).distance);
  return { visible, segments, away, faces: app.preview.faces };
};

// The surface without the faces around two of its vertices, as an OFF file.
const withHoles = ({ viewer: { positions, triangles } }) => {
  const gone = [0, Math.floor(positions.length / 6)];
  const faces = [];
  for (let f = 0; f < triangles.length; f += 3) {
    const face = Array.from(triangles.slice(f, f + 3));
    if (!face.some((v) => gone.includes(v))) faces.push(`3 ${face.join(' ')}`);
  }
  const points = [];
  for (let i = 0; i < positions.length; i += 3) points.push(positions.slice(i, i + 3).join(' '));
  return ['OFF', `${points.length} ${faces.length} 0`, ...points, ...faces].join('\n');
};

// How far the preview for the sources as they are is off the curve, and how long edges of the simplified mesh are.
const compareWithPreview = async ({ app, viewer }) => {
  const { segments } = await app.preview.compute(app.state.sources, false);
  const exact = app.curves.faceCurve.segments;
  const distance = (p) => {
    let least = Infinity;
    for (let i = 0; i < exact.length; i += 6) {
      const u = [0, 1, 2].map((k) => exact[i + 3 + k] - exact[i + k]), w = [0, 1, 2].map((k) => p[k] - exact[i + k]);
      const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      const t = Math.min(Math.max(dot(u, w) / (dot(u, u) || 1), 0), 1);
      least = Math.min(least, Math.hypot(...w.map((x, k) => x - t * u[k])));
    }
    return least;
  };
  let sum = 0, length = 0;
  for (let i = 0; i < segments.length; i += 6) {
    const [a, b] = [0, 3].map((k) => Array.from(segments.slice(i + k, i + k + 3)));
    const long = Math.hypot(...a.map((x, k) => x - b[k]));
    sum += long * distance(a.map((x, k) => (x + b[k]) / 2));
    length += long;
  }
  return { mean: sum / length, edge: app.mesh.edgeLength / app.mesh.numbers[3] * Math.sqrt(viewer.triangles.length / 3 / app.preview.faces) };
};

export const tests = {
  async 'sources and thresholds can be taken back and done again'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const first = await d.result();
    assert.ok(await page.isDisabled('#undo') && await page.isDisabled('#redo'));
    await d.click(...await d.placeOnSurface());
    const second = await d.result();
    await d.setWidth('0.5');
    await page.waitForTimeout(700); // it rests
    const third = await d.result();
    await page.click('#undo');
    await d.settle();
    assert.equal((await d.result()).edges, second.edges);
    assert.ok(await page.isChecked('#width-auto'));
    await page.click('#undo');
    await d.settle();
    assert.deepEqual((await d.result()).point, first.point);
    assert.ok(await page.isDisabled('#undo'));
    await page.focus('#model-view');
    await page.keyboard.press('Control+y');
    await d.settle();
    await page.keyboard.press('Control+Shift+z');
    await d.settle();
    assert.equal((await d.result()).edges, third.edges);
    assert.equal(await page.inputValue('#width-number'), '0.5');
    await page.keyboard.press('Control+z');
    await d.settle();
    assert.equal((await d.result()).edges, second.edges);
    // what is new forgets what was taken back
    await d.click(...await d.placeOnSurface(1));
    assert.ok(await page.isDisabled('#redo'));
  },

  async 'the surface is cut, and closed, also while it is computed: what is asked for last counts'(d) {
    await d.open('#sample=torus&faces=5000');
    const clicked = async (times) => {
      await d.app(({ app }, n) => {
        app.solve();
        for (let i = 0; i < n; ++i) document.getElementById('cut').click();
      }, times);
      await d.settle();
      return d.app(({ app, viewer }) => [app.state.isCut, app.atlas !== null, viewer.hasAtlas, document.getElementById('cut').ariaPressed]);
    };
    assert.deepEqual(await clicked(2), [false, false, false, 'false']);
    assert.deepEqual(await clicked(1), [true, true, true, 'true']);
    assert.deepEqual(await clicked(2), [true, true, true, 'true']);
    assert.deepEqual(await clicked(1), [false, false, false, 'false']);
  },

  async 'the cut surface follows a slider and a new source'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.idle();
    const seams = () => d.app(({ app }) => app.atlas.border.length);
    const before = await seams();
    await d.setWidth('0.3');
    await page.waitForFunction((n) => window.cutLocusPage.app.atlas && window.cutLocusPage.app.atlas.border.length > n, before);
    await d.idle();
    const finer = await seams();
    assert.ok(finer > before, `${finer} after ${before}`);
    assert.equal(await page.getAttribute('#cut', 'aria-pressed'), 'true');
    // a click on the sheet sets the source where it is on the surface
    const { point } = await d.result();
    const box = await page.locator('#atlas-view').boundingBox();
    const [at, x, y] = await d.app(({ app, viewer }) => {
      const { uv, triangles } = app.atlas;
      const middle = (f, k) => (uv[2 * triangles[f] + k] + uv[2 * triangles[f + 1] + k] + uv[2 * triangles[f + 2] + k]) / 3;
      const far = 3 * Math.floor(triangles.length / 6);
      const v = viewer.farthestMarker.position.clone().set(middle(far, 0), middle(far, 1), 0).project(viewer.plane.camera);
      const places = viewer.surface.opaque.geometry.getAttribute('position').array;
      const place = [0, 1, 2].map((c) => [0, 1, 2].reduce((sum, k) => sum + places[3 * triangles[far + k] + c] / 3, 0));
      return [place, (v.x + 1) / 2, (1 - v.y) / 2];
    });
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await d.settle();
    assert.notDeepEqual((await d.result()).point, point);
    const middle = await d.app(({ app }, place) => Math.hypot(...app.toView(app.source.points[0]).map((c, k) => c - place[k]))
      * app.mesh.numbers[3] / app.mesh.edgeLength, at);
    assert.ok(middle < 1.5, `the source is ${middle} edges off`);
    await d.noMessage();
    assert.ok(await d.app(({ app }) => Boolean(app.atlas)), 'the sheet is gone');
    // and it can be zoomed
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.9 * box.height);
    await page.mouse.wheel(0, -400);
    await page.waitForTimeout(200);
    assert.ok(await d.app(({ viewer }) => viewer.plane.camera.zoom) > 1.05);
    await page.click('#cut');
    assert.equal(await d.app(({ app }) => app.atlas), null);
  },

  async 'seams run where the curve does, and along edges of the mesh if that curve is shown'(d) {
    const { page } = d;
    // lengths of the seams, of which there are two sides, and of the curve; vertices that the mesh does not have
    const measure = () => d.app(({ app, viewer }) => {
      const seams = viewer.seams.visibleLines.geometry.getAttribute('instanceStart').array;
      const ends = viewer.seams.visibleLines.geometry.getAttribute('instanceEnd').array;
      let length = 0;
      for (let i = 0; i < seams.length; i += 24) length += Math.hypot(...[0, 1, 2].map((k) => ends[i + k] - seams[i + k]));
      const { weights } = app.atlas;
      return { seams: length / 2 * app.mesh.numbers[3], curve: app.curve.numbers[4], added: weights.filter((w, i) => i % 3 === 0 && w !== 1).length };
    });
    const notes = [];
    for (const sample of ['torus', 'genus-3']) {
      await d.open(`#sample=${sample}&faces=5000`);
      await page.click('#cut');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      const straight = await measure();
      assert.ok(Math.abs(straight.seams / straight.curve - 1) < 0.01, `seams ${straight.seams}, curve ${straight.curve}`);
      assert.ok(straight.added > 0);
      await d.picture(`seams_${sample}.png`);
      await page.check('#show-edgeCurve');
      await page.uncheck('#show-faceCurve');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas && window.cutLocusPage.app.atlas.weights.every((w) => w === 0 || w === 1));
      await d.idle();
      const zigzag = await measure();
      assert.equal(zigzag.added, 0);
      assert.ok(zigzag.seams > 1.05 * straight.seams, `${zigzag.seams} along edges, ${straight.seams} through faces`);
      notes.push(`${sample}: ${(zigzag.seams / straight.seams).toFixed(2)} times as long along edges`);
    }
    return notes.join(', ');
  },

  async 'the page says whether the sheet is one to one'(d) {
    const { page } = d;
    const folded = describeAtlas([3, 7, 0.125, 0.1, 0, 1], 1000);
    assert.ok(!folded.isInjective);
    assert.match(folded.text, /Not one to one: 7 of .* lie over others, on 13\s%.*3 of .* turned over/);
    for (const sample of ['bumpy-sphere', 'capsule', 'torus', 'genus-3']) {
      await d.open(`#sample=${sample}&faces=5000`);
      await page.click('#cut');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      const told = await page.innerText('#cut-info');
      assert.match(told, /does not overlap/, sample);
      assert.equal(await d.app(flippedFaces), 0, sample);
    }
  },

  async 'a strip that winds around itself is one sheet, which does not overlap'(d) {
    const { page } = d;
    await d.openFile('ramp.off', ramp(5, 60));
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.idle();
    const told = await page.innerText('#cut-info');
    assert.match(told, /^The sheet does not overlap; areas change by \d\.?\d*\s%/);
    const sheet = readObj(String(await d.exported('cut', 'obj')));
    assert.equal(flippedFacesOf(sheet), 0);
    assert.equal(borderCrossings(sheet), 0);
    // the source is near an end, and marked there: a click there puts it to the same place
    const place = await d.app(({ app }) => app.atlas.sheets[0].place);
    const at = await d.app(({ viewer }, [x, y]) => {
      const v = viewer.farthestMarker.position.clone().set(x, y, 0).project(viewer.plane.camera);
      return [(v.x + 1) / 2, (1 - v.y) / 2];
    }, place);
    const box = await page.locator('#atlas-view').boundingBox();
    const before = (await d.result()).point;
    await page.mouse.click(box.x + at[0] * box.width, box.y + at[1] * box.height);
    await d.settle();
    const after = (await d.result()).point;
    const moved = Math.hypot(...before.map((x, k) => x - after[k]));
    assert.ok(moved < 0.05, `a click on the mark of the source moves it by ${moved}`);
    await d.picture('ramp_cut.png');
    return told;
  },

  async 'of several sources, the cells are laid side by side, with the numbers of the sources'(d) {
    const { page } = d;
    for (const keep of ['all', 'voronoi']) {
      await d.open('#sample=torus&faces=5000');
      await d.click(...await d.placeOnSurface(), { keys: ['Shift'] });
      await page.selectOption('#keep', keep);
      await d.settle();
      await page.click('#cut');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      assert.match(await page.innerText('#cut-info'), /2 sheets, one for each cell: none overlaps/);
      assert.equal(await d.app(flippedFaces), 0);
      // each face of the surface once
      const { faces, all } = await d.app(({ app }) =>
        ({ faces: new Set(app.atlas.faces).size, all: app.mesh.triangles.length / 3 }));
      assert.equal(faces, all);
      // each sheet is marked where its source is, by the same number
      const marked = await d.app(({ app, viewer }) => {
        const off = (p, q) => Math.hypot(...p.map((x, k) => x - q[k]));
        const numbers = (markers) => markers.filter(({ visible }) => visible).map(({ number }) => number);
        return {
          onSheets: numbers(viewer.sheetMarkers.children), onSurface: numbers(viewer.sourceMarkers),
          away: app.atlas.sheets.map(({ source, place }) => {
            const { uv, parents, weights } = app.atlas;
            let at = 0;
            for (let v = 0; v < uv.length / 2; ++v)
              if (off([uv[2 * v], uv[2 * v + 1]], place) < off([uv[2 * at], uv[2 * at + 1]], place)) at = v;
            const point = [0, 1, 2].map((c) => [0, 1, 2].reduce((sum, k) => sum + weights[3 * at + k] * app.mesh.positions[3 * parents[3 * at + k] + c], 0));
            return off(point, app.toView(app.source.points[source]));
          }),
        };
      });
      assert.deepEqual([marked.onSheets.sort(), marked.onSurface], [[1, 2], [1, 2]]);
      for (const away of marked.away) assert.ok(away < 0.06, `a sheet is marked ${away} away from its source`);
      const outline = String(await d.exported('cut', 'svg'));
      assert.deepEqual([...outline.matchAll(/<text [^]*?>(\d)</g)].map(([, n]) => n).sort(), ['1', '2']);
    }
    // what is seen is named: lines on the surface and on the sheet, and what several sources have for a radius
    assert.match(await page.innerText('#legend'), /seams[^]*seams of the sheet/);
    assert.match(await page.innerText('#result-note'), /nearest point to the sources is [\d.]+\s±/);
    assert.doesNotMatch(await page.textContent('#result'), /injectivity/i);
    await d.picture('cells_side_by_side.png');
  },

  async 'a source that moves beside others has previews by any distances'(d) {
    for (const solver of ['exact', 'heat']) {
      await d.open(`#sample=torus&faces=20000&solver=${solver}&method=laplacian&source=10,0.3,0.3,0.4,7000,0.2,0.3,0.5`);
      await d.previewIsReady();
      const { mean, edge } = await d.app(compareWithPreview);
      assert.ok(mean < edge, `${solver}: the preview is off by ${mean} in the mean, the simplified mesh has edges of ${edge}`);
    }
  },

  async 'a source that is pressed, or any while a key is held, follows the pointer'(d) {
    const { page } = d;
    const notes = [];
    for (const [faces, wanted] of [[20000, 30], [100000, 10]]) {
      await d.open(`#sample=torus&faces=${faces}`);
      await page.selectOption('#view', 'source');
      await page.waitForTimeout(600); // it turns
      await d.settle();
      const box = await page.locator('#model-view').boundingBox();
      const at = await d.seenAt((await d.app(({ app }) => app.toView(app.source.points[0]))));
      const place = (t) => [box.x + at[0] * box.width + 40 * Math.sin(t), box.y + at[1] * box.height + 40 * (1 - Math.cos(t))];
      const view = await d.view();
      const marker = () => d.app(({ viewer }) => viewer.sourceMarkers[0].position.toArray());
      await d.previewIsReady();
      const rates = [], computing = [];
      for (const isByKey of [false, true]) {
        await page.mouse.move(...place(0));
        await page.focus('#model-view');
        await (isByKey ? page.keyboard.down('d') : page.mouse.down());
        const start = await marker();
        const before = await d.app(({ app }) => [app.follower.updates, performance.now()]);
        const end = Date.now() + followMilliseconds;
        for (let t = 0; Date.now() < end; t += 0.05) await page.mouse.move(...place(t));
        const after = await d.app(({ app }) => [app.follower.updates, performance.now()]);
        await page.waitForFunction((n) => window.cutLocusPage.app.follower.updates > n, before[0], { timeout: patience });
        const isCoarse = await d.app(({ viewer }) => viewer.model.layer.isCoarse);
        assert.equal(isCoarse, await d.app(({ viewer }) => viewer.model.layer.interval > 0));
        assert.notDeepEqual(await marker(), start, 'the source does not follow');
        await page.mouse.move(...place(1.5));
        await (isByKey ? page.keyboard.up('d') : page.mouse.up());
        await page.waitForFunction(() => !window.cutLocusPage.app.follower.isActive);
        await d.settle();
        rates.push(1000 * (after[0] - before[0]) / (after[1] - before[1]));
        computing.push(await d.app(({ app }) => app.times.follow));
      }
      assert.deepEqual(await d.view(), view, 'the view has moved');
      assert.deepEqual(await d.app(({ viewer: { model: { layer }, faceCurve } }) =>
        [layer.isCoarse, layer.interval, layer.target.samples > 0, faceCurve.casing.visible]), [false, 0, true, true],
      'the picture at rest is not the fine one');
      // what is there at last is what a click there gives
      const end = await d.result();
      await page.mouse.click(...place(1.5));
      await d.settle();
      const clicked = await d.result();
      assert.deepEqual([end.point, end.length, end.edges], [clicked.point, clicked.length, clicked.edges]);
      notes.push(`${faces} faces: ${rates.map((r) => r.toFixed(1)).join(' and ')} per second, ${wanted} wanted; computing ${computing.map((c) => c.toFixed(0)).join(' and ')} ms`);
    }
    return notes.join('; ');
  },

  async 'a source that moves has previews, which the exact curve replaces; only that is exported and taken back'(d) {
    const { page } = d;
    const notes = [];
    for (const sample of ['genus-3', 'bumpy-sphere']) {
      await d.open(`#sample=${sample}&faces=20000`);
      await page.selectOption('#view', 'source');
      await d.settle();
      await d.previewIsReady();
      const start = await d.result();
      const first = await d.exported('faceCurve', 'obj');
      const box = await page.locator('#model-view').boundingBox();
      const at = await d.seenAt(await d.app(({ app }) => app.toView(app.source.points[0])));
      const place = (k) => [box.x + at[0] * box.width + 4 * k, box.y + at[1] * box.height + 3 * k];
      // no rest: what is exact must not come while this looks at the preview
      await d.app(({ app }) => { app.follower.replace = async () => {}; });
      await page.mouse.move(...place(0));
      await page.focus('#model-view');
      await page.keyboard.down('d');
      for (let k = 1; k < 8; ++k) await page.mouse.move(...place(k));
      await page.waitForFunction(() => window.cutLocusPage.viewer.isPreview && !window.cutLocusPage.app.follower.running);
      assert.match(await page.innerText('#preview-note'), /Preview, on [\d,]+ faces/);
      assert.ok(!await page.locator('#result-note').isVisible());
      const drawn = await d.app(drawnPreview);
      assert.deepEqual(drawn.visible, { previewCurve: true, faceCurve: false, edgeCurve: false });
      assert.ok(drawn.segments.length > 0 && drawn.faces > 0 && drawn.faces < 20000);
      assert.ok(drawn.away < 1e-6, `the preview is off the surface by ${drawn.away}`);
      // nothing of the page but the picture is that of the preview
      const during = await d.result();
      assert.deepEqual([during.point, during.length, during.edges], [start.point, start.length, start.edges]);
      await d.picture(`preview_${sample}.png`);

      // at rest, with the key still held
      await d.app(({ app }) => { delete app.follower.replace; });
      await page.mouse.move(...place(8));
      await page.waitForFunction(() => !window.cutLocusPage.viewer.isPreview && window.cutLocusPage.app.isSolved, null, { timeout: patience });
      await d.idle();
      assert.ok(await d.app(({ app }) => app.follower.isActive));
      assert.ok(!await page.locator('#preview-note').isVisible());
      const rested = await d.result();
      assert.notDeepEqual(rested.point, start.point);
      const rows = await d.app(compareWithPreview);
      assert.ok(rows.mean < rows.edge, `the preview is off by ${rows.mean} in the mean, the simplified mesh has edges of ${rows.edge}`);

      // an export ends the move: what is written is what a click there gives
      for (let k = 8; k < 14; ++k) await page.mouse.move(...place(k));
      await page.waitForFunction(() => window.cutLocusPage.viewer.isPreview);
      const exported = await d.exported('faceCurve', 'obj');
      assert.ok(!await d.app(({ app, viewer }) => viewer.isPreview || app.follower.isActive));
      await page.keyboard.up('d');
      await d.settle();
      await page.mouse.click(...place(13));
      await d.settle();
      assert.ok(exported.equals(await d.exported('faceCurve', 'obj')), 'the export is not that of the exact curve');
      assert.ok(!exported.equals(first));
      // the rest and the end of the move are one step
      await page.click('#undo');
      await d.settle();
      const undone = await d.result();
      assert.deepEqual([undone.point, undone.length, undone.edges], [start.point, start.length, start.edges]);
      assert.ok(first.equals(await d.exported('faceCurve', 'obj')));
      assert.ok(await page.isDisabled('#undo'));
      notes.push(`${sample}: on ${drawn.faces} faces, off by ${(100 * rows.mean).toFixed(2)} % of the radius in the mean, ${(100 * rows.edge).toFixed(1)} % are its edges`);
    }
    return notes.join('; ');
  },

  async 'a simplified mesh has the topology of the whole one, and a mesh that cannot have one has no previews'(d) {
    for (const [sample, genus, loops] of [['genus-3', 3, 0], ['torus', 1, 0], ['torus with holes', 1, 2]]) {
      await d.open(`#sample=${sample.split(' ')[0]}&faces=5000`);
      if (loops > 0) await d.openFile('holes.off', await d.app(withHoles));
      const { before, after, cycles, found, source } = await d.app(async ({ app }) => {
        const engine = new app.engine.constructor(() => {}, () => {});
        const { positions, triangles, component, numbers } = app.mesh;
        await engine.run('takeMesh', { positions, triangles, component, unit: numbers[3] });
        const parameters = { ...app.parameters, width: null };
        const { faces } = await engine.run('simplify', { faces: 200 });
        const preview = await engine.run('preview', {
          solver: 'exact', method: 'default', sources: app.state.sources, border: false, curve: 1, parameters, relativeError: 0, wantsValues: true,
        });
        engine.worker.terminate();
        return { before: triangles.length / 3, after: faces, cycles: preview.numbers[1], found: preview.sourceNumbers.slice(4, 6), source: app.source };
      });
      assert.ok(after <= 200 && after < before, `${after} faces`);
      assert.deepEqual([source.genus, source.borderLoops], [genus, loops]);
      assert.deepEqual(Object.values(found), [loops, genus], sample);
      if (loops === 0) assert.equal(cycles, 2 * genus, sample);
    }
    // a tetrahedron is the smallest mesh of its topology
    const message = await d.app(async ({ app }) => {
      const engine = new app.engine.constructor(() => {}, () => {});
      const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
      const triangles = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]);
      await engine.run('takeMesh', { positions, triangles, component: new Uint32Array(0), unit: 1 });
      const text = await engine.run('simplify', { faces: 2 }).then(() => null, (error) => error.message);
      engine.worker.terminate();
      return text;
    });
    assert.match(message, /cannot be simplified/);
    // where there are no previews, sources move on the whole mesh
    await d.open('#sample=torus&faces=20000');
    await d.previewIsReady();
    await d.app(({ app }) => { app.preview.faces = 0; });
    const at = await d.placeOnSurface();
    const box = await d.page.locator('#model-view').boundingBox();
    const point = () => d.app(({ app }) => app.source.points[0]);
    const start = await point();
    await d.page.mouse.move(box.x + at[0] * box.width, box.y + at[1] * box.height);
    await d.page.focus('#model-view');
    await d.page.keyboard.down('d');
    await d.page.waitForFunction((p) => window.cutLocusPage.app.source.points[0][0] !== p, start[0]);
    assert.ok(!await d.app(({ viewer }) => viewer.isPreview));
    await d.page.keyboard.up('d');
    await d.settle();
    assert.ok(await d.app(({ app }) => app.isSolved));
  },

  async 'thresholds go back to automatic with another mesh'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&width=0.5');
    assert.ok(!await page.isChecked('#width-auto'));
    await page.click('text="Capsule"');
    await d.settle();
    assert.ok(await page.isChecked('#width-auto'));
    assert.equal(await d.app(({ app }) => app.drawn.width), null);
  },

  async 'what takes long tells how much of it is done'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const shares = await page.evaluate(async () => {
      const { app } = window.cutLocusPage;
      const found = [];
      const { onProgress } = app.engine;
      app.engine.onProgress = (stage, share) => {
        onProgress(stage, share);
        found.push([stage, share, document.getElementById('busy-share').value]);
      };
      await app.openSample('torus', 200000);
      return found;
    });
    assert.ok(shares.length >= 3, JSON.stringify(shares));
    // preprocessing comes twice, for the mesh and for the part of the source; a slow machine leaves out any share, also the
    // 0 with which a stage starts
    const fallsLeft = { preprocessing: 1 };
    shares.forEach(([stage, share, shown], i) => {
      assert.ok(share >= 0 && share <= 1 && Math.abs(shown - share) < 1e-6, `${stage} ${share} ${shown}`);
      if (i === 0 || shares[i - 1][0] !== stage || share >= shares[i - 1][1]) return;
      fallsLeft[stage] = (fallsLeft[stage] ?? 0) - 1;
      assert.ok(fallsLeft[stage] >= 0, JSON.stringify(shares));
    });
    assert.ok(!await page.locator('#busy').isVisible());
  },

  async 'what takes long can be canceled, and the page goes on'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    // within the page: from outside, the click may come too late
    const text = await page.evaluate(async () => {
      const element = (id) => document.getElementById(id);
      element('faces').value = '400000';
      element('faces').dispatchEvent(new Event('change'));
      while (element('busy').hidden) await new Promise((resolve) => { setTimeout(resolve, 10); });
      element('cancel').click();
      return element('busy-text').textContent;
    });
    assert.match(text, /…$/);
    await d.settle();
    assert.match(await page.innerText('#message-text'), /Canceled/);
    await page.click('text="Capsule"');
    await page.selectOption('#faces', '5000');
    await d.settle();
    assert.equal((await d.result()).genus, 0);
  },

  async 'the keyboard does all'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await page.focus('#model-view');
    const view = await d.view();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('+');
    assert.notDeepEqual(await d.view(), view);
    await page.keyboard.press('f');
    const before = await d.result();
    await page.keyboard.press('ArrowUp');
    for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowDown');
    await page.keyboard.press('m');
    await d.settle();
    assert.equal(await page.inputValue('#method'), 'polyhedral');
    await page.keyboard.press('m');
    await d.settle();
    assert.notEqual(await page.inputValue('#method'), 'polyhedral');
    await page.keyboard.press('?');
    assert.ok(await page.locator('#help').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(!await page.locator('#help').isVisible());
    await page.keyboard.press('2');
    await d.settle();
    assert.equal((await d.result()).genus, 0);
    await page.keyboard.press('s');
    await d.settle();
    assert.notDeepEqual((await d.result()).point, before.point);
    const turned = await d.view();
    for (let i = 0; i < 6; ++i) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('t');
    await d.settle();
    assert.ok(await d.app(({ app }) => app.path.numbers.length >= 2));
    await page.keyboard.press('a');
    await d.settle();
    assert.equal((await d.result()).sources, 2);
    await page.keyboard.press('v');
    assert.notDeepEqual(await d.view(), turned);
    // on the sheet, they move the sheet
    await page.keyboard.press('s');
    await d.settle();
    await page.keyboard.press('c');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.settle();
    const still = await d.view();
    await page.focus('#atlas-view');
    for (const key of ['ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(key);
    const [x, y, zoom] = await d.app(({ viewer: { plane: { camera } } }) => [camera.position.x, camera.position.y, camera.zoom]);
    assert.ok(x < -0.05 && y > 0.05 && zoom > 1.05, `${x}, ${y}, ${zoom}`);
    assert.deepEqual(await d.view(), still);
  },
};
