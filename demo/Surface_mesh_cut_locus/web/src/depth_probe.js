// Tells what the surface hides: its depths from a camera, read back as numbers.
import * as THREE from 'three';

const shader = {
  vertexShader: `
#include <clipping_planes_pars_vertex>
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.);
  gl_Position = projectionMatrix * mvPosition;
#include <clipping_planes_vertex>
}`,
  fragmentShader: `
#include <packing>
#include <clipping_planes_pars_fragment>
void main() {
#include <clipping_planes_fragment>
  gl_FragColor = packDepthToRGBA(gl_FragCoord.z);
}`,
};

export class DepthProbe {
  constructor(renderer) {
    this.renderer = renderer;
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.scene = new THREE.Scene();
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.ShaderMaterial(
      { ...shader, clipping: true, side: THREE.DoubleSide, blending: THREE.NoBlending }));
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  // `planes` clip it.
  look(geometry, camera, width, height, planes = []) {
    this.mesh.geometry = geometry;
    this.mesh.material.clippingPlanes = planes;
    this.target.setSize(width, height);
    camera.updateMatrixWorld();
    const color = this.renderer.getClearColor(new THREE.Color());
    const alpha = this.renderer.getClearAlpha();
    this.renderer.setRenderTarget(this.target);
    this.renderer.setClearColor(0xffffff, 1);
    this.renderer.clear();
    this.renderer.render(this.scene, camera);
    this.bytes = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, width, height, this.bytes);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(color, alpha);
    this.camera = camera;
  }

  // the distance to the camera along its axis, of a depth in [0, 1]
  viewDepth(depth) {
    const { near, far } = this.camera;
    return this.camera.isOrthographicCamera ? near + depth * (far - near) : near * far / (far - depth * (far - near));
  }

  // Whether the point, in space, is seen: not more than `slack` behind the surface at its pixel, or, for what may lie at the
  // rim, at one around it.
  sees(point, slack, mayBeAtRim = true) {
    const { width, height } = this.target;
    const view = point.clone().applyMatrix4(this.camera.matrixWorldInverse);
    const place = view.clone().applyMatrix4(this.camera.projectionMatrix);
    if (Math.abs(place.x) > 1 || Math.abs(place.y) > 1) return false;
    const x = Math.min(Math.floor((place.x + 1) / 2 * width), width - 1);
    const y = Math.min(Math.floor((place.y + 1) / 2 * height), height - 1);
    let farthest = 0;
    const around = mayBeAtRim ? [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]] : [];
    for (const [i, j] of [[x, y], ...around]) {
      if (i < 0 || j < 0 || i >= width || j >= height) continue;
      const b = this.bytes.subarray(4 * (j * width + i));
      // as three.js packs it
      const depth = b[0] === 255 && b[3] === 255 ? 1 : ((b[2] / 256 + b[1]) / 256 + b[0]) / 256;
      farthest = Math.max(farthest, this.viewDepth(depth));
    }
    return -view.z <= farthest + slack;
  }
}
