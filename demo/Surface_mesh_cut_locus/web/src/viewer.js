// The picture: the model, and beside it the atlas when the surface is cut open. Frames are drawn when something has
// changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { ViewHelper } from 'three/examples/jsm/helpers/ViewHelper.js';
import { arrowsAlong } from './arrows.js';
import { valuesAt } from './atlas.js';
import { Clipping } from './clipping.js';
import { CurveLines } from './curve_lines.js';
import { DepthProbe } from './depth_probe.js';
import { hasCard } from './line_geometry.js';
import { makeMarker, setMarkerColors, setNumber, sizeMarker } from './markers.js';
import { acceleratedRaycast, MeshBVH } from 'three-mesh-bvh';
import { freeCorner } from './free_area.js';
import { Placement, viewAngle } from './placement.js';
import { Pointer } from './pointer.js';
import { Surface } from './surface.js';
import { SurfaceLayer } from './surface_layer.js';
import { bestDirection, direction, isSide, sideDirection, upVector } from './views.js';

const restMilliseconds = 140; // the shadows of hollows wait until the view rests
const previewFading = 0.4; // into the background
const coarseness = 1 / 2; // of the pixels along each axis, where drawing takes long, while a source moves
const modelRadius = 1.02; // the mesh fills the unit ball

function setSides(camera, half, aspect) {
  Object.assign(camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
}

export class Viewer {
  constructor(canvas, views, { onPick, onHover, onFollow, onLost, overlays = [] }) {
    this.canvas = canvas;
    this.onMove = () => {}; // what is told when the model's camera has moved
    this.placement = new Placement(this, overlays);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.pixelRatio = Math.min(window.devicePixelRatio, 2);
    this.renderer.setPixelRatio(this.pixelRatio);
    this.renderer.autoClear = false;
    this.renderer.localClippingEnabled = true;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    THREE.ColorManagement.enabled = false;
    this.probe = new DepthProbe(this.renderer);
    this.up = 'z';
    this.occlusionStrength = 0;
    this.hasAxes = true;
    this.hasAtlas = false;
    this.isDirty = false;
    this.afterDraw = new Set(); // what lies above the picture, and moves with it

    this.cameras = { perspective: new THREE.PerspectiveCamera(viewAngle, 1, 0.01, 100), orthographic: new THREE.OrthographicCamera() };
    this.model = this.makePane(views.model, this.cameras.perspective);
    this.plane = this.makePane(views.atlas, new THREE.OrthographicCamera(-1, 1, 1, -1, -10, 10));
    this.plane.controls.enableRotate = false;
    this.plane.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
    this.plane.controls.touches.ONE = THREE.TOUCH.PAN;
    this.camera = this.model.camera;
    this.clipping = this.model.clipping;
    this.axesCamera = new THREE.OrthographicCamera(-1.6, 1.6, 1.6, -1.6, 0, 4);
    this.axesCamera.position.set(0, 0, 2);

    this.surface = new Surface();
    this.pickable = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    this.flatPickable = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    this.pickable.raycast = acceleratedRaycast;
    this.flatPickable.raycast = acceleratedRaycast;
    this.wireframe = new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ transparent: true, opacity: 0.25 }));
    this.wireframe.visible = false;
    this.wireframe.renderOrder = 3;
    this.model.surfaces.add(this.surface.object, this.wireframe);

    this.edgeCurve = new CurveLines(2, 2, { hasCasing: false });
    this.faceCurve = new CurveLines(3.5, 4);
    this.seams = new CurveLines(1.4, 1, { hasCasing: false });
    this.paths = new CurveLines(3, 6);
    this.sourceLines = new CurveLines(4.5, 5);
    this.previewCurve = new CurveLines(3, 4, { hasCasing: false, isReused: true });
    this.curves = [this.edgeCurve, this.faceCurve, this.previewCurve, this.seams, this.paths, this.sourceLines];
    this.arrows = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial());
    this.arrows.visible = false;
    this.sourceMarkers = [];
    this.farthestMarker = makeMarker();
    this.nearestMarker = makeMarker();
    this.endMarker = makeMarker(); // of the shortest paths
    for (const curve of this.curves) this.model.lines.add(...curve.objects);
    this.markers = new THREE.Group();
    this.markers.add(this.farthestMarker, this.nearestMarker, this.endMarker);
    this.model.lines.add(this.arrows, this.markers);

    this.atlas = new Surface(true);
    this.atlasSeams = new CurveLines(1.6, 1, { hasCasing: false });
    this.plane.surfaces.add(this.atlas.object);
    this.sheetMarkers = new THREE.Group(); // the sources, where they are on their sheets
    this.plane.lines.add(...this.atlasSeams.objects, this.sheetMarkers);

    this.setInstanced(hasCard(this.renderer.getContext()));
    this.makeControls();
    this.pointer = new Pointer(this, { onPick, onHover, onFollow });
    this.watchContext(onLost);
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.resetView();
  }

  // The graphics card may be taken away, as by another program or when a notebook sleeps. When it comes back, three.js has
  // everything that it draws sent there again; pictures that were kept are gone.
  watchContext(onLost) {
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // it may come back
      onLost(true);
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      for (const pane of [this.model, this.plane]) pane.layer.renew();
      this.invalidate();
      onLost(false);
    });
  }

  makePane(element, camera) {
    const surfaces = new THREE.Scene(), lines = new THREE.Scene();
    const pane = { element, camera, surfaces, lines, shift: [0, 0], part: 1, clipping: new Clipping(), layer: new SurfaceLayer(this.renderer, surfaces, camera) };
    if (camera.isOrthographicCamera) {
      camera.position.set(0, 0, 5);
      pane.controls = this.listen(new OrbitControls(camera, element), pane);
    }
    return pane;
  }

  listen(controls, pane) {
    controls.zoomToCursor = true;
    controls.enableDamping = false;
    controls.addEventListener('change', () => {
      if (pane === this.model) this.takeZoom();
      this.moved(pane);
    });
    return controls;
  }

  // They take the axis that is up when they are made.
  makeControls() {
    const target = this.controls ? this.controls.target.clone() : new THREE.Vector3();
    if (this.controls) this.controls.dispose();
    this.camera.up.copy(upVector(this.up));
    this.controls = this.listen(new OrbitControls(this.camera, this.model.element), this.model);
    this.controls.target.copy(target);
    this.controls.minDistance = 0.05;
    this.controls.maxDistance = 30;
    this.model.controls = this.controls;
    this.helper = new ViewHelper(this.camera, this.model.element);
    this.helper.setLabels('x', 'y', 'z');
  }

  // What a camera without perspective sees is as large as how far it is away from what is looked at: there is no other zoom.
  takeZoom() {
    const { camera } = this;
    if (camera.zoom === 1) return;
    const { target } = this.controls;
    camera.position.sub(target).divideScalar(camera.zoom).add(target);
    camera.zoom = 1;
  }

  // `perspective` or `orthographic`
  setProjection(name) {
    const camera = this.cameras[name];
    if (camera === this.camera) return;
    camera.position.copy(this.camera.position);
    this.camera = camera;
    this.model.camera = camera;
    this.model.layer.setCamera(camera);
    this.makeControls();
    this.controls.update();
    this.invalidate();
  }

  // as `Clipping.set()`
  setClip(name, share) {
    const { geometry } = this.pickable;
    const isOther = this.clipping.set(name, share, geometry.boundingBox || new THREE.Box3());
    const { planes } = this.clipping;
    const materials = [...this.surface.materials, this.wireframe.material, this.arrows.material,
      ...this.curves.flatMap((curve) => curve.materials)];
    if (isOther) for (const material of materials) material.clippingPlanes = planes;
    this.model.layer.planes = planes;
    this.model.layer.hasOcclusion = false;
    this.invalidate();
  }

  // how lines are drawn
  setInstanced(isInstanced) {
    for (const curve of [...this.curves, this.atlasSeams]) curve.setInstanced(isInstanced);
    this.invalidateCurves();
  }

  setLineWidth(factor) {
    for (const curve of [...this.curves, this.atlasSeams]) curve.setWidth(factor);
    this.invalidateCurves();
  }

  // the scale of colors of distances
  setMap(name) {
    const changes = [this.surface, this.atlas].map((surface) => surface.setMap(name));
    if (changes.some(Boolean)) this.invalidateValues();
  }

  setUp(up) {
    if (up === this.up) return;
    this.up = up;
    this.makeControls();
  }

  setTheme(colors) {
    this.colors = colors;
    const wave = new THREE.Vector3(...new THREE.Color(colors.source).toArray());
    for (const surface of [this.surface, this.atlas]) surface.setUniforms({ plain: new THREE.Vector3(...colors.surface), wave });
    this.faceCurve.setColors(colors.curve, colors.hidden, colors.casing);
    this.previewCurve.setColors(new THREE.Color(colors.curve).lerp(new THREE.Color(colors.back), previewFading), colors.hidden, colors.casing);
    this.edgeCurve.setColors(colors.edges, new THREE.Color(colors.edges).lerp(new THREE.Color(colors.back), 0.6), colors.casing);
    this.seams.setColors(colors.edges, colors.back, colors.casing);
    this.paths.setColors(colors.path, new THREE.Color(colors.path).lerp(new THREE.Color(colors.back), 0.5), colors.casing);
    this.sourceLines.setColors(colors.source, new THREE.Color(colors.source).lerp(new THREE.Color(colors.back), 0.5), colors.casing);
    this.atlasSeams.setColors(colors.curve, colors.back, colors.casing);
    this.arrows.material.color.set(colors.arrows);
    this.wireframe.material.color.set(colors.isDark ? 0x000000 : 0x20262e);
    for (const marker of [...this.sourceMarkers, ...this.sheetMarkers.children]) setMarkerColors(marker, colors.source, colors.casing);
    setMarkerColors(this.farthestMarker, colors.casing, colors.text);
    setMarkerColors(this.nearestMarker, colors.nearest, colors.casing);
    setMarkerColors(this.endMarker, colors.path, colors.casing);
    this.invalidate();
  }

  // The camera of a pane has moved.
  moved(pane) {
    pane.layer.isValid = false;
    pane.layer.hasOcclusion = false;
    this.lastMove = performance.now();
    this.invalidateCurves();
    if (pane === this.model) this.onMove();
  }

  // A new frame is needed. Only `invalidateCurves` keeps the picture of the surface.
  invalidate() {
    for (const pane of [this.model, this.plane]) pane.layer.isValid = false;
    this.invalidateCurves();
  }

  // Other values at the vertices.
  invalidateValues() {
    for (const pane of [this.model, this.plane]) pane.layer.isStale = true;
    this.invalidateCurves();
  }

  // Until it ends, the values change all the time: frames take as little time as they can, if they take long.
  setMoving(isMoving) {
    const layers = (this.hasAtlas ? [this.model, this.plane] : [this.model]).map(({ layer }) => layer);
    for (const layer of layers)
      if (isMoving) layer.hurry();
      else layer.settle();
    const { isCoarse } = this.model.layer;
    for (const curve of this.curves) curve.setPlain(isCoarse);
    this.setPixelRatio(isCoarse ? coarseness * this.pixelRatio : this.pixelRatio);
    for (const layer of layers) layer.pace();
    this.invalidateCurves();
  }

  setPixelRatio(ratio) {
    if (this.renderer.getPixelRatio() === ratio) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.size.width, this.size.height, false);
    this.draw(); // as in `resize()`
  }

  invalidateCurves() {
    if (this.isDirty) return;
    this.isDirty = true;
    requestAnimationFrame(() => this.render());
  }

  render() {
    this.isDirty = false;
    const rest = restMilliseconds - (performance.now() - (this.lastMove || 0));
    this.draw(rest <= 0);
    clearTimeout(this.restTimer);
    if (rest > 0 && this.occlusionStrength > 0) this.restTimer = setTimeout(() => this.invalidateCurves(), rest + 5);
  }

  // `isTransparent`: without a background, for pictures.
  draw(isAtRest = true, { isTransparent = false, hasAxes = this.hasAxes, overlays = null } = {}) {
    const { renderer } = this;
    renderer.setClearColor(isTransparent ? 0x000000 : this.colors ? this.colors.back : 0xffffff, isTransparent ? 0 : 1);
    renderer.setScissorTest(false);
    renderer.setRenderTarget(null);
    renderer.setViewport(0, 0, this.size.width, this.size.height);
    renderer.clear();
    this.drawPane(this.model, isAtRest || this.model.layer.hasOcclusion ? this.occlusionStrength : 0);
    if (this.hasAtlas) this.drawPane(this.plane, 0);
    if (hasAxes) {
      renderer.setViewport(0, 0, this.size.width, this.size.height);
      this.drawAxes(overlays || this.placement.overlaysOf(this.model));
    }
    for (const action of this.afterDraw) action();
  }

  // where a point of the model's space is seen, from the upper left corner of the canvas
  pixelAt(place) {
    const { left, bottom, width, height } = this.boxOf(this.model);
    this.setAspect(this.model, width / height);
    this.camera.updateMatrixWorld();
    const seen = new THREE.Vector3(...place).project(this.camera);
    return [left + (seen.x + 1) / 2 * width, this.size.height - bottom - height + (1 - seen.y) / 2 * height];
  }

  // How far a wave from the sources has come, or null: what it has not reached is plain, and has no curve.
  setFront(front) {
    this.setUniforms({ front: front ?? -1 });
    for (const curve of [this.faceCurve, this.edgeCurve]) curve.showUpTo(front);
    this.invalidateCurves();
  }

  // In the first corner of the model's part, from the lower right one, that nothing covers; if all are covered, nowhere.
  drawAxes(overlays) {
    const box = this.boxOf(this.model);
    const side = Math.min(92, box.width / 4, box.height / 5);
    const corner = freeCorner(box, side, overlays);
    if (!corner) return;
    const { renderer } = this;
    this.helper.quaternion.copy(this.camera.quaternion).invert();
    this.helper.updateMatrixWorld();
    renderer.clearDepth();
    renderer.setViewport(box.left + corner[0], box.bottom + box.height - corner[1] - side, side, side);
    renderer.render(this.helper, this.axesCamera);
  }

  // of a pane within the canvas, from its lower left corner, in pixels of the page
  boxOf(pane) {
    const { width, height } = this.size;
    if (!this.hasAtlas) return { left: 0, bottom: 0, width, height };
    const isModel = pane === this.model;
    if (this.isStacked) {
      const half = Math.floor(height / 2);
      return { left: 0, bottom: isModel ? height - half : 0, width, height: isModel ? half : height - half };
    }
    const half = Math.floor(width / 2);
    return { left: isModel ? 0 : half, bottom: 0, width: isModel ? half : width - half, height };
  }

  drawPane(pane, occlusion) {
    const box = this.boxOf(pane);
    this.setAspect(pane, box.width / box.height);
    this.setMarkerSizes(pane, box.height);
    const lines = pane === this.model ? this.curves : [this.atlasSeams];
    for (const curve of lines) curve.setResolution(box.width, box.height);
    const ratio = this.renderer.getPixelRatio();
    pane.layer.setSize(Math.max(1, Math.round(ratio * box.width)), Math.max(1, Math.round(ratio * box.height)));
    pane.layer.update(occlusion);
    this.renderer.setViewport(box.left, box.bottom, box.width, box.height);
    pane.layer.copy();
    this.renderer.render(pane.lines, pane.camera);
  }

  // The view has the same angle along the shorter side of the window, whichever that is.
  // What is looked at is in the middle of the part of the pane that is free.
  setAspect(pane, aspect) {
    const { camera, shift } = pane;
    if (pane === this.model) this.setFrustum(camera, Math.tan(THREE.MathUtils.degToRad(viewAngle / 2)) / Math.min(aspect, 1), aspect);
    else setSides(camera, 1.06 / pane.part * Math.max(1, 1 / aspect), aspect);
    camera.setViewOffset(aspect, 1, -shift[0] * aspect, shift[1], aspect, 1);
  }

  // `half` is half of the height of what is seen, at distance 1. As near to the mesh as can be: depths are the more accurate.
  setFrustum(camera, half, aspect) {
    const depth = camera.position.dot(this.eye); // of the middle of the mesh
    if (camera.isPerspectiveCamera) {
      camera.fov = 2 * THREE.MathUtils.radToDeg(Math.atan(half));
      camera.aspect = aspect;
      camera.near = Math.max(depth - modelRadius, 0.004);
      camera.far = Math.max(depth + modelRadius, 0.1);
    } else {
      setSides(camera, half * camera.position.distanceTo(this.controls.target), aspect);
      camera.near = depth - modelRadius;
      camera.far = depth + modelRadius;
    }
  }

  get eye() {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  setMarkerSizes({ camera }, height) {
    const { children } = camera === this.camera ? this.markers : this.sheetMarkers;
    for (const marker of /** @type {any[]} */ (children)) {
      marker.visible = marker.isSet && (camera !== this.camera || this.clipping.keeps(marker.position));
      sizeMarker(marker, camera, height);
    }
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    this.size = { width: Math.max(clientWidth, 1), height: Math.max(clientHeight, 1) };
    this.isStacked = window.matchMedia('(max-width: 640px)').matches;
    this.renderer.setSize(this.size.width, this.size.height, false);
    if (this.controls) {
      this.placement.placeModel(this.eye);
      this.placement.placePlane();
    }
    // the canvas has been cleared: there must not be a frame without a picture
    this.draw();
  }

  // from a direction, so that the mesh fills the view
  lookFrom(eye, center = new THREE.Vector3()) {
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(eye, this.placement.placeModel(eye));
    this.controls.update();
    this.moved(this.model);
  }

  resetView() {
    this.lookFrom(direction(this.up, 0.55, 0.6));
    this.fitPlane();
  }

  // The same direction, and all in sight.
  fit() {
    this.lookFrom(this.eye);
    this.fitPlane();
  }

  fitPlane() {
    this.plane.controls.target.set(0, 0, 0);
    this.plane.camera.position.set(0, 0, 5);
    this.plane.camera.zoom = 1;
    this.placement.placePlane();
    this.plane.controls.update();
    this.moved(this.plane);
  }

  // Moves the eye over the sheet, by parts of half of its size, and zooms.
  movePlane(right, up, factor = 1) {
    const { camera, controls } = this.plane;
    const step = new THREE.Vector3(right, up, 0).divideScalar(camera.zoom);
    camera.position.add(step);
    controls.target.add(step);
    camera.zoom *= factor;
    controls.update();
    this.moved(this.plane);
  }

  // A tree of its faces, made when it is first asked for a place.
  prepareToPick({ geometry }) {
    geometry.boundsTree ||= new MeshBVH(geometry, { indirect: true });
  }

  // one of the sides, `best` or `source`
  look(name, segments, sources, isClosed) {
    const points = sources.map((p) => new THREE.Vector3(...p));
    if (name === 'best') {
      const facing = points.map((point) => ({ point, normal: this.outwardNormal(point) }));
      this.lookFrom(bestDirection(this.probe, this.pickable.geometry, this.up, segments, facing, isClosed));
    }
    if (name === 'source' && points.length > 0) this.lookFrom(this.outwardAt(points[0]));
    if (isSide(name)) this.lookFrom(sideDirection(this.up, name));
  }

  // whether a closed surface has its inner side out: its volume is negative
  isInsideOut() {
    const { positions: p, triangles: t } = this;
    let volume = 0;
    for (let f = 0; f < t.length; f += 3) {
      const [a, b, c] = [3 * t[f], 3 * t[f + 1], 3 * t[f + 2]];
      volume += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2])
        + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    return volume < 0;
  }

  // not straight along the axis, around which the controls turn
  outwardAt(point) {
    const normal = this.outwardNormal(point);
    const high = upVector(this.up);
    if (Math.abs(normal.dot(high)) > 0.99) normal.addScaledVector(direction(this.up, 0, 0), 0.2).normalize();
    return normal;
  }

  // files may have their faces the wrong way around
  outwardNormal(point) {
    return this.normalNear(point).multiplyScalar(this.isInsideOut() ? -1 : 1);
  }

  normalNear(point) {
    const p = this.positions;
    const normals = this.pickable.geometry.getAttribute('normal');
    let best = 0, least = Infinity;
    for (let i = 0; i < p.length; i += 3) {
      const d = (p[i] - point.x) ** 2 + (p[i + 1] - point.y) ** 2 + (p[i + 2] - point.z) ** 2;
      if (d < least) [least, best] = [d, i / 3];
    }
    return new THREE.Vector3().fromBufferAttribute(normals, best).normalize();
  }

  getView() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  setView(view) {
    this.camera.position.fromArray(view, 0);
    this.controls.target.fromArray(view, 3);
    this.controls.update();
    this.placement.placeModel(this.eye);
    this.moved(this.model);
  }

  // turns the model by an angle about the axis that is up and the horizontal one
  orbit(horizontal, vertical) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const toY = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    const spherical = new THREE.Spherical().setFromVector3(offset.applyQuaternion(toY));
    spherical.theta += horizontal;
    spherical.phi += vertical;
    spherical.makeSafe();
    offset.setFromSpherical(spherical).applyQuaternion(toY.invert());
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.moved(this.model);
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.moved(this.model);
  }

  setMesh(positions, triangles) {
    this.positions = positions;
    this.triangles = triangles;
    const geometry = this.pickable.geometry;
    geometry.dispose();
    this.pickable.geometry = new THREE.BufferGeometry();
    this.pickable.geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    this.pickable.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    this.pickable.geometry.computeVertexNormals();
    this.pickable.geometry.computeBoundingSphere();
    this.pickable.geometry.computeBoundingBox();
    this.hidePreview();
    this.distance = null;
    this.laplacian = null;
    this.cells = null;
    this.exactCells = null;
    this.wireframe.geometry.dispose();
    this.wireframe.geometry = new THREE.BufferGeometry();
    this.showUncut();
    this.setMarker(this.farthestMarker, null);
    this.setMarker(this.nearestMarker, null);
    this.setSources([]);
    this.setSourceLines(new Float32Array(0));
    this.setPaths(new Float32Array(0), null);
    for (const curve of [this.edgeCurve, this.faceCurve]) curve.set(new Float32Array(0));
    this.arrows.visible = false;
    this.showWireframe(this.wantsWireframe);
  }

  setSurfaceGeometry(geometry) {
    const old = this.surface.opaque.geometry;
    if (old !== geometry) old.dispose();
    this.surface.setGeometry(geometry);
    this.atlas.setGeometry(geometry);
    this.setDistance(this.distance);
    this.setLaplacian(this.laplacian);
    this.paintCells();
    this.model.layer.hasOcclusion = false;
  }

  // The surface as it is, each vertex once.
  showUncut() {
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(this.pickable.geometry.index);
    geometry.setAttribute('position', this.pickable.geometry.getAttribute('position'));
    geometry.setAttribute('normal', this.pickable.geometry.getAttribute('normal'));
    /** @type {any} */
    this.cut = null;
    this.exactCells = null;
    this.setHasAtlas(false);
    this.setSurfaceGeometry(geometry);
    this.seams.set(new Float32Array(0));
    this.invalidate();
  }

  // The surface divided into cells, where the curve between them runs; `colors` are those of its vertices.
  showCells({ triangles, colors, ...cut }) {
    this.cut = cut;
    this.exactCells = colors;
    this.setSurfaceGeometry(this.dividedGeometry(cut, triangles));
    this.invalidate();
  }

  dividedGeometry(cut, triangles) {
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    for (const name of ['position', 'normal']) {
      const values = valuesAt(cut, this.pickable.geometry.getAttribute(name).array, 3);
      geometry.setAttribute(name, new THREE.BufferAttribute(values, 3));
    }
    return geometry;
  }

  setHasAtlas(hasAtlas) {
    if (this.hasAtlas === hasAtlas) return;
    this.hasAtlas = hasAtlas;
    this.plane.element.hidden = !hasAtlas;
    this.canvas.parentElement.classList.toggle('has-atlas', hasAtlas);
    this.model.layer.hasOcclusion = false;
  }

  // The surface cut open, as in `atlas.js`: vertex i has the texture coordinates uv[2 i], uv[2 i + 1]; face i is a part of
  // faces[i] of the mesh.
  // `colors` are those of its vertices by their cells, or null.
  showCut({ triangles, faces, uv, seams, atlasSeams, sheets, colors, ...cut }) {
    const geometry = this.dividedGeometry(cut, triangles);
    geometry.setAttribute('uv', new THREE.BufferAttribute(uv, 2));
    const flat = new Float32Array(1.5 * uv.length);
    for (let i = 0; i < uv.length / 2; ++i) flat.set([uv[2 * i], uv[2 * i + 1]], 3 * i);
    this.flatPickable.geometry.dispose();
    this.flatPickable.geometry = new THREE.BufferGeometry();
    this.flatPickable.geometry.setIndex(geometry.index);
    this.flatPickable.geometry.setAttribute('position', new THREE.BufferAttribute(flat, 3));
    this.cut = cut;
    this.cutTriangles = triangles;
    this.cutFaces = faces;
    this.exactCells = colors;
    this.setHasAtlas(true);
    this.setSurfaceGeometry(geometry);
    this.seams.set(seams);
    this.atlasSeams.set(atlasSeams);
    this.setSheets(sheets);
    this.invalidate();
  }

  // While a source moves: the curve on a simplified mesh, in the place of all curves.
  showPreview(segments, points, showsHidden) {
    if (!this.isPreview) for (const curve of [this.edgeCurve, this.faceCurve, this.paths]) curve.show(false);
    if (!this.isPreview) for (const marker of [this.farthestMarker, this.nearestMarker, this.endMarker]) this.setMarker(marker, null);
    this.isPreview = true;
    this.arrows.visible = false;
    this.previewCurve.set(segments);
    this.previewCurve.show(true, showsHidden);
    this.setSources(points);
  }

  hidePreview() {
    this.isPreview = false;
    this.previewCurve.show(false);
  }

  // whether the next frame would draw the surface with other values
  get isSurfaceDue() {
    return [this.model, ...(this.hasAtlas ? [this.plane] : [])].some(({ layer }) => layer.isDue);
  }

  placeOf(face, coordinates) {
    const { positions: p, triangles: t } = this;
    return [0, 1, 2].map((i) => coordinates.reduce((sum, b, k) => sum + b * p[3 * t[3 * face + k] + i], 0));
  }

  setDistance(values) {
    this.distance = values;
    this.setAttribute('geodesicDistance', values);
  }

  setLaplacian(values) {
    this.laplacian = values;
    this.setAttribute('distanceLaplacian', values);
  }

  // the colors of the vertices of the mesh, three numbers each, or null
  setCells(colors) {
    this.cells = colors;
    this.exactCells = null;
    this.paintCells();
  }

  paintCells() {
    const { geometry } = this.surface.opaque;
    const { cells, exactCells } = this;
    if (!cells) {
      geometry.deleteAttribute('cellColor');
      return;
    }
    this.attributeFor('cellColor', geometry.getAttribute('position').count, 3)
      .set(exactCells || (this.cut ? valuesAt(this.cut, cells, 3) : cells));
    this.invalidateValues();
  }

  // The values of an attribute of the surface, to be written. There is one buffer as long as there is the surface.
  attributeFor(name, count, itemSize) {
    const { geometry } = this.surface.opaque;
    if (!geometry.getAttribute(name))
      geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(count * itemSize), itemSize).setUsage(THREE.DynamicDrawUsage));
    const attribute = geometry.getAttribute(name);
    attribute.needsUpdate = true;
    return attribute.array;
  }

  // values at the vertices of the mesh, or null
  setAttribute(name, values) {
    const { geometry } = this.surface.opaque;
    const size = geometry.getAttribute('position').count;
    const given = values && this.cut ? valuesAt(this.cut, values) : values;
    const attribute = this.attributeFor(name, size, 1);
    for (let i = 0; i < size; ++i) attribute[i] = given && Number.isFinite(given[i]) ? given[i] : -1;
    this.invalidateValues();
  }

  setUniforms(values) {
    const changes = [this.surface, this.atlas].map((surface) => surface.setUniforms(values));
    if (changes.some(Boolean)) this.invalidateValues();
  }

  setTransparency(transparency) {
    this.surface.setOpacity(1 - transparency);
    for (const curve of this.curves) curve.setTransparency(transparency);
    this.invalidate();
  }

  setOcclusion(isWanted) {
    this.occlusionStrength = isWanted ? 0.75 : 0;
    this.invalidateCurves();
  }

  // Each edge of the mesh is made a line when it is first wanted.
  showWireframe(isWanted) {
    this.wantsWireframe = isWanted;
    this.wireframe.visible = Boolean(isWanted);
    if (isWanted && this.triangles && !this.wireframe.geometry.getAttribute('position'))
      this.wireframe.geometry = new THREE.WireframeGeometry(this.pickable.geometry);
    this.invalidate();
  }

  setMarker(marker, point) {
    marker.isSet = point !== null;
    marker.visible = marker.isSet;
    if (point) marker.position.fromArray(point);
    this.invalidateCurves();
  }

  // Several ones are numbered, as their sheets are.
  setSources(points) {
    while (this.sourceMarkers.length < points.length) this.sourceMarkers.push(this.addSourceMarker(this.markers));
    this.sourceMarkers.forEach((marker, i) => {
      this.setMarker(marker, points[i] || null);
      this.number(marker, points.length > 1 ? i + 1 : null);
    });
  }

  setSheets(sheets) {
    while (this.sheetMarkers.children.length < sheets.length) this.addSourceMarker(this.sheetMarkers);
    this.sheetMarkers.children.forEach((marker, i) => {
      this.setMarker(marker, sheets[i] ? [...sheets[i].place, 0.02] : null);
      this.number(marker, sheets[i] && sheets.length > 1 ? sheets[i].source + 1 : null);
    });
  }

  addSourceMarker(group) {
    const marker = makeMarker();
    if (this.colors) setMarkerColors(marker, this.colors.source, this.colors.casing);
    group.add(marker);
    return marker;
  }

  number(marker, number) {
    if (marker.number !== number) setNumber(marker, number);
  }

  // edges that are sources
  setSourceLines(segments) {
    this.sourceLines.set(segments);
    this.sourceLines.show(true, true);
    this.invalidateCurves();
  }

  setPaths(segments, end) {
    this.paths.set(segments);
    this.paths.show(true, true);
    this.setMarker(this.endMarker, end);
  }

  // Arrows along vectors of length 1 where the distance is smooth.
  setArrows(gradient, length) {
    const normals = this.pickable.geometry.getAttribute('normal').array;
    const lines = arrowsAlong(gradient, this.positions, normals, length);
    this.arrows.geometry.dispose();
    this.arrows.geometry = new THREE.BufferGeometry();
    this.arrows.geometry.setAttribute('position', new THREE.BufferAttribute(lines, 3));
    this.invalidateCurves();
  }
}
