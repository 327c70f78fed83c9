// What the pointer is at: a click is a press and a release at about the same place, and where it rests one may read off
// values. A source that is pressed follows the pointer until it is released, as all sources do while a key is held.
import * as THREE from 'three';
import { coordinatesInFace } from './atlas.js';
import { halfHeightAt } from './markers.js';
import { Press } from './press.js';

const restMilliseconds = 50;
const ringPixels = 6; // apart, where the nearest point of the surface is looked for
const grabPixels = { mouse: 10, pen: 14, touch: 22 }; // a source that is as near is pressed

export class Pointer {
  constructor(viewer, { onPick, onHover, onFollow }) {
    this.viewer = viewer;
    this.onPick = onPick;
    this.onHover = onHover;
    this.onFollow = onFollow;
    this.ray = new THREE.Raycaster();
    this.ray.firstHitOnly = true;
    this.watch(viewer.model, (x, y) => this.onModel(x, y));
    this.watch(viewer.plane, (x, y) => this.onPlane(x, y));
    this.watchSources(viewer.model.element);
  }

  watch(pane, locate) {
    const { element } = pane;
    const press = new Press();
    const place = (event) => {
      const box = element.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    element.addEventListener('pointerdown', (event) => {
      press.down(event);
      this.onHover(null);
    });
    element.addEventListener('pointercancel', () => press.cancel());
    element.addEventListener('pointerup', (event) => {
      if (!press.up(event)) return;
      const location = locate(...place(event));
      if (location) this.onPick(location, event.shiftKey ? 'add' : event.altKey ? 'path' : null);
      // a finger does not rest above the surface: values are those where it has been
      if (location && event.pointerType === 'touch') this.onHover(location, [event.clientX, event.clientY]);
    });
    element.addEventListener('pointermove', (event) => {
      clearTimeout(this.timer);
      press.move(event);
      if (event.buttons !== 0 || event.pointerType === 'touch' || this.isFollowing) return;
      const [x, y] = place(event);
      this.timer = setTimeout(() => this.onHover(locate(x, y), [event.clientX, event.clientY]), restMilliseconds);
    });
    element.addEventListener('pointerleave', (event) => {
      if (event.pointerType === 'touch') return;
      clearTimeout(this.timer);
      this.onHover(null);
    });
  }

  /** @returns {any} */
  cast(pane, object, x, y) {
    const { viewer } = this;
    const { width, height } = viewer.boxOf(pane);
    if (!viewer.positions) return null;
    viewer.setAspect(pane, width / height);
    pane.camera.updateMatrixWorld();
    viewer.prepareToPick(object);
    this.ray.setFromCamera(new THREE.Vector2(2 * x / width - 1, 1 - 2 * y / height), pane.camera);
    pane.clipping.limit(this.ray);
    const [hit] = this.ray.intersectObject(object, false);
    return hit || null;
  }

  // The point of the surface that is seen at a pixel, or null: its face, its barycentric coordinates there and its
  // place, and how long a pixel is at that place.
  onModel(x, y) {
    const { viewer } = this;
    const hit = this.cast(viewer.model, viewer.pickable, x, y);
    return hit && this.location(hit.faceIndex, this.coordinatesIn(hit, viewer.triangles, viewer.positions));
  }

  // A press on a source begins before the view turns with it.
  watchSources(element) {
    let pressed = null; // the source, and how it has been pressed
    const press = new Press();
    let handedOn = null; // to the view
    const place = ({ clientX, clientY }) => {
      const box = element.getBoundingClientRect();
      return [clientX - box.left, clientY - box.top];
    };
    const release = () => {
      press.cancel();
      if (!pressed) return;
      pressed = null;
      this.viewer.controls.enabled = true;
      this.endFollowing();
    };
    element.addEventListener('pointerdown', (event) => {
      // A second finger zooms: the view gets the first one, too, and the source stays.
      if (pressed && !event.isPrimary) {
        const { first } = pressed;
        release();
        handedOn = new PointerEvent('pointerdown', first);
        element.dispatchEvent(handedOn);
      }
      if (event === handedOn) return;
      if (event.button !== 0 || !event.isPrimary || pressed || this.isFollowing) return;
      const index = this.sourceAt(...place(event), grabPixels[event.pointerType] || grabPixels.mouse);
      if (index < 0) return;
      press.down(event);
      pressed = { index, first: event };
      this.viewer.controls.enabled = false;
      element.setPointerCapture(event.pointerId);
    }, { capture: true });
    element.addEventListener('pointermove', (event) => {
      this.last = place(event);
      if (press.move(event) && !this.isFollowing) this.startFollowing(pressed.index);
      if (this.isFollowing) this.follow();
    });
    for (const type of ['pointerup', 'pointercancel'])
      element.addEventListener(type, (event) => { if (pressed && event.pointerId === pressed.first.pointerId) release(); });
    element.addEventListener('pointerleave', () => { this.last = null; });
  }

  startFollowing(index) {
    if (this.isFollowing || !this.onFollow.start(index)) return;
    this.isFollowing = true;
    clearTimeout(this.timer);
    this.onHover(null);
    this.viewer.model.element.classList.add('is-following');
    this.follow();
  }

  follow() {
    const { last } = this;
    if (last) this.onFollow.move(() => this.onModel(...last));
  }

  endFollowing() {
    if (!this.isFollowing) return;
    this.isFollowing = false;
    this.viewer.model.element.classList.remove('is-following');
    this.onFollow.end();
  }

  // the index of the source that is seen there, or -1
  sourceAt(x, y, reach) {
    const hit = this.onModel(x, y);
    if (!hit) return -1;
    const place = new THREE.Vector3(...hit.place);
    const off = this.viewer.sourceMarkers.map(({ visible, position }) => (visible ? position.distanceTo(place) : Infinity));
    return off.findIndex((d) => d <= reach * hit.pixel && d === Math.min(...off));
  }

  // A face of the cut surface may be a part of one of the mesh, and start at another corner.
  onPlane(x, y) {
    const { viewer } = this;
    const { geometry } = viewer.flatPickable;
    const hit = this.cast(viewer.plane, viewer.flatPickable, x, y);
    if (!hit) return null;
    const face = viewer.cutFaces[hit.faceIndex];
    const coordinates = this.coordinatesIn(hit, viewer.cutTriangles, geometry.getAttribute('position').array);
    const [part, corners] = [[viewer.cutTriangles, hit.faceIndex], [viewer.triangles, face]].map(([triangles, f]) =>
      [0, 1, 2].map((k) => triangles[3 * f + k]));
    return coordinates && this.location(face, coordinatesInFace(viewer.cut, part, coordinates, corners));
  }

  coordinatesIn({ faceIndex, point }, triangles, positions) {
    const corners = [0, 1, 2].map((k) => new THREE.Vector3().fromArray(positions, 3 * triangles[3 * faceIndex + k]));
    const c = new THREE.Vector3();
    if (!new THREE.Triangle(...corners).getBarycoord(point, c)) return null;
    const clamped = c.toArray().map((b) => Math.max(b, 0));
    const sum = clamped[0] + clamped[1] + clamped[2];
    return sum > 0 ? clamped.map((b) => b / sum) : null;
  }

  location(face, coordinates) {
    if (!coordinates) return null;
    const { viewer } = this;
    const place = new THREE.Vector3();
    coordinates.forEach((b, k) =>
      place.addScaledVector(new THREE.Vector3().fromArray(viewer.positions, 3 * viewer.triangles[3 * face + k]), b));
    const { height } = viewer.boxOf(viewer.model);
    const pixel = 2 / height * halfHeightAt(place, viewer.camera);
    return { face, coordinates, place: place.toArray(), pixel };
  }

  // where a place of the surface is seen, as a click there would be
  atPlace(place) {
    const { width, height } = this.viewer.boxOf(this.viewer.model);
    const seen = new THREE.Vector3(...place).project(this.viewer.camera);
    return this.onModel((seen.x + 1) / 2 * width, (1 - seen.y) / 2 * height);
  }

  // The point of the surface that is seen nearest to a pixel of the model's part, or null if nothing is seen: around it
  // in rings, of which the first one that has any decides.
  nearestSeen(x, y) {
    const found = this.onModel(x, y);
    if (found) return found;
    const { width, height } = this.viewer.boxOf(this.viewer.model);
    const isInside = (u, v) => u >= 0 && v >= 0 && u <= width && v <= height;
    for (let radius = ringPixels; radius < Math.hypot(width, height); radius += ringPixels) {
      const count = Math.ceil(2 * Math.PI * radius / ringPixels);
      for (let i = 0; i < count; ++i) {
        const angle = 2 * Math.PI * i / count;
        const [u, v] = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
        const hit = isInside(u, v) && this.onModel(u, v);
        if (hit) return hit;
      }
    }
    return null;
  }
}
