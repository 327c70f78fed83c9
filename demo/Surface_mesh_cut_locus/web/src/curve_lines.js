// Wide lines for the cut locus, in one color or by a number of the branches, with a seam of another color that sets
// them off the surface. What the surface hides is drawn in a pale color, the stronger the more transparent the
// surface is.
import * as THREE from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { branchColor } from './color_maps.js';
import { lineGeometry, refill, setShown } from './line_geometry.js';

// the order sets how far in front of the surface it is, and what covers what
function lines(geometry, order, options) {
  const material = new LineMaterial({
    polygonOffset: true,
    polygonOffsetFactor: -order,
    polygonOffsetUnits: -4 * order,
    ...options,
  });
  const object = new THREE.Mesh(geometry, material);
  object.frustumCulled = false;
  object.renderOrder = order;
  return object;
}

// the color of each segment at both of its ends
function colorsAt(places) {
  const result = new Float32Array(6 * places.length);
  for (let i = 0; i < places.length; ++i) {
    result.set(branchColor(places[i]), 6 * i);
    result.copyWithin(6 * i + 3, 6 * i, 6 * i + 3);
  }
  return result;
}

// how many of sorted numbers are not above a value
function countUpTo(sorted, value) {
  let low = 0, high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class CurveLines {
  constructor(baseWidth, order, { hasCasing = true, isReused = false } = {}) {
    this.isReused = isReused; // its buffers are: it changes all the time
    this.isInstanced = false;
    this.baseWidth = baseWidth;
    const geometry = new THREE.BufferGeometry();
    this.visibleLines = lines(geometry, order, {});
    // below all of the curve
    this.casing = lines(geometry, order - 0.5, { depthWrite: false });
    // With the same offset, exactly what the surface hides. It is opaque: the ends of segments cover each other.
    this.hiddenLines = lines(geometry, order, { depthFunc: THREE.GreaterDepth, depthWrite: false });
    this.hiddenLines.renderOrder = -2;
    this.objects = [this.hiddenLines, this.casing, this.visibleLines];
    this.setWidth(1);
    this.hasCasing = hasCasing;
    this.color = new THREE.Color();
    this.isEmpty = true;
    this.given = { segments: new Float32Array(0), places: null, distances: null };
    this.reach = null; // of a wave: all is shown
    this.visible = true;
    this.showsHidden = false;
    this.isPlain = false;
  }

  // `places`, if given, are those of the segments on the scale of colors, in [0, 1]; `distances` are theirs to the source.
  set(segments, places = null, distances = null) {
    this.given = { segments, places, distances };
    this.isSorted = false;
    this.fill(segments, places);
    if (this.reach !== null) this.showUpTo(this.reach);
  }

  fill(segments, places) {
    this.isEmpty = segments.length === 0;
    const hasEnds = !(this.isReused && this.isPlain);
    if (this.isReused && this.hasEnds === hasEnds && refill(this.visibleLines.geometry, segments)) {
      this.show(this.visible, this.showsHidden);
      return;
    }
    this.visibleLines.geometry.dispose();
    this.hasEnds = hasEnds;
    const geometry = lineGeometry(segments, places && colorsAt(places), { isInstanced: this.isInstanced, hasRoom: this.isReused, hasEnds });
    const hasColors = Boolean(places);
    const { material } = this.visibleLines;
    if (material.vertexColors !== hasColors) {
      material.vertexColors = hasColors;
      material.needsUpdate = true;
    }
    material.color.set(hasColors ? 0xffffff : this.color);
    for (const object of this.objects) object.geometry = geometry;
    this.show(this.visible, this.showsHidden);
  }

  // Only what is as near to the source, or all of it, if that is null.
  showUpTo(reach) {
    this.reach = reach;
    const { distances } = this.given;
    if (!distances) return;
    if (reach !== null && !this.isSorted) this.sort();
    const shown = reach === null ? distances.length : countUpTo(this.sorted, reach);
    setShown(this.visibleLines.geometry, shown);
  }

  // by their distances: what has been reached comes first
  sort() {
    const { segments, places, distances } = this.given;
    const order = Uint32Array.from(distances, (_, i) => i).sort((i, j) => distances[i] - distances[j]);
    const sorted = new Float32Array(segments.length);
    order.forEach((i, at) => sorted.set(segments.subarray(6 * i, 6 * i + 6), 6 * at));
    this.sorted = Float32Array.from(order, (i) => distances[i]);
    this.isSorted = true;
    this.fill(sorted, places && Array.from(order, (i) => places[i]));
  }

  setColors(color, hidden, casing) {
    this.color.set(color);
    this.hiddenColor = new THREE.Color(hidden);
    if (!this.visibleLines.material.vertexColors) this.visibleLines.material.color.copy(this.color);
    this.casing.material.color.set(casing);
    this.setTransparency(this.transparency || 0);
  }

  // As a graphics card draws it best, or as a processor does.
  setInstanced(isInstanced) {
    if (this.isInstanced === isInstanced) return;
    this.isInstanced = isInstanced;
    this.hasEnds = null; // no buffer is reused
    const { segments, places, distances } = this.given;
    this.set(segments, places, distances);
  }

  // times what it is at first
  setWidth(factor) {
    const width = factor * this.baseWidth;
    this.visibleLines.material.linewidth = width;
    this.casing.material.linewidth = width + 2.2;
    this.hiddenLines.material.linewidth = 0.75 * width;
  }

  get materials() {
    return this.objects.map(({ material }) => material);
  }

  get hiddenStyle() {
    return this.hiddenColor.getStyle();
  }

  setTransparency(transparency) {
    this.transparency = transparency;
    this.hiddenLines.material.color.copy(this.hiddenColor).lerp(this.color, 0.8 * transparency);
  }

  show(visible, showsHidden = false) {
    this.visible = visible;
    this.showsHidden = showsHidden;
    this.visibleLines.visible = visible && !this.isEmpty;
    this.casing.visible = this.visibleLines.visible && this.hasCasing && !this.isPlain;
    this.hiddenLines.visible = showsHidden && this.visibleLines.visible;
  }

  // Without a seam, which takes as long to draw as the curve. One that changes all the time goes without round ends, too.
  setPlain(isPlain) {
    this.isPlain = isPlain;
    this.show(this.visible, this.showsHidden);
  }

  setResolution(width, height) {
    for (const object of this.objects) object.material.resolution.set(width, height);
  }
}
