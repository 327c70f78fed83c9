// What is exported is whole, in all formats, whatever is shown.
import assert from 'node:assert/strict';
import { validateBytes } from 'gltf-validator';
import { curveTopology, readGlb, readObj, readPngSize, surfaceTopology } from '../topology.mjs';

// by the validator of those who make the format
async function validate(glb) {
  const { issues } = await validateBytes(new Uint8Array(glb));
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages));
}

export const tests = {
  async 'the curve is exported whole'(d) {
    await d.open('#sample=torus&faces=5000');
    const { edges, cycles } = await d.result();
    const obj = readObj(String(await d.exported('faceCurve', 'obj')));
    assert.deepEqual(curveTopology(obj), { components: 1, cycles });
    assert.equal(obj.lines.reduce((sum, line) => sum + line.length - 1, 0), edges);
    const ply = String(await d.exported('faceCurve', 'ply'));
    assert.match(ply, new RegExp(`^ply\\nformat ascii 1.0\\n[^]*element edge ${edges}\\n`));
    assert.ok(String(await d.exported('faceCurve', 'txt')).split('\n').length > 2);
    assert.match(String(await d.exported('faceCurve', 'vtp')), new RegExp(`<VTKFile type="PolyData"[^]*NumberOfLines="${edges}"`));
    const svg = String(await d.exported('faceCurve', 'svg'));
    assert.match(svg, /^<svg [^]*id="hidden"[^>]*stroke-dasharray[^>]*d="M[^]*id="seen"[^>]*d="M[^]*<circle/);
  },

  async 'what is exported does not depend on what is shown'(d) {
    const shown = String(await d.exported('faceCurve', 'obj'));
    const edgesShown = String(await d.exported('edgeCurve', 'obj'));
    assert.notEqual(shown, edgesShown);
    await d.page.uncheck('#show-faceCurve');
    await d.settle();
    assert.equal(String(await d.exported('faceCurve', 'obj')), shown);
    assert.equal(String(await d.exported('edgeCurve', 'obj')), edgesShown);
    await d.page.check('#show-faceCurve');
    await d.settle();
    // and after a slider has moved, it is what the slider says
    await d.setWidth('0.5');
    const finer = readObj(String(await d.exported('edgeCurve', 'obj')));
    assert.ok(finer.points.length > readObj(edgesShown).points.length);
  },

  async 'the surface is cut to a disk with texture coordinates, also while it is shown closed'(d) {
    for (const sample of ['torus', 'genus-3', 'bumpy-sphere']) {
      await d.open(`#sample=${sample}&faces=5000&occlusion=true`);
      const closed = readObj(String(await d.exported('cut', 'obj')));
      assert.equal(await d.app(({ app }) => app.atlas), null);
      assert.deepEqual(surfaceTopology(closed), { euler: 1, loops: 1 });
      assert.equal(closed.textureCoordinates.length, closed.points.length);
      assert.ok(closed.textureCoordinates.every((uv) => uv.every((x) => x >= -1e-6 && x <= 1 + 1e-6)));
      if (sample === 'bumpy-sphere') continue;
      await d.page.click('#cut');
      await d.page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      assert.deepEqual(readObj(String(await d.exported('cut', 'obj'))).faces, closed.faces);
      await d.picture(`atlas_${sample}.png`);
    }
  },

  async 'surfaces are exported in all formats'(d) {
    await d.open('#sample=torus&faces=5000');
    const { vertices, copies, faces, parts } = await d.app(async ({ app }) => {
      const { uv, triangles } = await app.sheet.current();
      return { vertices: app.mesh.positions.length / 3, copies: uv.length / 2, faces: app.mesh.triangles.length / 3, parts: triangles.length / 3 };
    });
    assert.ok(copies > vertices && parts > faces);
    const ply = await d.exported('surface', 'ply');
    assert.match(ply.subarray(0, 400).toString('latin1'), new RegExp(`element vertex ${vertices}\n`));
    const header = ply.indexOf('end_header\n') + 11;
    assert.equal(ply.length - header, 28 * vertices + 13 * faces);
    await validate(await d.exported('surface', 'glb'));
    const cutPly = await d.exported('cut', 'ply');
    assert.match(cutPly.subarray(0, 400).toString('latin1'), new RegExp(`element vertex ${copies}\n[^]*property float s\n`));
    const glb = await d.exported('cut', 'glb');
    await validate(glb);
    const { meshes, accessors } = readGlb(glb);
    const { attributes, indices } = meshes[0].primitives[0];
    assert.equal(accessors[attributes.POSITION].count, copies);
    assert.equal(accessors[attributes.TEXCOORD_0].count, copies);
    assert.equal(accessors[indices].count, 3 * parts);
    const vtp = String(await d.exported('cut', 'vtp'));
    assert.match(vtp, new RegExp(`NumberOfPoints="${copies}"[^]*NumberOfPolys="${parts}"[^]*TCoords="texture"`));
    assert.match(String(await d.exported('cut', 'svg')), /^<svg [^]*d="M/);
  },

  async 'files tell by their names what is in them, and a sheet is laid flat once for all of them'(d) {
    await d.open('#sample=torus&faces=5000');
    const names = [];
    await d.app(({ app }) => {
      const { run } = app.engine;
      app.cuts = 0;
      app.engine.run = function counted(command, ...rest) {
        app.cuts += command === 'cut';
        return run.call(this, command, ...rest);
      };
    });
    for (const [what, format] of [['faceCurve', 'obj'], ['edgeCurve', 'obj'], ['surface', 'obj'], ['cut', 'obj'], ['cut', 'ply'],
      ['faceCurve', 'txt'], ['edgeCurve', 'txt'], ['picture', 'png']]) {
      await d.exported(what, format);
      names.push(d.exportedName);
    }
    assert.equal(new Set(names).size, names.length, names.join());
    assert.ok(names.every((name) => name.startsWith('torus_')), names.join());
    assert.equal(await d.app(({ app }) => app.cuts), 1);
    // other sources have another sheet
    await d.click(...await d.placeOnSurface());
    await d.exported('cut', 'obj');
    assert.equal(await d.app(({ app }) => app.cuts), 2);
  },

  async 'curves are exported with the widths of their branches'(d) {
    await d.open('#sample=torus&faces=5000');
    for (const what of ['faceCurve', 'edgeCurve']) {
      const ply = String(await d.exported(what, 'ply'));
      const [, header] = ply.match(/element edge \d+\n((?:property .*\n)*)/);
      const column = header.trim().split('\n').findIndex((line) => / width$/.test(line));
      assert.ok(column >= 0, header);
      const { edges, vertices } = { edges: Number(ply.match(/element edge (\d+)/)[1]), vertices: Number(ply.match(/element vertex (\d+)/)[1]) };
      const rows = ply.split('end_header\n')[1].trim().split('\n').slice(vertices, vertices + edges);
      const widths = rows.map((row) => Number(row.split(' ')[column]));
      // those by which the page colors it are parts of the diagonal
      const ratio = await d.app(async ({ app }, [name, list]) => {
        const { width } = await app.curveFor(name);
        const all = list.map((w, i) => w / width[i]).sort((a, b) => a - b);
        return [all[0], all[all.length - 1]];
      }, [what, widths]);
      assert.ok(ratio[0] > 0 && ratio[1] / ratio[0] < 1.001, `${what}: ${ratio}`);
      assert.match(String(await d.exported(what, 'vtp')), /Name="width"/);
    }
  },

  async 'where no path leads, files have a finite distance'(d) {
    const tetrahedron = (x) => [[x, 0, 0], [x + 1, 0, 0], [x, 1, 0], [x, 0, 1]].map((p) => p.join(' '));
    const faces = (v) => [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]].map((f) => `3 ${f.map((k) => k + v).join(' ')}`);
    await d.openFile('parts.off', ['OFF', '8 8 0', ...tetrahedron(0), ...tetrahedron(5), ...faces(0), ...faces(4)].join('\n'));
    // that is cut open is the part with the source
    for (const [what, least] of [['surface', /^-1$/], ['cut', /^0\.\d+$/]]) {
      const vtp = String(await d.exported(what, 'vtp'));
      assert.doesNotMatch(vtp, /inf|nan/i);
      const distances = vtp.match(/Name="distance"[^>]*>([^<]*)</)[1].trim().split(/\s+/).map(Number);
      assert.match(String(Math.min(...distances)), least);
      const glb = await d.exported(what, 'glb');
      const { accessors, meshes } = readGlb(glb);
      const distance = accessors[meshes[0].primitives[0].attributes._DISTANCE];
      assert.match(String(distance.min[0]), least, JSON.stringify(distance));
      assert.ok(Number.isFinite(distance.max[0]), JSON.stringify(distance));
    }
    for (const what of ['faceCurve', 'edgeCurve'])
      for (const format of ['obj', 'ply', 'vtp', 'txt']) assert.doesNotMatch(String(await d.exported(what, format)), /\b(inf|nan)/i);
  },

  async 'pictures have the size that is asked for, and a transparent background if wished'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await page.selectOption('#export-what', 'picture');
    await page.fill('#picture-width', '3000');
    await page.fill('#picture-height', '1100');
    await page.check('#picture-transparent');
    const corner = async (bytes) => page.evaluate(async (list) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(list)]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const at = (x, y) => [...context.getImageData(x, y, 1, 1).data];
      return { corner: at(5, 5), middle: at(bitmap.width / 2, Math.round(0.72 * bitmap.height)), legend: at(30, bitmap.height - 30) };
    }, [...bytes]);
    const transparent = await d.exported('picture', 'png');
    assert.deepEqual(readPngSize(transparent), [3000, 1100]);
    const seen = await corner(transparent);
    assert.equal(seen.corner[3], 0);
    assert.equal(seen.middle[3], 255);
    assert.ok(seen.legend[3] > 200, `there is no legend: ${seen.legend}`);
    await page.uncheck('#picture-transparent');
    await page.uncheck('#picture-legend');
    await page.fill('#picture-width', '300');
    await page.fill('#picture-height', '300');
    const opaque = await d.exported('picture', 'png');
    assert.deepEqual(readPngSize(opaque), [300, 300]);
    const plain = await corner(opaque);
    assert.equal(plain.corner[3], 255);
    assert.ok(plain.legend.slice(0, 3).every((x, k) => Math.abs(x - plain.corner[k]) < 3), `${plain.legend}`);
    // the screen is as it was
    assert.deepEqual(await d.app(({ viewer }) => [viewer.size.width, viewer.canvas.width / viewer.renderer.getPixelRatio()]),
      await d.app(() => { const w = document.getElementById('stage').clientWidth; return [w, w]; }));
  },
};
