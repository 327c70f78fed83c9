// Points that are marked: balls of the same size on the screen, with a rim, in front of the surface.
import * as THREE from 'three';

const ball = new THREE.SphereGeometry(1, 24, 16);

export function makeMarker() {
  const marker = new THREE.Group();
  const rim = new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ side: THREE.BackSide }));
  rim.scale.setScalar(1.35);
  marker.add(new THREE.Mesh(ball, new THREE.MeshBasicMaterial()), rim);
  marker.visible = false;
  return marker;
}

export function setMarkerColors(marker, color, rim) {
  marker.children[0].material.color.set(color);
  marker.children[1].material.color.set(rim);
}

const pixels = 5.5; // their radius

export function sizeMarker(marker, camera, height) {
  const distance = marker.position.distanceTo(camera.position);
  const toEye = camera.position.clone().sub(marker.position).normalize();
  for (const part of marker.children) part.position.copy(toEye);
  marker.scale.setScalar(2 * pixels / height * distance * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2)));
}
