// Meshes as they are found: opened, cut and exported.
import assert from 'node:assert/strict';
import { stat } from 'node:fs/promises';
import { join } from 'node:path';
import { flippedFaces, readObj, surfaceTopology } from '../topology.mjs';

// of CGAL's data folder, each for something different: limbs, genus, borders, several formats, faces that are no triangles
const files = ['elephant.off', 'man.off', 'dino.off', 'bull.off', 'cow.off', 'hand.off', 'mesh_with_border.off', '3torus.off',
  'pig.stl', 'cube_quad.off'];
const pictured = ['elephant.off', 'man.off', 'cow.off', 'bull.off', 'mesh_with_border.off'];

export const tests = {
  async 'ten meshes are opened, cut and exported'(d, { meshFolder }) {
    if (!meshFolder) return 'left out: no folder is given';
    await d.open('#sample=torus&faces=5000&occlusion=true');
    const notes = [];
    for (const file of files) {
      const path = join(meshFolder, file);
      assert.ok(await stat(path).catch(() => null), `${path} is not there`);
      await d.openPath(path);
      await d.noMessage();
      assert.ok((await d.page.innerText('#mesh-info')).startsWith(`${file}: `), file);
      // nothing lies before the source
      const behind = await d.app(({ app, viewer }) => {
        const place = app.toView(app.source.points[0]);
        const hit = viewer.pointer.atPlace(place);
        const eye = viewer.camera.position.toArray();
        const away = (point) => Math.hypot(...point.map((x, k) => x - eye[k]));
        return hit ? away(place) - away(hit.place) : 0;
      });
      assert.ok(behind < 0.02, `${file}: the source is hidden at first, ${behind} behind the surface`);
      if (pictured.includes(file)) {
        await d.picture(`mesh_${file.replace(/\.\w+$/, '')}.png`);
        const view = await d.view();
        await d.app(({ viewer }) => viewer.orbit(Math.PI, 0));
        await d.picture(`mesh_${file.replace(/\.\w+$/, '')}_behind.png`);
        await d.app(({ viewer }, v) => viewer.setView(v), view);
      }
      const { edges, genus } = await d.result();
      const curve = readObj(String(await d.exported('faceCurve', 'obj')));
      assert.equal(curve.lines.reduce((sum, line) => sum + line.length - 1, 0), edges, file);
      await d.page.click('#cut');
      await d.page.waitForFunction(() => window.cutLocusPage.app.atlas);
      await d.idle();
      assert.match(await d.page.innerText('#cut-info'), /does not overlap/, file);
      if (pictured.includes(file)) await d.picture(`mesh_${file.replace(/\.\w+$/, '')}_cut.png`);
      const cut = readObj(String(await d.exported('cut', 'obj')));
      await d.noMessage();
      assert.equal(flippedFaces(cut), 0, file);
      const parts = await d.app(({ app }) => new Set(app.mesh.component).size);
      if (parts === 1) assert.deepEqual(surfaceTopology(cut), { euler: 1, loops: 1 }, file);
      notes.push(`${file} genus ${genus}`);
    }
    return notes.join(', ');
  },
};
