// How the result is shown: the layers, the colors, the light, and from where one looks.
import { branchScale } from './branch_scale.js';
import { applyTheme, onPreference, themeColors } from './theme.js';

export class Appearance {
  constructor(app) {
    this.app = app;
    this.forgetFields();
    onPreference(() => this.apply());
    app.store.subscribe((state, changed) => { if (changed.includes('look')) this.apply(); });
  }

  // The Laplacian and the gradient are those of a source.
  forgetFields() {
    this.laplacian = null;
    this.gradient = null;
  }

  async setShown(name, value) {
    this.app.store.set({ show: { [name]: value } });
    if (name === 'faceCurve' || name === 'edgeCurve') await this.app.updateCurves();
    this.drawCurves();
    if (value && name === 'gradient') await this.app.attempt('Computing…', () => this.showFields());
    if (name === 'values') this.app.hover(null);
    this.app.viewer.invalidateCurves();
    this.app.report();
  }

  async setLook(name, value) {
    this.app.store.set({ look: { [name]: value } });
    if (name === 'color') {
      this.updateSurface();
      if (value === 'laplacian' || value === 'cells') await this.app.attempt('Computing…', () => this.showFields());
    }
    if (name === 'up') this.look('best');
    this.app.report();
  }

  apply() {
    const { look } = this.app.state;
    const { viewer } = this.app;
    applyTheme(look.theme);
    viewer.setTheme(themeColors());
    viewer.setUp(look.up === 'auto' ? (this.app.mesh ? this.app.mesh.up : 'z') : look.up);
    viewer.setTransparency(look.transparency);
    viewer.setUniforms({ isFlat: look.shading === 'flat' });
    viewer.setProjection(look.projection);
    viewer.setClip(look.clip, look.clipAt);
    viewer.setLineWidth(look.lineWidth);
    viewer.setMap(look.map);
    viewer.setOcclusion(look.occlusion);
    viewer.hasAxes = look.axes;
    viewer.showWireframe(look.wireframe);
    if (this.app.curve) this.app.report();
  }

  drawCurves() {
    const { show } = this.app.state;
    const scale = branchScale(this.app.state);
    this.app.panel.setScale(scale);
    for (const name of ['edgeCurve', 'faceCurve']) {
      const curve = this.app.curves[name];
      const isShown = show[name] && Boolean(curve);
      this.app.viewer[name].show(isShown, show.hidden);
      if (isShown)
        this.app.viewer[name].set(curve.segments, show.width ? Array.from(curve[scale.quantity], scale.place) : null, curve.distance);
    }
    this.updateSurface();
  }

  // What is drawn on the surface itself.
  updateSurface() {
    const { show, look } = this.app.state;
    const { curve } = this.app;
    const hasDisk = show.disk && curve && Number.isFinite(curve.numbers[5]) && curve.numbers[0] > 0;
    this.app.viewer.setUniforms({
      showIsolines: show.isolines,
      coloring: this.hasColors(look.color) ? look.color : 'plain',
      showDisk: Boolean(hasDisk),
      showChecker: show.checker && Boolean(this.app.atlas),
      radius: hasDisk ? curve.numbers[5] : 0,
      spacing: this.app.source ? this.app.source.farthestDistance / 25 : 1,
      largest: this.app.source ? this.app.source.farthestDistance || 1 : 1,
    });
    this.app.viewer.arrows.visible = show.gradient && Boolean(this.gradient);
    const nearest = hasDisk ? this.app.toView(curve.numbers.subarray(6, 9)) : null;
    this.app.viewer.setMarker(this.app.viewer.nearestMarker, nearest);
    this.hasDisk = Boolean(hasDisk);
  }

  // whether there is what they show
  hasColors(name) {
    if (name === 'laplacian') return Boolean(this.laplacian);
    return name !== 'cells' || Boolean(this.app.source && this.app.source.total > 1);
  }

  // The Laplacian and the gradient are computed when they are first shown for a source.
  async showFields() {
    const { show, look } = this.app.state;
    if (!this.app.isSolved) return;
    if (look.color === 'laplacian' && !this.laplacian) {
      this.laplacian = await this.app.engine.run('laplacian');
      const sorted = Float32Array.from(this.laplacian, Math.abs).sort();
      this.laplacianScale = 2 * sorted[Math.floor(0.9 * sorted.length)] || 1;
      this.app.viewer.setUniforms({ laplacianScale: this.laplacianScale });
      this.app.viewer.setLaplacian(this.laplacian);
    }
    if (show.gradient && !this.gradient) {
      this.gradient = await this.app.engine.run('gradient');
      this.app.viewer.setArrows(this.gradient, 0.035);
    }
    await this.app.cellColors.show();
    this.updateSurface();
  }

  look(name) {
    const { curve, source, viewer } = this.app;
    if (!this.app.mesh || !source) return;
    viewer.look(name, curve ? curve.segments : new Float32Array(0), source.points.map((p) => this.app.toView(p)), source.borderLoops === 0);
  }

  fit() {
    this.app.viewer.fit();
  }
}
