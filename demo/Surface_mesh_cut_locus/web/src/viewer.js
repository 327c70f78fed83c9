// The model, and beside it the atlas when the surface is cut open. Frames are drawn when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { CurveLines } from './curve_lines.js';
import { SurfaceLayer } from './surface_layer.js';
import { makeSurfaceMaterial } from './surface_material.js';

const background = 0xf6f7f8;
const viewAngle = 35; // degrees

function makeMarker(color) {
  const marker = new THREE.Mesh(new THREE.SphereGeometry(1, 24, 16), new THREE.MeshBasicMaterial({ color }));
  marker.visible = false;
  return marker;
}

export class Viewer {
  constructor(canvas, { onPick, onChange }) {
    this.canvas = canvas;
    this.onPick = onPick;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.autoClear = false;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    THREE.ColorManagement.enabled = false;

    // surfaces, and what is drawn above them
    this.layer = new SurfaceLayer(this.renderer);
    this.surfaceScene = new THREE.Scene();
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(viewAngle, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = 0.2;
    this.controls.maxDistance = 30;
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('end', () => onChange());

    this.surface = new THREE.Mesh(new THREE.BufferGeometry(), makeSurfaceMaterial());
    this.pickable = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    this.edgeCurve = new CurveLines(0x2355a0, 2.5, 1);
    this.faceCurve = new CurveLines(0xd0202c, 3.5, 2);
    this.seams = new CurveLines(0x111111, 2, 3);
    this.arrows = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x3a6b35 }));
    this.arrows.visible = false;
    this.sourceMarker = makeMarker(0x1450d2);
    this.farthestMarker = makeMarker(0xf08c14);
    this.nearestMarker = makeMarker(0x0b6b20);
    this.surfaceScene.add(this.surface);
    this.scene.add(this.edgeCurve.hiddenObject, this.faceCurve.hiddenObject);
    this.scene.add(this.edgeCurve.object, this.faceCurve.object, this.seams.object, this.arrows,
      this.sourceMarker, this.farthestMarker, this.nearestMarker);

    this.atlasSurfaceScene = new THREE.Scene();
    this.atlasScene = new THREE.Scene();
    this.atlasCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10);
    this.atlas = new THREE.Mesh(this.surface.geometry, makeSurfaceMaterial(true));
    this.atlas.frustumCulled = false;
    this.atlasSeams = new CurveLines(0x111111, 2, 1);
    this.atlasSurfaceScene.add(this.atlas);
    this.atlasScene.add(this.atlasSeams.object);
    this.hasAtlas = false;

    this.isDirty = false;
    this.watchPointer();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
    this.resetView();
  }

  // A new frame is needed. Only `draw` alone keeps the picture of the surface.
  invalidate() {
    this.layer.isValid = false;
    this.invalidateCurves();
  }

  invalidateCurves() {
    if (this.isDirty) return;
    this.isDirty = true;
    requestAnimationFrame(() => this.render());
  }

  render() {
    this.isDirty = false;
    this.draw();
  }

  draw() {
    const { width, height } = this.size;
    const modelWidth = this.hasAtlas ? Math.floor(width / 2) : width;
    const drawBoth = (model, atlas, isCleared) => {
      this.drawInto(model, this.camera, 0, modelWidth, height, isCleared);
      if (this.hasAtlas) this.drawInto(atlas, this.atlasCamera, modelWidth, width - modelWidth, height, isCleared);
    };
    this.layer.draw(() => drawBoth(this.surfaceScene, this.atlasSurfaceScene, true), this.size);
    drawBoth(this.scene, this.atlasScene, false);
  }

  drawInto(scene, camera, left, width, height, isCleared) {
    if (camera.isPerspectiveCamera) {
      this.setAspect(width / height);
    } else {
      const half = 1.06 * Math.max(1, width / height);
      Object.assign(camera, { left: -half, right: half, top: half * height / width, bottom: -half * height / width });
      if (camera.top < 1.06) {
        const k = 1.06 / camera.top;
        Object.assign(camera, { left: -half * k, right: half * k, top: 1.06, bottom: -1.06 });
      }
      camera.updateProjectionMatrix();
    }
    this.setMarkerSizes();
    for (const lines of [this.edgeCurve, this.faceCurve, this.seams, this.atlasSeams]) lines.setResolution(width, height);
    // a render target counts in its own pixels
    const target = this.renderer.getRenderTarget();
    const ratio = target ? this.renderer.getPixelRatio() : 1;
    const box = [left, 0, width, height].map((x) => Math.round(x * ratio));
    if (target) {
      target.viewport.set(...box);
      target.scissor.set(...box);
      target.scissorTest = true;
      this.renderer.setRenderTarget(target);
    } else {
      this.renderer.setViewport(...box);
      this.renderer.setScissor(...box);
      this.renderer.setScissorTest(true);
    }
    if (isCleared) {
      this.renderer.setClearColor(background);
      this.renderer.clear();
    }
    this.renderer.render(scene, camera);
  }

  // The view has the same angle along the shorter side of the window, whichever that is.
  setAspect(aspect) {
    const half = Math.tan(THREE.MathUtils.degToRad(viewAngle / 2)) / Math.min(aspect, 1);
    this.camera.fov = 2 * THREE.MathUtils.radToDeg(Math.atan(half));
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  setMarkerSizes() {
    for (const marker of [this.sourceMarker, this.farthestMarker, this.nearestMarker]) {
      const distance = marker.position.distanceTo(this.camera.position);
      marker.scale.setScalar(0.012 * distance * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)));
    }
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.size = { width: Math.max(clientWidth, 1), height: Math.max(clientHeight, 1) };
    this.renderer.setSize(this.size.width, this.size.height, false);
    const ratio = this.renderer.getPixelRatio();
    this.layer.setSize(Math.floor(ratio * this.size.width), Math.floor(ratio * this.size.height));
    // the canvas has been cleared: there must not be a frame without a picture
    this.draw();
  }

  resetView() {
    this.camera.position.set(1.6, -2.6, 2.2);
    this.camera.up.set(0, 0, 1);
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.invalidate();
  }

  getView() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  setView(view) {
    this.camera.position.fromArray(view, 0);
    this.controls.target.fromArray(view, 3);
    this.controls.update();
    this.invalidate();
  }

  // turns the model by an angle about the vertical and the horizontal axis
  orbit(horizontal, vertical) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const spherical = new THREE.Spherical().setFromVector3(new THREE.Vector3(offset.x, offset.z, -offset.y));
    spherical.theta += horizontal;
    spherical.phi += vertical;
    spherical.makeSafe();
    const turned = new THREE.Vector3().setFromSpherical(spherical);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(turned.x, -turned.z, turned.y));
    this.controls.update();
    this.invalidate();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.invalidate();
  }

  setMesh(positions, triangles) {
    this.positions = positions;
    this.triangles = triangles;
    const index = new THREE.BufferAttribute(triangles, 1);
    const geometry = this.pickable.geometry;
    geometry.dispose();
    this.pickable.geometry = new THREE.BufferGeometry();
    this.pickable.geometry.setIndex(index);
    this.pickable.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    this.pickable.geometry.computeVertexNormals();
    this.pickable.geometry.computeBoundingSphere();
    this.distance = null;
    this.laplacian = null;
    this.showUncut();
    for (const marker of [this.sourceMarker, this.farthestMarker, this.nearestMarker]) marker.visible = false;
    for (const curve of [this.edgeCurve, this.faceCurve]) curve.set(new Float32Array(0));
    this.arrows.visible = false;
    this.invalidate();
  }

  setSurfaceGeometry(geometry) {
    this.surface.geometry.dispose();
    this.surface.geometry = geometry;
    this.atlas.geometry = geometry;
    this.setDistance(this.distance);
    this.setLaplacian(this.laplacian);
  }

  // The surface as it is, each vertex once.
  showUncut() {
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(this.pickable.geometry.index);
    geometry.setAttribute('position', this.pickable.geometry.getAttribute('position'));
    geometry.setAttribute('normal', this.pickable.geometry.getAttribute('normal'));
    geometry.boundingSphere = this.pickable.geometry.boundingSphere;
    this.origin = null;
    this.hasAtlas = false;
    this.setSurfaceGeometry(geometry);
    this.seams.set(new Float32Array(0));
    this.invalidate();
  }

  // The surface cut open: vertex i is a copy of origin[i] and has the texture coordinates uv[2 i], uv[2 i + 1].
  showCut({ origin, triangles, uv, seams, atlasSeams }) {
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    for (const name of ['position', 'normal']) {
      const from = this.pickable.geometry.getAttribute(name).array;
      const copy = new Float32Array(3 * origin.length);
      for (let i = 0; i < origin.length; ++i)
        for (let k = 0; k < 3; ++k) copy[3 * i + k] = from[3 * origin[i] + k];
      geometry.setAttribute(name, new THREE.BufferAttribute(copy, 3));
    }
    geometry.setAttribute('uv', new THREE.BufferAttribute(uv, 2));
    geometry.boundingSphere = this.pickable.geometry.boundingSphere;
    this.origin = origin;
    this.hasAtlas = true;
    this.setSurfaceGeometry(geometry);
    this.seams.set(seams);
    this.atlasSeams.set(atlasSeams);
    this.invalidate();
  }

  setDistance(values) {
    this.distance = values;
    this.setAttribute('geodesicDistance', values);
  }

  setLaplacian(values) {
    this.laplacian = values;
    this.setAttribute('distanceLaplacian', values);
  }

  // values at the vertices of the mesh, or null
  setAttribute(name, values) {
    const geometry = this.surface.geometry;
    const size = geometry.getAttribute('position').count;
    const attribute = new Float32Array(size);
    for (let i = 0; i < size; ++i) {
      const value = values ? values[this.origin ? this.origin[i] : i] : -1;
      attribute[i] = Number.isFinite(value) ? value : -1;
    }
    geometry.setAttribute(name, new THREE.BufferAttribute(attribute, 1));
    this.invalidate();
  }

  setUniforms(values) {
    for (const material of [this.surface.material, this.atlas.material])
      for (const [name, value] of Object.entries(values)) {
        if (material.uniforms[name].value === value) continue;
        material.uniforms[name].value = value;
        this.invalidate();
      }
  }

  setMarker(marker, point) {
    marker.visible = point !== null;
    if (point) marker.position.fromArray(point);
    this.invalidateCurves();
  }

  // Arrows at some of the vertices, evenly taken, along vectors of length 1 where the distance is smooth.
  setArrows(gradient, length) {
    const count = this.positions.length / 3;
    const step = Math.max(1, Math.ceil(count / 6000));
    const lines = [];
    const normal = this.pickable.geometry.getAttribute('normal').array;
    for (let v = 0; v < count; v += step) {
      const at = [0, 1, 2].map((k) => this.positions[3 * v + k] + 0.15 * length * normal[3 * v + k]);
      const along = [0, 1, 2].map((k) => length * gradient[3 * v + k]);
      const across = [0, 1, 2].map((k) => {
        const i = (k + 1) % 3, j = (k + 2) % 3;
        return normal[3 * v + i] * along[j] - normal[3 * v + j] * along[i];
      });
      const tip = at.map((x, k) => x + along[k]);
      lines.push(...at, ...tip);
      for (const side of [-1, 1])
        lines.push(...tip, ...tip.map((x, k) => x - 0.3 * along[k] + side * 0.15 * across[k]));
    }
    this.arrows.geometry.dispose();
    this.arrows.geometry = new THREE.BufferGeometry();
    this.arrows.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(lines), 3));
    this.invalidate();
  }

  // A click is a press and a release at about the same place.
  watchPointer() {
    let down = null;
    this.canvas.addEventListener('pointerdown', (event) => {
      down = event.button === 0 ? [event.clientX, event.clientY] : null;
    });
    this.canvas.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const box = this.canvas.getBoundingClientRect();
      this.pick(event.clientX - box.left, event.clientY - box.top);
    });
  }

  // The face and the barycentric coordinates of the point of the surface seen at pixel x, y.
  pick(x, y) {
    const width = this.hasAtlas ? Math.floor(this.size.width / 2) : this.size.width;
    if (!this.positions || x >= width) return;
    const pointer = new THREE.Vector2(2 * x / width - 1, 1 - 2 * y / this.size.height);
    this.setAspect(width / this.size.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(pointer, this.camera);
    const [hit] = ray.intersectObject(this.pickable);
    if (!hit) return;
    const corners = [0, 1, 2].map((k) =>
      new THREE.Vector3().fromArray(this.positions, 3 * this.triangles[3 * hit.faceIndex + k]));
    const c = new THREE.Vector3();
    new THREE.Triangle(...corners).getBarycoord(hit.point, c);
    const clamped = c.toArray().map((b) => Math.max(b, 0));
    const sum = clamped[0] + clamped[1] + clamped[2];
    if (!(sum > 0)) return;
    this.onPick({ face: hit.faceIndex, coordinates: clamped.map((b) => b / sum) });
  }

  pickCenter() {
    this.pick((this.hasAtlas ? this.size.width / 4 : this.size.width / 2), this.size.height / 2);
  }

  // The picture as it is on the screen.
  toPng() {
    this.draw();
    return new Promise((resolve) => { this.canvas.toBlob(resolve, 'image/png'); });
  }
}
