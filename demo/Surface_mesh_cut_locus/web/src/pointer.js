// What the pointer is at: a click is a press and a release at about the same place, and where it rests one may read off
// values.
import * as THREE from 'three';

const restMilliseconds = 50;

export class Pointer {
  constructor(viewer, { onPick, onHover }) {
    Object.assign(this, { viewer, onPick, onHover });
    this.ray = new THREE.Raycaster();
    this.watch(viewer.model, (x, y) => this.onModel(x, y));
    this.watch(viewer.plane, (x, y) => this.onPlane(x, y));
  }

  watch(pane, locate) {
    const { element } = pane;
    let down = null;
    const place = (event) => {
      const box = element.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    element.addEventListener('pointerdown', (event) => {
      down = event.button === 0 ? [event.clientX, event.clientY] : null;
      this.onHover(null);
    });
    element.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      down = null;
      const location = locate(...place(event));
      if (location) this.onPick(location, event.shiftKey ? 'add' : event.altKey ? 'path' : null);
      // a finger does not rest above the surface: values are those where it has been
      if (location && event.pointerType === 'touch') this.onHover(location, [event.clientX, event.clientY]);
    });
    element.addEventListener('pointermove', (event) => {
      clearTimeout(this.timer);
      if (event.buttons !== 0 || event.pointerType === 'touch') return;
      const [x, y] = place(event);
      this.timer = setTimeout(() => this.onHover(locate(x, y), [event.clientX, event.clientY]), restMilliseconds);
    });
    element.addEventListener('pointerleave', (event) => {
      if (event.pointerType === 'touch') return;
      clearTimeout(this.timer);
      this.onHover(null);
    });
  }

  cast(pane, object, x, y) {
    const { viewer } = this;
    const { width, height } = viewer.boxOf(pane);
    if (!viewer.positions) return null;
    viewer.setAspect(pane, width / height);
    pane.camera.updateMatrixWorld();
    this.ray.setFromCamera(new THREE.Vector2(2 * x / width - 1, 1 - 2 * y / height), pane.camera);
    const [hit] = this.ray.intersectObject(object);
    return hit || null;
  }

  // The point of the surface that is seen at a pixel, or null: its face, its barycentric coordinates there and its
  // place, and how long a pixel is at that place.
  onModel(x, y) {
    const { viewer } = this;
    const hit = this.cast(viewer.model, viewer.pickable, x, y);
    return hit && this.location(hit.faceIndex, this.coordinatesIn(hit, viewer.triangles, viewer.positions));
  }

  // Faces of the cut surface are in the order of those of the mesh; where their corners start may differ.
  onPlane(x, y) {
    const { viewer } = this;
    const { geometry } = viewer.flatPickable;
    const hit = this.cast(viewer.plane, viewer.flatPickable, x, y);
    if (!hit) return null;
    const face = hit.faceIndex;
    const coordinates = this.coordinatesIn(hit, viewer.cutTriangles, geometry.getAttribute('position').array);
    const corners = [0, 1, 2].map((k) => viewer.origin[viewer.cutTriangles[3 * face + k]]);
    const order = [0, 1, 2].map((k) => corners.indexOf(viewer.triangles[3 * face + k]));
    return coordinates && !order.includes(-1) ? this.location(face, order.map((k) => coordinates[k])) : null;
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
    const pixel = 2 * place.distanceTo(viewer.camera.position) / height
      * Math.tan(THREE.MathUtils.degToRad(viewer.camera.fov / 2));
    return { face, coordinates, place: place.toArray(), pixel };
  }

  // where a place of the surface is seen, as a click there would be
  atPlace(place) {
    const { width, height } = this.viewer.boxOf(this.viewer.model);
    const seen = new THREE.Vector3(...place).project(this.viewer.camera);
    return this.onModel((seen.x + 1) / 2 * width, (1 - seen.y) / 2 * height);
  }

  atCenter() {
    const { width, height } = this.viewer.boxOf(this.viewer.model);
    return this.onModel(width / 2, height / 2);
  }
}
