// Points that are marked: balls of the same size on the screen, with a rim, in front of the surface; and numbers.
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
  marker.colors = { color, rim };
  setNumber(marker, marker.number);
}

const side = 64; // pixels of the picture of a number

function draw(canvas, text, { color, rim }) {
  const context = canvas.getContext('2d');
  const middle = side / 2;
  context.clearRect(0, 0, side, side);
  for (const [radius, fill] of [[middle - 1, rim], [middle - 6, color]]) {
    context.fillStyle = fill;
    context.beginPath();
    context.arc(middle, middle, radius, 0, 2 * Math.PI);
    context.fill();
  }
  context.fillStyle = rim;
  context.font = `bold ${text.length > 1 ? 28 : 38}px system-ui, "DejaVu Sans", sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, middle, middle + 3);
}

// A disk with a number covers the ball, or none does.
export function setNumber(marker, number) {
  marker.number = number;
  let [, , disk] = marker.children;
  if (disk) disk.visible = Boolean(number);
  if (!number || !marker.colors) return;
  if (!disk) {
    const map = new THREE.CanvasTexture(Object.assign(document.createElement('canvas'), { width: side, height: side }));
    disk = new THREE.Sprite(new THREE.SpriteMaterial({ map, alphaTest: 0.5 }));
    disk.scale.setScalar(3.6);
    marker.add(disk);
  }
  const { map } = disk.material;
  draw(map.image, String(number), marker.colors);
  map.needsUpdate = true;
}

const pixels = 5.5; // their radius

// of what the camera sees there
export function halfHeightAt(place, camera) {
  return camera.isOrthographicCamera ? (camera.top - camera.bottom) / 2 / camera.zoom
    : place.distanceTo(camera.position) * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2));
}

export function sizeMarker(marker, camera, height) {
  const toEye = camera.position.clone().sub(marker.position);
  if (camera.isOrthographicCamera) camera.getWorldDirection(toEye).negate();
  toEye.normalize();
  for (const part of marker.children) part.position.copy(toEye).multiplyScalar(part.isSprite ? 2.4 : 1);
  marker.scale.setScalar(2 * pixels / height * halfHeightAt(marker.position, camera));
}
