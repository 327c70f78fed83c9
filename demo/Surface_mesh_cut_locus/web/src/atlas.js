// From what the library returns for a cut surface to what is drawn and exported.
import * as THREE from 'three';

// Copies of the seams: on the model, and a little above the atlas, which lies in the plane z = 0.
export function seamsOf({ origin, border, uv }, positions) {
  const seams = new Float32Array(3 * border.length), atlasSeams = new Float32Array(3 * border.length);
  border.forEach((v, i) => {
    for (let k = 0; k < 3; ++k) seams[3 * i + k] = positions[3 * origin[v] + k];
    atlasSeams.set([uv[2 * v], uv[2 * v + 1], 0.01], 3 * i);
  });
  return { seams, atlasSeams };
}

const pixels = 1024;

// The part of the sheet that several faces cover: the faces of each pixel are added up.
export function overlapOf({ uv, triangles }, renderer) {
  const flat = new Float32Array(uv.length / 2 * 3);
  for (let i = 0; i < uv.length / 2; ++i) flat.set([uv[2 * i], uv[2 * i + 1]], 3 * i);
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  geometry.setAttribute('position', new THREE.BufferAttribute(flat, 3));
  const material = new THREE.MeshBasicMaterial({
    color: new THREE.Color(1 / 255, 0, 0),
    side: THREE.DoubleSide,
    blending: THREE.AdditiveBlending,
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene();
  scene.add(mesh);
  const target = new THREE.WebGLRenderTarget(pixels, pixels);
  const color = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear();
  renderer.render(scene, new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1));
  const bytes = new Uint8Array(4 * pixels * pixels);
  renderer.readRenderTargetPixels(target, 0, 0, pixels, pixels, bytes);
  renderer.setRenderTarget(null);
  renderer.setClearColor(color, alpha);
  for (const part of [geometry, material, target]) part.dispose();
  let used = 0, covered = 0;
  for (let i = 0; i < bytes.length; i += 4) {
    used += bytes[i] > 0;
    covered += bytes[i] > 1;
  }
  return covered / Math.max(used, 1);
}
