// Wide lines for the cut locus, in one colour or by a number of the branches. What the surface hides is
// drawn in a pale colour.
import * as THREE from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

// from low to high: yellow, orange, red, violet
const ramp = [[0.99, 0.83, 0.25], [0.96, 0.55, 0.15], [0.84, 0.19, 0.20], [0.45, 0.06, 0.40]];

const hiddenBackground = 0xd9dce0; // about the colour of the surface

export function rampColor(t, to, at) {
  const x = Math.min(Math.max(t, 0), 1) * (ramp.length - 1);
  const i = Math.min(Math.floor(x), ramp.length - 2);
  for (let k = 0; k < 3; ++k) to[at + k] = ramp[i][k] + (x - i) * (ramp[i + 1][k] - ramp[i][k]);
}

export class CurveLines {
  constructor(color, width, order) {
    this.color = new THREE.Color(color);
    this.material = new LineMaterial({
      color,
      linewidth: width,
      polygonOffset: true,
      polygonOffsetFactor: -order,
      polygonOffsetUnits: -4 * order,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    // With the same offset, exactly what the surface hides. It is opaque: the ends of segments cover each other.
    this.hiddenMaterial = new LineMaterial({
      color: this.color.clone().lerp(new THREE.Color(hiddenBackground), 0.7),
      linewidth: 0.7 * width,
      depthFunc: THREE.GreaterDepth,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -order,
      polygonOffsetUnits: -4 * order,
    });
    this.hiddenObject = new LineSegments2(this.object.geometry, this.hiddenMaterial);
    this.hiddenObject.frustumCulled = false;
    this.hiddenObject.renderOrder = -1;
    this.isEmpty = true;
    this.visible = true;
    this.showsHidden = false;
  }

  // `places`, if given, are those of the segments on the ramp of colours, in [0, 1].
  set(segments, places = null) {
    this.object.geometry.dispose();
    const geometry = new LineSegmentsGeometry();
    this.isEmpty = segments.length === 0;
    if (!this.isEmpty) {
      geometry.instanceCount = segments.length / 6;
      const positions = new THREE.InstancedInterleavedBuffer(segments, 6, 1);
      geometry.setAttribute('instanceStart', new THREE.InterleavedBufferAttribute(positions, 3, 0));
      geometry.setAttribute('instanceEnd', new THREE.InterleavedBufferAttribute(positions, 3, 3));
      if (places) {
        const colors = new Float32Array(segments.length);
        for (let i = 0; i < places.length; ++i) {
          rampColor(places[i], colors, 6 * i);
          colors.copyWithin(6 * i + 3, 6 * i, 6 * i + 3);
        }
        geometry.setColors(colors);
      }
    }
    const hasColors = Boolean(places);
    if (this.material.vertexColors !== hasColors) {
      this.material.vertexColors = hasColors;
      this.material.needsUpdate = true;
    }
    this.material.color.set(hasColors ? 0xffffff : this.color);
    this.object.geometry = geometry;
    this.hiddenObject.geometry = geometry;
    this.show(this.visible, this.showsHidden);
  }

  show(visible, showsHidden = false) {
    this.visible = visible;
    this.showsHidden = showsHidden;
    this.object.visible = visible && !this.isEmpty;
    this.hiddenObject.visible = showsHidden && this.object.visible;
  }

  setResolution(width, height) {
    this.material.resolution.set(width, height);
    this.hiddenMaterial.resolution.set(width, height);
  }
}
