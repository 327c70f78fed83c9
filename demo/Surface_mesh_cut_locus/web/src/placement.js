// Where the mesh and the sheet are put on the screen: as large as they can be in the area that nothing covers.
import * as THREE from 'three';
import { bestArea } from './free_area.js';

export const viewAngle = 35; // degrees

export class Placement {
  // `overlays` are the elements that lie above the picture.
  constructor(viewer, overlays) {
    this.viewer = viewer;
    this.overlays = overlays;
  }

  // what lies above a pane, in pixels from its upper left corner
  overlaysOf(pane) {
    const view = this.viewer.boxOf(pane);
    const stage = this.viewer.canvas.getBoundingClientRect();
    const left = stage.left + view.left, top = stage.top + this.viewer.size.height - view.bottom - view.height;
    return this.overlays.map((element) => element.getBoundingClientRect())
      .filter(({ width, height }) => width > 0 && height > 0)
      .map((box) => ({ left: box.left - left, top: box.top - top, right: box.right - left, bottom: box.bottom - top }));
  }

  // The mesh, seen from a direction, in the area in which it is largest; the distance from which it fills it is returned.
  placeModel(eye) {
    const { model } = this.viewer;
    const view = this.viewer.boxOf(model);
    const reach = ({ width, height }) => this.reachFrom(eye, width / view.height, height / view.height);
    const area = bestArea(view, this.overlaysOf(model), (size) => -reach(size));
    model.shift = area.shift;
    return reach(area);
  }

  // and the sheet, which is a square
  placePlane() {
    const { plane } = this.viewer;
    const view = this.viewer.boxOf(plane);
    const sideOf = ({ width, height }) => Math.min(width, height);
    const area = bestArea(view, this.overlaysOf(plane), sideOf);
    plane.shift = area.shift;
    plane.part = sideOf(area) / sideOf(view);
  }

  // How far away the eye has to be to see all vertices in a part of the view, with a margin. Its sides are those parts of
  // the height of the view.
  reachFrom(eye, width, height) {
    const { positions: p, camera, model } = this.viewer;
    if (!p) return 3.4; // twice the radius of the mesh, and more
    const right = new THREE.Vector3().crossVectors(camera.up, eye).normalize();
    const high = new THREE.Vector3().crossVectors(eye, right).normalize();
    const view = this.viewer.boxOf(model);
    const half = Math.tan(THREE.MathUtils.degToRad(viewAngle / 2)) / Math.min(view.width / view.height, 1);
    let reach = 0;
    for (let i = 0; i < p.length; i += 3) {
      const along = camera.isOrthographicCamera ? 0 : p[i] * eye.x + p[i + 1] * eye.y + p[i + 2] * eye.z;
      const across = Math.abs(p[i] * right.x + p[i + 1] * right.y + p[i + 2] * right.z);
      const above = Math.abs(p[i] * high.x + p[i + 1] * high.y + p[i + 2] * high.z);
      reach = Math.max(reach, along + above / (half * height), along + across / (half * width));
    }
    return 1.06 * reach;
  }
}
