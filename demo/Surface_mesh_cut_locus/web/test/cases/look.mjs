// How it looks: the hidden parts of the curve, the layers, views, the axis that is up, the colors and their legend.
import assert from 'node:assert/strict';

// the colors, in [0, 255], of the canvas at pixels of the page
export const colorsAt = (d, pixels) => d.app(({ viewer }, list) => {
  viewer.draw();
  const gl = viewer.renderer.getContext();
  const ratio = viewer.renderer.getPixelRatio();
  return list.map(([x, y]) => {
    const bytes = new Uint8Array(4);
    gl.readPixels(Math.round(ratio * x), Math.round(ratio * (viewer.size.height - y)), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return [...bytes].slice(0, 3);
  });
}, pixels);

export const isReddish = ([r, g, b]) => r > g + 18 && r > b + 18;

// Of points on the curve, those that are seen and those that are not, at their pixels.
export const curvePixels = (d) => d.app(({ app, viewer }) => {
  const { segments } = app.curve;
  const { width, height } = viewer.size;
  const result = { seen: [], hidden: [] };
  for (let i = 0; i < segments.length; i += 6 * Math.ceil(segments.length / 6 / 60)) {
    const p = [0, 1, 2].map((k) => (segments[i + k] + segments[i + 3 + k]) / 2);
    const hit = viewer.pointer.atPlace(p);
    if (!hit) continue;
    const off = Math.hypot(...hit.place.map((x, k) => x - p[k]));
    const v = viewer.farthestMarker.position.clone().set(...p).project(viewer.camera);
    const pixel = [(v.x + 1) / 2 * width, (1 - v.y) / 2 * height];
    if (off < 0.005) result.seen.push(pixel);
    else if (off > 0.1) result.hidden.push(pixel);
  }
  return result;
});

async function shareOfRed(d, pixels) {
  const colors = await colorsAt(d, pixels);
  return colors.filter(isReddish).length / Math.max(pixels.length, 1);
}

export const tests = {
  async 'hidden parts of the curve are seen through the surface, unless they are switched off'(d) {
    await d.open('#sample=torus&faces=5000&occlusion=false');
    const pixels = await curvePixels(d);
    assert.ok(pixels.seen.length > 5 && pixels.hidden.length > 5, JSON.stringify(pixels));
    assert.ok(await shareOfRed(d, pixels.seen) > 0.9);
    assert.ok(await shareOfRed(d, pixels.hidden) > 0.8);
    await d.page.uncheck('#show-hidden');
    await d.page.waitForTimeout(200);
    assert.ok(await shareOfRed(d, pixels.hidden) < 0.2);
    await d.page.check('#show-hidden');
  },

  async 'a transparent surface shows its back and the curve behind it'(d) {
    const { hidden } = await curvePixels(d);
    const saturation = async () =>
      (await colorsAt(d, hidden)).reduce((sum, [r, g]) => sum + r - g, 0) / hidden.length;
    const before = await saturation();
    await d.page.fill('#look-transparency', '0.6');
    await d.page.waitForTimeout(200);
    assert.ok(await saturation() > before + 20);
    assert.match(await d.hash(), /transparency=0.6/);
    await d.picture('transparent.png');
    await d.page.fill('#look-transparency', '0');
  },

  async 'the first view shows source and curve, from every side that the mesh has'(d) {
    for (const sample of ['torus', 'genus-3', 'bumpy-sphere', 'capsule']) {
      await d.open(`#sample=${sample}&faces=5000`);
      const { seen, hidden } = await curvePixels(d);
      const source = await d.app(({ app, viewer }) => {
        const place = app.toView(app.source.points[0]);
        const hit = viewer.pointer.atPlace(place);
        return hit ? Math.hypot(...hit.place.map((x, k) => x - place[k])) : 1;
      });
      assert.ok(source < 0.03, `${sample}: the source is hidden`);
      if (sample === 'capsule') continue; // its curve is opposite to the source
      assert.ok(seen.length / (seen.length + hidden.length) > 0.12, `${sample}: ${seen.length} of ${seen.length + hidden.length} are seen`);
    }
  },

  async 'the axis that is up is guessed, and can be chosen'(d) {
    await d.open('#sample=torus&faces=5000');
    const cone = (place) => {
      const n = 24, points = [[0, 0, 0], [0, 0, 2]], faces = [];
      for (let i = 0; i < n; ++i) points.push([Math.cos(2 * Math.PI * i / n), Math.sin(2 * Math.PI * i / n), 0]);
      for (let i = 0; i < n; ++i) faces.push([0, 2 + (i + 1) % n, 2 + i], [1, 2 + i, 2 + (i + 1) % n]);
      return `OFF\n${points.length} ${faces.length} 0\n${points.map((p) => place(p).join(' ')).join('\n')}\n`
        + `${faces.map((f) => `3 ${f.join(' ')}`).join('\n')}\n`;
    };
    const up = () => d.app(({ viewer }) => viewer.camera.up.toArray());
    await d.openFile('cone_z.off', cone(([x, y, z]) => [x, y, z]));
    assert.deepEqual(await up(), [0, 0, 1]);
    await d.openFile('cone_y.off', cone(([x, y, z]) => [x, z, -y]));
    assert.deepEqual(await up(), [0, 1, 0]);
    await d.page.selectOption('#look-up', 'z');
    assert.deepEqual(await up(), [0, 0, 1]);
  },

  async 'views from all sides, and all of the mesh fits in'(d) {
    await d.open('#sample=torus&faces=5000');
    const eye = () => d.app(({ viewer }) => viewer.camera.position.clone().normalize().toArray());
    const expected = { front: [0, -1, 0], back: [0, 1, 0], left: [-1, 0, 0], right: [1, 0, 0], top: [0, 0, 1], bottom: [0, 0, -1] };
    for (const [name, direction] of Object.entries(expected)) {
      await d.page.selectOption('#view', name);
      const found = await eye();
      assert.ok(Math.hypot(...found.map((x, k) => x - direction[k])) < 1e-3, `${name}: ${found}`);
      const outside = await d.app(({ viewer }) => {
        viewer.draw();
        const p = viewer.farthestMarker.position.clone();
        let largest = 0;
        for (let i = 0; i < viewer.positions.length; i += 3) {
          p.fromArray(viewer.positions, i).project(viewer.camera);
          largest = Math.max(largest, Math.abs(p.x), Math.abs(p.y));
        }
        return largest;
      });
      assert.ok(outside < 1 && outside > 0.6, `${name}: up to ${outside}`);
    }
    await d.page.focus('#model-view');
    for (let i = 0; i < 8; ++i) await d.page.keyboard.press('+');
    await d.page.click('#fit');
    assert.ok(Math.hypot(...await eye()) > 0.99);
  },

  async 'the wheel zooms to the pointer'(d) {
    await d.page.selectOption('#view', 'front');
    await d.page.waitForTimeout(100);
    const box = await d.page.locator('#model-view').boundingBox();
    // far from the middle of the mesh, which stays where it is if that is not done
    const [x0, y0, place] = await d.app(({ viewer }) => {
      const { width, height } = viewer.boxOf(viewer.model);
      viewer.draw();
      const middle = viewer.controls.target.clone().project(viewer.camera);
      for (let x = Math.floor((middle.x + 1) / 2 * width); x > 0; x -= 4) {
        const y = (1 - middle.y) / 2 * height;
        const next = viewer.pointer.onModel(x - 30, y);
        if (!next) return [x / width, y / height, viewer.pointer.onModel(x, y).place];
      }
      throw new Error('the mesh has no end');
    });
    await d.page.mouse.move(box.x + x0 * box.width, box.y + y0 * box.height);
    for (let i = 0; i < 4; ++i) await d.page.mouse.wheel(0, -120);
    await d.page.waitForTimeout(200);
    const [x, y] = await d.seenAt(place);
    assert.ok(Math.hypot(x - x0, y - y0) < 0.01, `it moved from ${x0}, ${y0} to ${x}, ${y}`);
  },

  async 'each layer is seen, and the legend names it'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&occlusion=false');
    const layers = [['#show-edgeCurve', /along mesh edges/], ['#show-width', /width of the branches/],
      ['#show-gradient', /away from the source/], ['#show-disk', /unique shortest paths[^]*nearest point/],
      ['#look-wireframe', /edges of the mesh/], ['#look-occlusion', null], ['#look-axes', null], ['#show-isolines', /equal distance, every/]];
    for (const [box, words] of layers) {
      const wasOn = await page.isChecked(box);
      const before = await d.shot('layer.png');
      await page.locator(box).click();
      await d.settle();
      assert.ok(!before.equals(await d.shot('layer.png')), `${box} is not seen`);
      if (wasOn) await page.locator(box).click();
      if (words) assert.match(await page.innerText('#legend'), words);
    }
    for (const [choice, value, words] of [['#look-color', 'distance', /distance:\s*0\s*[\d.]+/],
      ['#look-color', 'laplacian', /Laplacian:\s*−[\d.]+\s*[\d.]+/], ['#look-shading', 'flat', null]]) {
      const before = await d.shot('layer.png');
      await page.selectOption(choice, value);
      await d.settle();
      assert.ok(!before.equals(await d.shot('layer.png')), `${value} is not seen`);
      if (words) assert.match(await page.innerText('#legend'), words);
    }
    await d.picture('layers.png');
  },

  async 'colors of the distance are those of their scale'(d) {
    await d.open('#sample=bumpy-sphere&faces=5000&color=distance&shading=smooth&occlusion=false&show=-isolines,-faceCurve,-hidden');
    // near the source it is yellow, far away blue: red over blue, whatever the light
    const [near, far] = await d.app(({ app, viewer }) => {
      const pixelWhere = (test) => {
        for (let x = 10; x < viewer.size.width; x += 9)
          for (let y = 10; y < viewer.size.height; y += 9) {
            const hit = viewer.pointer.onModel(x, y);
            if (hit && test(app.distance[viewer.triangles[3 * hit.face]] / app.source.farthestDistance)) return [x, y];
          }
        throw new Error('there is no such place');
      };
      return [pixelWhere((s) => s > 0.06 && s < 0.12), pixelWhere((s) => s > 0.6 && s < 0.75)];
    });
    const [[r, , b], [r2, , b2]] = await colorsAt(d, [near, far]);
    assert.ok(r > 1.6 * b, `near the source ${[r, b]}`);
    assert.ok(b2 > r2, `far away ${[r2, b2]}`);
  },

  async 'colors tell which source is the nearest'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&color=cells&show=-isolines,-hidden,-values&source=10,0.3,0.3,0.4,2000,0.2,0.3,0.5');
    assert.match(await page.innerText('#legend'), /nearest source:\s*1\s*2/);
    // by where the sources are, and by the distances themselves
    const places = await d.app(({ app, viewer }) => {
      const found = [[], []];
      for (let x = 10; x < viewer.size.width; x += 14)
        for (let y = 10; y < viewer.size.height; y += 14) {
          const hit = viewer.pointer.onModel(x, y);
          if (!hit) continue;
          const corners = [0, 1, 2].map((k) => app.source.nearest[viewer.triangles[3 * hit.face + k]]);
          if (corners.every((c) => c === corners[0])) found[corners[0]].push([x, y]);
        }
      return found;
    });
    assert.ok(places.every((list) => list.length > 20), places.map((list) => list.length).join());
    const hues = [];
    for (const list of places) {
      const colors = await colorsAt(d, list);
      // of most pixels, as markers and the curve lie above some: how much more blue than red, relative to the light
      hues.push(colors.map(([r, g, b]) => (b - r) / (r + g + b)).sort((a, b) => a - b)[colors.length >> 1]);
    }
    assert.ok(Math.abs(hues[0] - hues[1]) > 0.05, `${hues}`);
    await d.open('#sample=torus&faces=5000&color=cells');
    assert.doesNotMatch(await page.innerText('#legend'), /nearest source/);
    await page.selectOption('#look-color', 'plain');
  },

  async 'cells have their colors exactly along the curve, on the surface and on the sheets'(d) {
    for (const cut of ['', '&cut=1']) {
      await d.open(`#sample=torus&faces=600&color=cells&show=-isolines,-hidden,-values,-checker&source=10,0.3,0.3,0.4,300,0.2,0.3,0.5${cut}`);
      // by distances to each of the sources, where they differ by more than what a face makes of them
      const places = await d.app(async ({ app, viewer }) => {
        const { sources } = app.state;
        const distances = [];
        for (const source of sources) {
          const { solver, method, parameters } = app.state;
          distances.push((await app.engine.run('solve', { solver, method, sources: [source], border: false, parameters, curves: [1] })).distance);
        }
        viewer.draw();
        const found = { pure: [[], []], mixed: [[], []] };
        const { width, height } = viewer.boxOf(viewer.model);
        for (let x = 4; x < width; x += 4)
          for (let y = 4; y < height; y += 4) {
            const hit = viewer.pointer.onModel(x, y);
            if (!hit) continue;
            const corners = [0, 1, 2].map((k) => viewer.triangles[3 * hit.face + k]);
            const [a, b] = distances.map((values) => hit.coordinates.reduce((sum, c, k) => sum + c * values[corners[k]], 0));
            if (Math.abs(a - b) < 0.3 * app.mesh.edgeLength) continue;
            const isMixed = new Set(corners.map((v) => app.source.nearest[v])).size > 1;
            found[isMixed ? 'mixed' : 'pure'][a < b ? 0 : 1].push([x, y]);
          }
        return found;
      });
      const hue = ([r, g, b]) => (b - r) / (r + g + b);
      const hues = [];
      for (const list of places.pure) {
        assert.ok(list.length > 50);
        hues.push((await colorsAt(d, list)).map(hue).sort((a, b) => a - b)[list.length >> 1]);
      }
      const colors = await Promise.all(places.mixed.map((list) => colorsAt(d, list)));
      const total = places.mixed.flat().length;
      assert.ok(total > 60, `${total} pixels`);
      // markers and lines lie above a few
      const right = colors.map((list, i) => list.filter((color) => Math.abs(hue(color) - hues[i]) < 0.12 * Math.abs(hues[1] - hues[0])).length);
      assert.ok((right[0] + right[1]) / total > 0.85, `${cut}: ${right} of ${places.mixed.map((list) => list.length)}`);
      await d.picture(`cells${cut ? '_cut' : ''}.png`);
    }
    // a threshold moves the curve, and the colors with it; closed again, the surface is divided again
    await d.page.click('#cut');
    await d.settle();
    const step = () => d.app(({ app }) => app.cellColors.step);
    const before = await step();
    assert.ok(before);
    await d.setWidth('1');
    await d.page.waitForFunction((old) => window.cutLocusPage.app.cellColors.step !== old, before);
    await d.noMessage();
  },

  async 'light and dark'(d) {
    await d.open('#sample=torus&faces=5000');
    const back = async () => (await colorsAt(d, [[20, 300]]))[0];
    assert.ok((await back())[0] > 230);
    await d.page.emulateMedia({ colorScheme: 'dark' });
    await d.page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
    assert.ok((await back())[0] < 40);
    await d.page.selectOption('#look-theme', 'light');
    assert.ok((await back())[0] > 230);
    await d.page.emulateMedia({ colorScheme: 'light' });
    await d.page.selectOption('#look-theme', 'auto');
  },

  async 'lines of a graphics card are those of a processor'(d) {
    const { page } = d;
    const compared = async () => {
      const pictures = [];
      for (const isInstanced of [false, true]) {
        await d.app(({ viewer }, value) => viewer.setInstanced(value), isInstanced);
        assert.equal(await d.app(({ viewer }) => Boolean(viewer.faceCurve.visibleLines.geometry.isInstancedBufferGeometry)), isInstanced);
        pictures.push(await d.shot(`instanced_${isInstanced}.png`));
      }
      assert.ok(pictures[0].equals(pictures[1]));
      return pictures[0];
    };
    await d.open('#sample=torus&faces=5000');
    const whole = await compared();
    await page.fill('#wave-front', '600');
    assert.ok(!whole.equals(await compared()), 'a part is shown');
    await page.fill('#wave-front', '1000');
    await page.check('#show-width');
    assert.ok(!whole.equals(await compared()), 'colors are seen');
    // other segments in the same buffers, as those of previews, and more than there is room for
    assert.deepEqual(await d.app(({ viewer }) => {
      const counts = [];
      for (const curve of [viewer.previewCurve, viewer.faceCurve])
        for (const count of [4, 3, 8, 50]) {
          curve.set(new Float32Array(6 * count));
          counts.push(curve.visibleLines.geometry.instanceCount);
        }
      return counts;
    }), [4, 3, 8, 50, 4, 3, 8, 50]);
  },

  async 'a plane cuts away a part of the mesh, of the curve and of what a click finds'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    await page.selectOption('#view', 'top');
    const ofSides = () => d.app(({ app, viewer }) => {
      const { width, height } = viewer.boxOf(viewer.model);
      const found = { kept: [], away: [] };
      for (let x = 4; x < width; x += 12)
        for (let y = 4; y < height; y += 12) {
          const hit = viewer.pointer.onModel(x, y);
          if (hit && Math.abs(hit.place[0]) > 0.1) found[hit.place[0] < 0 ? 'kept' : 'away'].push([x, y]);
        }
      const seen = app.source.points.map((point) => app.toView(point)[0] < 0);
      viewer.draw();
      return { ...found, isSeen: viewer.sourceMarkers[0].visible, isKept: seen[0] };
    });
    const before = await ofSides();
    assert.ok(before.kept.length > 50 && before.away.length > 50 && before.isSeen && !before.isKept);
    assert.ok(!await page.locator('#look-clipAt').isVisible());
    await page.selectOption('#look-clip', 'x');
    const after = await ofSides();
    assert.deepEqual([after.away.length, after.isSeen], [0, false]);
    assert.deepEqual(after.kept, before.kept);
    const back = (await colorsAt(d, [[2, 5]]))[0].join();
    // the canvas is the stage, which is all of the model's part here
    const isGone = async (pixels) => (await colorsAt(d, pixels)).filter((color) => color.join() === back).length / pixels.length;
    const gone = await isGone(before.away);
    assert.ok(gone > 0.99, `of what is cut away, ${gone} is not drawn`);
    assert.ok(await isGone(before.kept) < 0.1, 'all is gone');
    await page.fill('#look-clipAt', '1');
    assert.equal((await ofSides()).away.length, before.away.length);
    await page.selectOption('#look-clip', '-x');
    await page.fill('#look-clipAt', '0.5');
    assert.equal((await ofSides()).kept.length, 0);
    assert.match(await d.hash(), /clip=-x/);
    await d.picture('clipped.png');
    // the curve that is exported as it is seen is clipped, too
    const svg = String(await d.exported('faceCurve', 'svg'));
    await page.selectOption('#look-clip', 'no');
    assert.ok(svg.length < 0.75 * String(await d.exported('faceCurve', 'svg')).length);
    await d.noMessage();
  },

  async 'without perspective, parallel lines stay parallel, and clicks, zoom and fit work'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000');
    const ratio = () => d.app(({ viewer }) => {
      viewer.draw();
      const at = (x, y, z) => viewer.farthestMarker.position.clone().set(x, y, z).project(viewer.camera);
      const length = (y) => at(0.5, y, 0).distanceTo(at(-0.5, y, 0));
      return length(-0.6) / length(0.6);
    });
    await page.selectOption('#view', 'front');
    assert.ok(await ratio() > 1.2);
    await page.selectOption('#look-projection', 'orthographic');
    assert.ok(Math.abs(await ratio() - 1) < 1e-6);
    await page.selectOption('#view', 'front');
    const extent = () => d.app(({ viewer }) => {
      viewer.draw();
      const p = viewer.farthestMarker.position.clone();
      let largest = 0;
      for (let i = 0; i < viewer.positions.length; i += 3) {
        p.fromArray(viewer.positions, i).project(viewer.camera);
        largest = Math.max(largest, Math.abs(p.x), Math.abs(p.y));
      }
      return largest;
    });
    const whole = await extent();
    assert.ok(whole < 1 && whole > 0.6, `up to ${whole}`);
    // what is under the pointer stays there
    const box = await page.locator('#model-view').boundingBox();
    const [x, y] = await d.placeOnSurface();
    const place = await d.app(({ viewer }, [u, v]) => {
      const { width, height } = viewer.boxOf(viewer.model);
      return viewer.pointer.onModel(u * width, v * height).place;
    }, [x, y]);
    const seen = await d.seenAt(place);
    assert.ok(Math.hypot(seen[0] - x, seen[1] - y) < 1e-3, 'a click finds another place');
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -120);
    await page.waitForTimeout(300);
    const now = await d.seenAt(place);
    assert.ok(Math.hypot(now[0] - x, now[1] - y) < 0.01, `it moved from ${x}, ${y} to ${now}`);
    const near = await extent();
    assert.ok(near > 1.1 * whole, `${near} after ${whole}`);
    await page.focus('#model-view');
    await page.keyboard.press('-');
    assert.ok(await extent() < near);
    await page.click('#fit');
    assert.ok(Math.abs(await extent() - whole) < 0.01);
    const { point } = await d.result();
    await d.click(x, y);
    assert.notDeepEqual((await d.result()).point, point);
    await d.picture('parallel.png');
    const hash = await d.hash();
    assert.match(hash, /projection=orthographic/);
    const view = await d.view();
    await d.open(hash);
    (await d.view()).forEach((c, k) => assert.ok(Math.abs(c - view[k]) < 1e-3));
    await page.selectOption('#look-projection', 'perspective');
    assert.ok(Math.abs(await ratio() - 1) > 0.01);
  },

  async 'lines are as wide, and distances as colored, as is chosen'(d) {
    const { page } = d;
    await d.open('#sample=torus&faces=5000&color=distance&occlusion=false&show=-isolines');
    const reds = async () => {
      const pixels = [];
      const { width, height } = await d.app(({ viewer }) => viewer.size);
      for (let x = 0; x < width; x += 3) for (let y = 60; y < height - 60; y += 3) pixels.push([x, y]);
      const colors = await colorsAt(d, pixels);
      return colors.filter(([r, g, b]) => r > 150 && g < 60 && b < 70).length;
    };
    const usual = await reds();
    await page.fill('#look-lineWidth', '3');
    const wide = await reds();
    assert.ok(wide > 2 * usual && usual > 50, `${usual} and ${wide} red pixels`);
    const [x, y] = await d.placeOnSurface();
    const place = await d.app(({ viewer }, [u, v]) => [u * viewer.size.width, v * viewer.size.height], [x, y]);
    const seen = new Set();
    for (const map of ['viridis', 'cividis', 'magma', 'grays']) {
      await page.selectOption('#look-map', map);
      const ramp = await page.$eval('#legend .bar i', (e) => e.style.background);
      const [pixel] = await colorsAt(d, [place]);
      seen.add(ramp);
      seen.add(pixel.join());
    }
    assert.equal(seen.size, 8, [...seen].join('\n'));
    assert.match(await d.hash(), /lineWidth=3&map=grays/);
    await d.picture('wide_lines.png');
  },

  async 'a frame in which only the curve changes shows the same as a whole one'(d) {
    await d.open('#sample=torus&faces=5000');
    await d.setWidth('30');
    const canvas = (isWhole) => d.app(async ({ viewer }, whole) => {
      if (whole) viewer.model.layer.isValid = false;
      viewer.draw();
      const blob = await new Promise((resolve) => { viewer.canvas.toBlob(resolve); });
      return [...new Uint8Array(await crypto.subtle.digest('SHA-256', await blob.arrayBuffer()))].join();
    }, isWhole);
    const kept = await canvas(false);
    assert.equal(kept, await canvas(true));
    await d.setWidth('0.5');
    assert.notEqual(kept, await canvas(false));
  },
};
