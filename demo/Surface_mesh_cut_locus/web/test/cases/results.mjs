// What is computed: sources, methods, thresholds, shortest paths, and what the page says about them.
import assert from 'node:assert/strict';
import { describeValues } from '../../src/readout.js';
import { doubts, rounded } from '../../src/words.js';
import { curveTopology, readObj } from '../topology.mjs';

const cube = () => {
  const corners = [0, 1].flatMap((z) => [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]]);
  const faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7],
    [2, 7, 6], [3, 0, 4], [3, 4, 7]];
  return `OFF\n8 12 0\n${corners.map((c) => c.join(' ')).join('\n')}\n${faces.map((f) => `3 ${f.join(' ')}`).join('\n')}\n`;
};

// of radius 1, with rings of faces of the height 0.4
const makeTube = (rings) => {
  const n = 12, points = [], faces = [];
  for (let i = 0; i <= rings; ++i)
    for (let j = 0; j < n; ++j) {
      const angle = 2 * Math.PI * (j + i / 2) / n;
      points.push([Math.cos(angle), Math.sin(angle), 0.4 * i]);
      if (i === rings) continue;
      const [a, b] = [i * n + j, i * n + (j + 1) % n];
      faces.push([3, a, b, a + n], [3, b, b + n, a + n]);
    }
  return `OFF\n${points.length} ${faces.length} 0\n${[...points, ...faces].map((row) => row.join(' ')).join('\n')}\n`;
};

const tube = makeTube(12);

const square = 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';

// in units of the file
const heightsOfCurve = ({ app }) => {
  const [, , z, radius] = app.mesh.numbers;
  return Array.from(app.curve.segments).filter((_, i) => i % 3 === 2).map((x) => z + radius * x);
};

// faces and coordinates of sources on the torus of 5000 faces
const threePoints = '10,0.3,0.3,0.4,1700,0.2,0.3,0.5,3300,0.4,0.4,0.2';

export const tests = {
  async 'a sample is loaded and has the cycles of its genus'(d) {
    await d.open('#sample=torus&faces=5000');
    const { genus, cycles } = await d.result();
    assert.deepEqual({ genus, cycles }, { genus: 1, cycles: 2 });
    for (const [name, expected] of [['Genus 3', 3], ['Capsule', 0], ['Bumpy sphere', 0], ['Torus', 1]]) {
      await d.page.click(`text="${name}"`);
      await d.settle();
      const found = await d.result();
      assert.deepEqual([name, found.genus, found.cycles], [name, expected, 2 * expected]);
      assert.match(await d.page.innerText('#result-note'), new RegExp(`genus ${expected}`));
    }
  },

  async 'a click puts the source where it is'(d) {
    const before = await d.result();
    const at = await d.placeOnSurface();
    await d.click(...at);
    const after = await d.result();
    assert.notDeepEqual(after.point, before.point);
    const place = await d.app(({ app }) => app.toView(app.source.points[0]));
    const [x, y] = await d.seenAt(place);
    assert.ok(Math.hypot(x - at[0], y - at[1]) < 0.01, `the source is seen at ${x}, ${y}`);
    assert.equal(after.cycles, 2);
  },

  async 'a drag turns the model and leaves the source'(d) {
    const before = await d.result();
    const view = await d.view();
    const box = await d.page.locator('#model-view').boundingBox();
    await d.page.mouse.move(box.x + 300, box.y + 300);
    await d.page.mouse.down();
    await d.page.mouse.move(box.x + 420, box.y + 340, { steps: 4 });
    await d.page.mouse.up();
    await d.page.waitForTimeout(200);
    assert.deepEqual((await d.result()).point, before.point);
    assert.notDeepEqual(await d.view(), view);
  },

  async 'a smaller width gives more branches, also those that were not computed, and the same cycles'(d) {
    const { page } = d;
    assert.ok(await page.isChecked('#width-auto'));
    const standard = await d.result();
    const shown = Number(await page.inputValue('#width-number'));
    assert.ok(shown > 0.1 && shown < 20, `by default ${shown} %`);
    assert.match(await page.innerText('#width-note'), new RegExp(`Automatic: ${shown} %`));
    assert.equal(await page.getAttribute('#width', 'aria-valuetext'), `${shown} % of the diagonal`);
    const found = [];
    for (const width of ['50', '20', String(shown), '0.3', '0.02']) {
      await d.setWidth(width);
      found.push(await d.result());
      assert.equal(found.at(-1).cycles, 2);
    }
    const edges = found.map((f) => f.edges), lengths = found.map((f) => f.length);
    for (let i = 1; i < found.length; ++i) assert.ok(lengths[i] >= lengths[i - 1] - 1e-9, `lengths ${lengths}`);
    assert.ok(Math.abs(lengths[2] - standard.length) < 1e-2 * standard.length, `lengths ${lengths}, ${standard.length}`);
    assert.ok(edges[4] > 2 * edges[2], `edges ${edges}`);
    // what the mesh adds is called by its name
    assert.match(await page.innerText('#result-note'), /may come from the mesh/);
    assert.ok(!await page.isChecked('#width-auto'));
    await page.fill('#width-number', '1000');
    await page.keyboard.press('Tab');
    assert.equal(await page.inputValue('#width-number'), '50');
  },

  async '“Defaults” restores method, distances and thresholds'(d) {
    const { page } = d;
    await page.click('text="Torus"');
    await d.settle();
    const standard = await d.result();
    await page.selectOption('#solver', 'heat');
    await d.settle();
    await page.fill('#angle-number', '1.5');
    await d.settle();
    await page.click('#defaults');
    await d.settle();
    assert.equal(await page.inputValue('#solver'), 'exact');
    assert.equal(await page.inputValue('#method'), 'default');
    assert.ok(await page.isChecked('#width-auto'));
    assert.equal((await d.result()).edges, standard.edges);
  },

  async 'all methods and all solvers give the cycles of the torus'(d) {
    const { page } = d;
    const { leaves } = await d.result();
    for (const [solver, method] of [['exact', 'laplacian'], ['heat', null], ['graph', null], ['exact', 'polyhedral'],
      ['exact', 'default']]) {
      await page.selectOption('#solver', solver);
      await d.settle();
      assert.equal(await page.locator('#method').isDisabled(), solver !== 'exact');
      if (method) await page.selectOption('#method', method);
      await d.settle();
      assert.equal(await page.inputValue('#method'), method || 'laplacian');
      assert.equal(await page.locator('#width').isVisible(), ['default', 'polyhedral'].includes(method));
      const found = await d.result();
      assert.deepEqual([solver, method, found.cycles], [solver, method, 2]);
      if (solver !== 'exact') assert.match(await page.innerText('#result-note'), /approximate/);
      if (method !== 'polyhedral') continue;
      assert.ok(found.leaves > leaves + 100, `${found.leaves} leaves for ${leaves}`);
      assert.match(await page.innerText('#result-note'), /Each corner of the polyhedron/);
      assert.match(await page.innerText('#width-note'), /all branches/);
      await d.setWidth('20');
      assert.ok((await d.result()).leaves < leaves + 10);
    }
    // a solver of distances does not change the method for the others
    await page.click('#defaults');
    await d.settle();
    await page.selectOption('#solver', 'heat');
    await page.selectOption('#solver', 'exact');
    await d.settle();
    assert.equal(await page.inputValue('#method'), 'default');
  },

  async 'a plain polyhedron stands for itself'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    assert.equal(await d.openFile('cube.off', cube()), null);
    assert.match(await page.innerText('#width-note'), /few, sharp corners of this mesh/);
    assert.equal(await page.inputValue('#width-number'), '');
    const { edges, leaves } = await d.result();
    assert.ok(edges >= 8 && leaves >= 4, `${edges} edges, ${leaves} leaves`);
    await page.check('#show-width');
    assert.match(await page.innerText('#legend'), /in % of the diagonal:\s*0.5\s*50/);
    await page.selectOption('#method', 'polyhedral');
    await d.settle();
    assert.match(await page.innerText('#legend'), /in % of the diagonal:\s*0.5\s*50/);
    assert.equal((await d.result()).cycles, 0);
    await page.uncheck('#show-width');
    assert.doesNotMatch(await page.innerText('#legend'), /diagonal/);
  },

  async 'a cut locus without branches is explained, and the injectivity radius left out'(d) {
    const { page } = d;
    assert.equal(await d.openFile('square.off', square), null);
    assert.match(await page.innerText('#result-note'), /no branches: either all shortest paths end at the border/);
    assert.match(await page.innerText('#numbers'), /injectivity radius\s*–/);
    assert.match(await page.getAttribute('#result', 'class') || '', /is-doubtful/);
    // nor does a single point have any
    await d.open('#sample=bumpy-sphere&faces=5000');
    await d.setWidth('50');
    assert.match(await page.innerText('#result-note'), /is one point: either all shortest paths meet there/);
    assert.doesNotMatch(await page.textContent('#result-note'), /injectivity/i);
    assert.match(await page.innerText('#numbers'), /injectivity radius\s*–/);
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.idle();
    assert.match(await page.innerText('#cut-info'), /does not overlap/);
  },

  async 'what makes a result doubtful is told, with what to do about it'() {
    const told = ({ leaves = 4, corridors = 0, borderLoops = 0, faceCount = 5000, solver = 'exact', method = 'default' }) => doubts({
      curve: { numbers: [100, 2, leaves, 2, 1, 1, 0, 0, 0, 0, corridors] }, source: { hasBorder: false, borderLoops }, faceCount,
      state: { method, solver, parameters: { width: null } }, defaults: { width: 0.03 } }).join(' ');
    assert.equal(told({}), '');
    assert.match(told({ borderLoops: 3, leaves: 20 }), /go around the 3 holes[^]*should be filled first/);
    assert.equal(told({ borderLoops: 3 }), '');
    assert.match(told({ corridors: 2 }), /In 2 places the mesh is too coarse/);
    assert.match(told({ faceCount: 100 }), /A finer mesh says more/);
    assert.match(told({ solver: 'heat', method: 'laplacian' }), /Exact ones are under Method/);
    assert.match(told({ method: 'polyhedral', leaves: 100 }), /choose that under Method/);
  },

  async 'the injectivity radius is rounded to what the mesh tells, and says what it depends on'(d) {
    await d.open('#sample=torus&faces=5000');
    const text = await d.page.innerText('#numbers');
    const [, value, error] = text.match(/([\d.]+)\s±\s([\d.]+)/);
    const { radius } = await d.result();
    const edge = await d.app(({ app }) => app.mesh.edgeLength);
    assert.ok(Math.abs(value - radius) <= error && error >= 0.25 * edge && error <= edge, `${value} ± ${error}, edges of ${edge}`);
    assert.match(text, /injectivity radius\s*of branches of [\d.]+ % and more/);
  },

  async 'lengths are told as far as they are known'() {
    assert.deepEqual([rounded(1.2345, 0.05), rounded(1234.5, 60), rounded(0.1, 0.5)],
      ['1.23\u00a0±\u00a00.05', '1230\u00a0±\u00a060', 'less than 0.6']);
    assert.equal(rounded(Infinity, 1), '–');
  },

  async 'there may be several sources: a Voronoi diagram with cycles of its own'(d) {
    const { page } = d;
    const one = await d.result();
    await page.check('input[value=add]', { force: true });
    const second = await d.placeOnSurface();
    await d.click(...second);
    const two = await d.result();
    assert.deepEqual([two.sources, two.cycles], [2, 3]);
    assert.deepEqual(two.point, one.point);
    // the distance is that to the nearest one
    const largest = await d.app(({ app }) => app.source.farthestDistance);
    await d.click(...await d.placeOnSurface(1));
    const three = await d.result();
    assert.deepEqual([three.sources, three.cycles], [3, 4]);
    assert.ok(await d.app(({ app }) => app.source.farthestDistance) < largest);
    assert.match(await page.innerText('#legend'), /sources/);
    await d.picture('sources.png');
    // without the cut locus inside the cells it is shorter
    const whole = await d.result();
    const lengthOf = async (part) => {
      await page.selectOption('#keep', part);
      await page.waitForFunction((p) => window.cutLocusPage.app.drawn.keep === p && !window.cutLocusPage.app.isUpdating, part);
      return (await d.result()).length;
    };
    const parts = [await lengthOf('voronoi'), await lengthOf('medial')];
    assert.ok(parts.every((length) => length > 0 && length < whole.length), `${parts} of ${whole.length}`);
    assert.ok(Math.abs(parts[0] + parts[1] - whole.length) < 1e-3 * whole.length, `${parts} of ${whole.length}`);
    assert.equal(await lengthOf('all'), whole.length);
    // a click on one takes it away
    await d.click(...second);
    assert.equal((await d.result()).sources, 2);
    // the other way to add one
    await page.check('input[value=source]', { force: true });
    await d.click(...await d.placeOnSurface(), { keys: ['Shift'] });
    assert.equal((await d.result()).sources, 3);
  },

  async 'any distances take several sources, which other methods keep'(d) {
    const { page } = d;
    await d.open(`#sample=torus&faces=5000&source=${threePoints}`);
    const nearest = () => d.app(({ app }) => Array.from(app.source.nearest));
    const exact = await nearest();
    for (const solver of ['exact', 'heat', 'graph']) {
      await page.selectOption('#solver', solver); // the others have no other method
      if (solver === 'exact') await page.selectOption('#method', 'laplacian');
      await d.settle();
      await d.noMessage();
      const { sources, cycles, edges } = await d.result();
      assert.deepEqual([solver, sources, cycles], [solver, 3, 4]);
      assert.ok(edges > 50, `${solver}: ${edges} edges`);
      assert.deepEqual(curveTopology(readObj(String(await d.exported('faceCurve', 'obj')))), { components: 1, cycles: 4 });
      // each vertex is in a cell, which is that of the exact distances but for a strip beside the diagram
      const found = await nearest();
      assert.equal(found.length, await d.app(({ app }) => app.mesh.positions.length / 3));
      const same = found.filter((source, v) => source === exact[v]).length;
      assert.ok(same > (solver === 'graph' ? 0.85 : 0.95) * found.length, `${solver}: ${same} of ${found.length}`);
      assert.ok(await d.app(({ app }) => app.distance.every((x) => x >= 0 && x < 4)), solver);
    }
    // another method, and back
    await page.click('#defaults');
    await d.settle();
    assert.deepEqual([await page.inputValue('#method'), (await d.result()).sources], ['default', 3]);
    await page.click('#undo');
    await d.settle();
    assert.deepEqual([await page.inputValue('#solver'), (await d.result()).sources], ['graph', 3]);
  },

  async 'a sheet by the logarithmic map has true distances, and tells what that costs'(d) {
    const { page } = d;
    const sheet = () => d.app(({ app }) => {
      const { uv, parents, weights, triangles, numbers, sheets: [{ place }] } = app.atlas;
      const ratios = [];
      for (let v = 0; v < uv.length / 2; ++v)
        for (let k = 3 * v; k < 3 * v + 3; ++k)
          if (weights[k] === 1 && app.distance[parents[k]] > 0.05 * app.source.farthestDistance)
            ratios.push(Math.hypot(uv[2 * v] - place[0], uv[2 * v + 1] - place[1]) / app.distance[parents[k]]);
      const areas = [];
      for (let i = 0; i < triangles.length; i += 3) {
        const [a, b, c] = triangles.subarray(i, i + 3);
        areas.push((uv[2 * b] - uv[2 * a]) * (uv[2 * c + 1] - uv[2 * a + 1]) - (uv[2 * b + 1] - uv[2 * a + 1]) * (uv[2 * c] - uv[2 * a]));
      }
      const rounding = 1e-7; // of the sheet, in single precision
      const below = (area) => areas.filter((x) => x < area).length;
      return { least: Math.min(...ratios), most: Math.max(...ratios), flipped: numbers[0], turned: below(-rounding), notUpright: below(rounding) };
    });
    const faces = [];
    for (const sample of ['capsule', 'torus']) {
      await d.open(`#sample=${sample}&faces=5000&cut=1&parameterization=logmap`);
      const { least, most, flipped, turned, notUpright } = await sheet();
      assert.ok(least > 0.9999 * most, `${sample}: ${least} to ${most}`); // single precision
      assert.match(await page.innerText('#cut-info'), /Distances from the source are true;.* areas change by/);
      assert.ok(turned <= flipped && flipped <= notUpright, `${sample}: ${turned} <= ${flipped} <= ${notUpright}`);
      faces.push([sample, turned, flipped, notUpright].join(' '));
      await d.picture(`logmap_${sample}.png`);
    }
    // beside it, what does not overlap has other distances
    await page.selectOption('#parameterization', 'injective');
    await d.settle();
    assert.match(await page.innerText('#cut-info'), /does not overlap/);
    const { least, most } = await sheet();
    assert.ok(least < 0.9 * most, `${least} to ${most}`);
    await page.selectOption('#parameterization', 'logmap');
    await d.settle();
    assert.match(await d.hash(), /parameterization=logmap/);
    // seams of mesh edges alone would be crossed by shortest paths
    await page.check('#show-edgeCurve');
    await page.uncheck('#show-faceCurve');
    await d.settle();
    const { least: nearest, most: farthest } = await sheet();
    assert.ok(nearest > 0.9999 * farthest, `${nearest} to ${farthest}`);
    // several points have no such map
    await d.open(`#sample=torus&faces=5000&cut=1&parameterization=logmap&source=${threePoints}`);
    assert.ok(await page.isDisabled('#parameterization'));
    assert.match(await page.innerText('#cut-info'), /3 sheets, one for each cell/);
    await d.noMessage();
    return faces.join(', ');
  },

  async 'of several sources, any distances have a Voronoi diagram, what is inside its cells, and a sheet for each'(d) {
    const { page } = d;
    for (const solver of ['exact', 'heat']) {
      await d.open(`#sample=torus&faces=5000&solver=${solver}&method=laplacian&smoothing=0&source=${threePoints}`);
      const lengths = [];
      for (const part of ['voronoi', 'medial', 'all']) {
        await page.selectOption('#keep', part);
        await page.waitForFunction((p) => window.cutLocusPage.app.drawn.keep === p && !window.cutLocusPage.app.isUpdating, part);
        lengths.push((await d.result()).length);
      }
      const [between, inside, all] = lengths;
      assert.ok(between > 0 && inside > 0 && Math.abs(between + inside - all) < 1e-6 * all, `${lengths}`);
      await page.selectOption('#look-color', 'cells');
      assert.match(await page.innerText('#legend'), /nearest source:/);
      // cut with what is not shown as well
      await page.selectOption('#keep', 'voronoi');
      await d.settle();
      await page.click('#cut');
      await page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      await d.noMessage();
      assert.match(await page.innerText('#cut-info'), /3 sheets, one for each cell: none overlaps/);
    }
    await d.picture('laplacian_cells.png');
  },

  async 'sources without a face each are refused by the method that starts from edges'(d) {
    const { page } = d;
    await d.open(`#sample=torus&faces=5000&method=laplacian&source=${threePoints}`);
    const crowd = ({ app }) => app.setSources([0.2, 0.3].map((x) => ({ face: 10, coordinates: [x, 0.5, 0.5 - x] })));
    await d.app(crowd);
    await d.settle();
    assert.match(await page.innerText('#message-text'), /too close to each other/);
    assert.equal((await d.result()).sources, 3);
    assert.match(await d.hash(), new RegExp(`source=${threePoints}`));
    // others take them, and get them back
    await page.click('#defaults');
    await d.settle();
    await d.app(crowd);
    await d.settle();
    assert.equal((await d.result()).sources, 2);
    for (const [control, value] of [['#method', 'laplacian'], ['#solver', 'heat']]) {
      await page.selectOption(control, value);
      await d.settle();
      // the message stays, and the method is the former one
      assert.match(await page.innerText('#message-text'), /too close to each other/);
      assert.deepEqual([await page.inputValue('#solver'), await page.inputValue('#method')], ['exact', 'default']);
      assert.ok(await d.app(({ app }) => app.isSolved));
      assert.equal((await d.result()).sources, 2);
      assert.match(await d.hash(), /method=default/);
      await page.click('#message-close');
    }
    await page.selectOption('#method', 'polyhedral');
    await d.settle();
    await d.noMessage();
    assert.equal((await d.result()).sources, 2);
  },

  async 'of two sources that are set one after the other, the second one counts, also while the first is computed'(d) {
    await d.open('#sample=torus&faces=20000');
    const sources = await d.app(async ({ app }) => {
      const at = (face) => [{ face, coordinates: [0.3, 0.3, 0.4] }];
      await Promise.all([app.setSources(at(100)), app.setSources(at(5000))]);
      return app.state.sources;
    });
    await d.settle();
    await d.noMessage();
    assert.deepEqual(sources.map(({ face }) => face), [5000]);
    assert.deepEqual(await d.app(({ app }) => [app.isSolved, app.state.sources[0].face]), [true, 5000]);
  },

  async 'the border may be a source: its cut locus is the medial axis'(d) {
    const { page } = d;
    assert.equal(await d.openFile('tube.off', tube), null);
    const point = await d.result();
    await page.selectOption('#border', 'only');
    await d.settle();
    // between the two ends of a tube, the circle in the middle
    const { cycles, leaves, sources } = await d.result();
    assert.deepEqual([cycles, leaves, sources], [1, 0, 0]);
    const heights = await d.app(heightsOfCurve);
    assert.ok(heights.every((z) => Math.abs(z - 2.4) < 0.05), `${Math.min(...heights)} to ${Math.max(...heights)}`);
    assert.match(await page.innerText('#legend'), /the border, as a source/);
    await d.unfold('result-fold'); // a sheet of the test before has folded it
    assert.match(await page.innerText('#numbers'), /sources\s*2/);
    assert.match(await d.hash(), /border=only/);
    assert.match(String(await d.exported('faceCurve', 'svg')), /id="border"[^>]*d="M/);
    // what is for points alone says so
    await page.focus('#model-view');
    await page.keyboard.press('t');
    await page.waitForSelector('#message', { state: 'visible' });
    assert.match(await page.innerText('#message-text'), /points only/);
    // nor may a point be on it: then all stays as it was
    await d.app(async ({ app, viewer }) => {
      const face = viewer.triangles.indexOf(0); // a vertex of the border
      await app.setSources([{ face: Math.floor(face / 3), coordinates: [0, 1, 2].map((k) => Number(k === face % 3)) }], 'also');
    });
    await d.settle();
    assert.match(await page.innerText('#message-text'), /have a point in common: choose another/);
    assert.equal(await page.inputValue('#border'), 'only');
    // each half of the tube, cut open, is a sheet
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.settle();
    await d.noMessage();
    assert.match(await page.innerText('#cut-info'), /2 sheets, one for each cell: none overlaps/);
    await d.picture('border_sheets.png');
    assert.ok((await d.exported('cut', 'obj')).length > 0);
    await page.click('#cut');
    // a click adds a point; both can be taken back
    await d.click(...await d.placeOnSurface());
    assert.equal(await page.inputValue('#border'), 'also');
    assert.deepEqual([(await d.result()).sources, await d.app(({ app }) => app.source.total)], [1, 3]);
    await page.click('#undo');
    await d.settle();
    await page.click('#undo');
    await d.settle();
    assert.equal(await page.inputValue('#border'), 'no');
    assert.deepEqual((await d.result()).point, point.point);
    await page.click('#redo');
    await d.settle();
    assert.equal(await page.inputValue('#border'), 'only');
  },

  async 'with the border as a source, there is a curve along mesh edges where these separate the sources'(d) {
    const { page } = d;
    assert.equal(await d.openFile('tube.off', makeTube(11)), null);
    await page.selectOption('#border', 'only');
    await page.check('#show-edgeCurve');
    await d.settle();
    for (const method of ['default', 'polyhedral', 'laplacian']) {
      await page.selectOption('#method', method);
      await d.settle();
      await d.noMessage();
      assert.match(await page.innerText('#legend'), /cut locus along mesh edges/);
      // one loop around the tube, along its vertices, which are in rows of the height 0.4
      const obj = readObj(String(await d.exported('edgeCurve', 'obj')));
      assert.deepEqual([method, curveTopology(obj)], [method, { components: 1, cycles: 1 }]);
      assert.ok(obj.points.every(([, , z]) => Math.abs(z - 2.2) < 0.61 && Math.abs(z / 0.4 - Math.round(z / 0.4)) < 1e-6), method);
    }
    await page.click('#defaults');
    await d.settle();
    // the sheets are cut along it if it alone is shown
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.idle();
    const added = () => d.app(({ app }) => app.atlas.weights.filter((w, i) => i % 3 === 0 && w !== 1).length);
    assert.ok(await added() > 0);
    await page.uncheck('#show-faceCurve');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas && window.cutLocusPage.app.atlas.weights.every((w) => w === 0 || w === 1));
    await d.idle();
    await d.noMessage();
    assert.match(await page.innerText('#cut-info'), /2 sheets, one for each cell: none overlaps/);
    await d.picture('border_edges.png');
    await page.click('#cut');
    // two ends that are one face apart
    await page.check('#show-faceCurve');
    assert.equal(await d.openFile('ring.off', makeTube(1)), null);
    await page.selectOption('#border', 'only');
    await d.settle();
    await d.noMessage();
    assert.match(await page.innerText('#result-note'), /1 independent loop[^]*no curve along mesh edges/);
    assert.doesNotMatch(await page.innerText('#legend'), /mesh edges/);
    await page.uncheck('#show-faceCurve');
    await d.settle();
    assert.match(await page.innerText('#message-text'), /too close to each other/);
    await page.check('#show-faceCurve');
    await page.uncheck('#show-edgeCurve');
    await d.settle();
    await d.noMessage();
    assert.doesNotMatch(await page.innerText('#result-note'), /no curve along mesh edges/);
  },

  async 'any distances take the border as a source'(d) {
    const { page } = d;
    assert.equal(await d.openFile('tube.off', tube), null);
    await page.selectOption('#border', 'only');
    await d.settle();
    for (const solver of ['exact', 'heat', 'graph']) {
      await page.selectOption('#solver', solver); // the others have no other method
      if (solver === 'exact') await page.selectOption('#method', 'laplacian');
      await d.settle();
      await d.noMessage();
      assert.equal(await page.inputValue('#border'), 'only');
      const { cycles, leaves, sources } = await d.result();
      assert.deepEqual([solver, cycles, leaves, sources], [solver, 1, 0, 0]);
      const heights = await d.app(heightsOfCurve);
      assert.ok(heights.every((z) => Math.abs(z - 2.4) < 0.3), `${solver}: ${Math.min(...heights)} to ${Math.max(...heights)}`);
      // each end has its half
      assert.deepEqual(await d.app(({ app, viewer }) => [0, 1].map((end) => {
        const { nearest } = app.source;
        const isThere = (v) => (viewer.positions[3 * v + 2] > 0) === Boolean(end);
        const found = nearest.filter((_, v) => isThere(v) && Math.abs(viewer.positions[3 * v + 2]) > 0.2);
        return new Set(found).size;
      })), [1, 1], solver);
      assert.equal(await d.app(({ app }) => new Set(app.source.nearest).size), 2);
      assert.match(await page.innerText('#legend'), /the border, as a source/);
    }
    // with a point beside it
    await d.click(...await d.placeOnSurface());
    assert.equal(await page.inputValue('#border'), 'also');
    assert.deepEqual([(await d.result()).sources, await d.app(({ app }) => app.source.total)], [1, 3]);
    await page.click('#cut');
    await page.waitForFunction(() => window.cutLocusPage.app.atlas);
    await d.settle();
    await d.noMessage();
    assert.match(await page.innerText('#cut-info'), /3 sheets, one for each cell/);
    await page.click('#cut');
    // a link opens with the same
    const hash = await d.hash();
    assert.match(hash, /border=also/);
    assert.match(hash, /method=laplacian/);
    await page.click('#defaults');
    await d.settle();
  },

  async 'a point has one shortest path, and one of the cut locus has two of the same length'(d) {
    await d.open('#sample=torus&faces=5000');
    await d.page.check('input[value=path]', { force: true });
    // in the middle of the curve that is seen, and not near an end
    const place = await d.app(({ app, viewer }) => {
      const { segments } = app.curve;
      for (let i = 0; i < segments.length; i += 6) {
        const p = [0, 1, 2].map((k) => (segments[i + k] + segments[i + 3 + k]) / 2);
        const seen = viewer.pointer.atPlace(p);
        if (seen && app.curve.width[i / 6] > 0.3 && Math.hypot(...seen.place.map((x, k) => x - p[k])) < 0.005) return p;
      }
      throw new Error('nothing of the curve is seen');
    });
    const before = await d.result();
    await d.click(...await d.seenAt(place));
    const [one, two] = await d.app(({ app }) => [app.path.numbers[1], app.path.numbers[3]]);
    assert.ok(Math.abs(one - two) < 0.01 * one, `${one} and ${two}`);
    assert.match(await d.page.innerText('#legend'), /2 shortest paths, [\d.]+ each/);
    await d.picture('paths.png');
    // elsewhere there is one: it ends at the source, and is as long as the distance
    await d.click(...await d.placeOnSurface());
    const path = await d.app(({ app }) => ({
      count: app.path.numbers.length / 2,
      length: app.path.numbers[1],
      end: [...app.path.points.subarray(-3)],
      source: app.toView(app.source.points[0]),
    }));
    assert.equal(path.count, 1);
    assert.ok(Math.hypot(...path.end.map((x, k) => x - path.source[k])) < 1e-5);
    assert.deepEqual((await d.result()).point, before.point);
    // it belongs to its source
    await d.page.check('input[value=source]', { force: true });
    await d.click(...await d.placeOnSurface(1));
    assert.equal(await d.app(({ app }) => app.path), null);
  },

  async 'what is between two sources is no branch of any angle'() {
    const told = (gap) => describeValues({ vertex: 1, distance: 1, angle: 0, branch: { gap, width: 0.2, away: 1, isHere: true } }, true);
    assert.match(told(Math.PI), /on a branch, angle 180°/);
    assert.match(told(Math.fround(2 * Math.PI)), /on a branch, between two sources/);
  },

  async 'values are shown where the pointer rests'(d) {
    const { page } = d;
    const box = await page.locator('#model-view').boundingBox();
    const [x, y] = await d.placeOnSurface();
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await page.waitForSelector('#readout', { state: 'visible' });
    const text = await page.innerText('#readout');
    assert.match(text, /vertex \d+[^]*from the source[^]*gradients around it[^]*nearest branch [\d.]+ away, [\d.]+ % wide/);
    const told = Number(text.match(/([\d.]+) from the source/)[1]);
    const truth = await d.app(({ app }, v) => app.distance[v], Number(text.match(/vertex (\d+)/)[1]));
    assert.ok(Math.abs(told - truth) < 0.1, `${told} beside a vertex at ${truth}`);
    await page.uncheck('#show-values');
    assert.ok(!await page.locator('#readout').isVisible());
    await page.check('#show-values');
  },
};
