// A plane across an axis takes away what lies in front of it, so that one sees inside.
import * as THREE from 'three';

export class Clipping {
  constructor() {
    this.plane = new THREE.Plane();
    this.planes = []; // for materials: this one, or none
  }

  // One of `clips` of state.js, at a share of the way along the axis through a box. Returns whether there is another number of planes.
  set(name, share, { min, max }) {
    const before = this.planes.length;
    this.planes = name === 'no' ? [] : [this.plane];
    if (name !== 'no') {
      const axis = name.at(-1);
      const at = min[axis] + share * (max[axis] - min[axis]);
      const sign = name.length > 1 ? 1 : -1; // the plane's normal points to what is kept
      this.plane.normal.set(0, 0, 0)[axis] = sign;
      this.plane.constant = -sign * at;
    }
    return this.planes.length !== before;
  }

  keeps(point) {
    return this.planes.every((plane) => plane.distanceToPoint(point) >= 0);
  }

  // The part of a ray that is kept.
  limit(raycaster) {
    Object.assign(raycaster, { near: 0, far: Infinity });
    for (const plane of this.planes) {
      const off = plane.distanceToPoint(raycaster.ray.origin), slope = plane.normal.dot(raycaster.ray.direction);
      if (slope > 0) raycaster.near = Math.max(0, -off / slope);
      else if (off < 0) raycaster.far = 0;
      else if (slope < 0) raycaster.far = -off / slope;
    }
  }
}
