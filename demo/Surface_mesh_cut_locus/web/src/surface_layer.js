// Keeps the picture of the surface, with its depths, so that a frame in which only curves change does not draw the
// surface again: with many faces, or without a graphics card, that is what takes the time.
import * as THREE from 'three';

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

void main() {
  gl_FragColor = texture2D(colors, vPlace);
  gl_FragDepth = texture2D(depths, vPlace).r;
}`;

export class SurfaceLayer {
  constructor(renderer) {
    this.renderer = renderer;
    this.isValid = false;
    this.target = new THREE.WebGLRenderTarget(1, 1, { samples: 4 });
    this.target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    this.material = new THREE.ShaderMaterial({
      vertexShader: copyVertexShader,
      fragmentShader: copyFragmentShader,
      depthFunc: THREE.AlwaysDepth,
      uniforms: { colors: { value: this.target.texture }, depths: { value: this.target.depthTexture } },
    });
    this.scene = new THREE.Scene();
    const screen = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.material);
    screen.frustumCulled = false;
    this.scene.add(screen);
    this.camera = new THREE.Camera();
  }

  setSize(width, height) {
    this.target.setSize(width, height);
    this.isValid = false;
  }

  // Calls `drawSurfaces` if the picture that is kept is not valid, and copies it to the screen.
  draw(drawSurfaces, { width, height }) {
    if (!this.isValid) {
      this.renderer.setRenderTarget(this.target);
      drawSurfaces();
      this.renderer.setRenderTarget(null);
      this.isValid = true;
    }
    this.renderer.setViewport(0, 0, width, height);
    this.renderer.setScissorTest(false);
    this.renderer.render(this.scene, this.camera);
  }
}
