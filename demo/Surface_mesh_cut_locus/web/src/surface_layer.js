// Keeps the picture of the surface, with its depths, so that a frame in which only curves change does not draw the
// surface again: with many faces, or without a graphics card, that is what takes the time.
import * as THREE from 'three';
import { GTAOPass } from 'three/examples/jsm/postprocessing/GTAOPass.js';

const copyVertexShader = `
varying vec2 vPlace;

void main() {
  vPlace = uv;
  gl_Position = vec4(position.xy, 0., 1.);
}`;

const copyFragmentShader = `
varying vec2 vPlace;
uniform sampler2D colors;
uniform sampler2D depths;
uniform sampler2D occlusion;
uniform float strength;

void main() {
  vec4 color = texture2D(colors, vPlace);
  float depth = texture2D(depths, vPlace).r;
  if(strength > 0. && depth < 1.)
    color.rgb *= mix(1., texture2D(occlusion, vPlace).r, strength);
  gl_FragColor = color;
  gl_FragDepth = depth;
}`;

const samples = 4;
const slowMilliseconds = 10; // a surface that takes longer is drawn coarsely while its values change all the time
const partOfTime = 1 / 4; // it does not take more of it

function makeTarget(count) {
  const target = new THREE.WebGLRenderTarget(1, 1, { samples: count });
  target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
  return target;
}

export class SurfaceLayer {
  constructor(renderer, scene, camera) {
    this.renderer = renderer;
    this.scene = scene;
    this.camera = camera;
    this.isValid = false;
    this.isStale = false; // only the values at the vertices are other ones
    this.target = makeTarget(samples);
    this.interval = 0; // milliseconds: stale pictures are drawn again after as many
    this.isCoarse = false;
    this.planes = []; // that clip the scene
    this.material = new THREE.ShaderMaterial({
      vertexShader: copyVertexShader,
      fragmentShader: copyFragmentShader,
      depthFunc: THREE.AlwaysDepth,
      blending: THREE.NoBlending,
      uniforms: {
        colors: { value: this.target.texture },
        depths: { value: this.target.depthTexture },
        occlusion: { value: null },
        strength: { value: 0 },
      },
    });
    this.screen = new THREE.Scene();
    const quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.material);
    quad.frustumCulled = false;
    this.screen.add(quad);
    this.screenCamera = new THREE.Camera();
    this.hasOcclusion = false; // for what is in the target
  }

  // in pixels of the device
  setSize(width, height) {
    if (this.target.width === width && this.target.height === height) return;
    this.target.setSize(width, height);
    if (this.pass) this.pass.setSize(Math.ceil(width / 2), Math.ceil(height / 2));
    this.isValid = false;
    this.hasOcclusion = false;
  }

  setCamera(camera) {
    this.camera = camera;
    this.renew();
  }

  setCoarse(isCoarse) {
    if (this.isCoarse === isCoarse) return;
    this.isCoarse = isCoarse;
    this.target.depthTexture.dispose();
    this.target.dispose();
    this.target = makeTarget(isCoarse ? 0 : samples);
    this.material.uniforms.colors.value = this.target.texture;
    this.material.uniforms.depths.value = this.target.depthTexture;
    this.isValid = false;
  }

  // Its pictures are gone, with the graphics card that had them.
  renew() {
    this.isValid = false;
    this.hasOcclusion = false;
    this.pass = null;
  }

  // What is drawn changes from now on until `settle()`. Where that takes long, as without a graphics card, it is drawn
  // coarsely, with one sample in each pixel, and, after `pace()`, less often than what is above it.
  hurry() {
    if (this.drawingTime() >= slowMilliseconds) this.setCoarse(true);
  }

  // by the time that it takes as it is drawn now: many faces take long with few pixels, too
  pace() {
    if (this.isCoarse) this.interval = this.drawingTime() / partOfTime;
  }

  settle() {
    this.setCoarse(false);
    this.interval = 0;
    this.isValid = false;
  }

  drawingTime() {
    const { renderer } = this;
    const gl = renderer.getContext();
    const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    wait();
    const start = performance.now();
    this.isValid = false;
    this.update(0);
    wait();
    return performance.now() - start;
  }

  // How much light reaches hollows; half of the pixels along each axis do, as it changes slowly.
  computeOcclusion() {
    if (!this.pass) {
      const width = Math.ceil(this.target.width / 2), height = Math.ceil(this.target.height / 2);
      this.pass = new GTAOPass(this.scene, this.camera, width, height);
      this.pass.updateGtaoMaterial({ radius: 0.22, distanceExponent: 1.4, thickness: 1.5, scale: 1.1, samples: 12 });
      this.pass.updatePdMaterial({ lumaPhi: 10, depthPhi: 2, normalPhi: 3, radius: 6, rings: 2, samples: 12 });
      this.pass.output = GTAOPass.OUTPUT.Off;
      this.pass.normalMaterial.side = THREE.DoubleSide; // surfaces with a border have two sides
    }
    this.pass.normalMaterial.clippingPlanes = this.planes;
    this.pass.render(this.renderer, null, null, 0, false); // into a target of its own
    this.material.uniforms.occlusion.value = this.pass.gtaoMap;
    this.hasOcclusion = true;
  }

  // whether the next frame draws other values at the vertices
  get isDue() {
    return performance.now() >= (this.drawnAt || 0) + this.interval;
  }

  // Draws what is not valid into the target.
  update(occlusionStrength) {
    const { renderer } = this;
    if (this.isStale && this.isDue) this.isValid = false;
    if (!this.isValid) {
      this.drawnAt = performance.now();
      this.isStale = false;
      renderer.setRenderTarget(this.target);
      renderer.clear();
      renderer.render(this.scene, this.camera);
      this.isValid = true;
    }
    if (occlusionStrength > 0 && !this.hasOcclusion) this.computeOcclusion();
    this.material.uniforms.strength.value = occlusionStrength;
    renderer.setRenderTarget(null);
  }

  // into the viewport of the renderer
  copy() {
    this.renderer.render(this.screen, this.screenCamera);
  }
}
