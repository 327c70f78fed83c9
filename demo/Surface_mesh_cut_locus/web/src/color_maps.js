// The scales of colors: in the picture a number becomes a place in a texture, in the legend a gradient.
import { interpolateCividis, interpolateGreys, interpolateMagma, interpolateViridis, schemeSet3 } from 'd3-scale-chromatic';
import * as THREE from 'three';

const size = 256;

// "rgb(r, g, b)" or "#rrggbb", in [0, 1]
function channels(text) {
  if (text.startsWith('#')) return [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255);
  return text.match(/[\d.]+/g).slice(0, 3).map((x) => Number(x) / 255);
}

// From the source, which is bright, to the farthest point. Equal steps look equal; the ends that are white or black are left out.
export const distanceColors = {
  viridis: (t) => channels(interpolateViridis(1 - 0.94 * t)),
  cividis: (t) => channels(interpolateCividis(1 - 0.94 * t)),
  magma: (t) => channels(interpolateMagma(0.96 - 0.86 * t)),
  grays: (t) => channels(interpolateGreys(0.06 + 0.74 * t)),
};

// from weak to strong branches: yellow, orange, red, violet
const ramp = [[0.99, 0.83, 0.25], [0.96, 0.55, 0.15], [0.84, 0.19, 0.20], [0.45, 0.06, 0.40]];

export function branchColor(t) {
  const x = Math.min(Math.max(t, 0), 1) * (ramp.length - 1);
  const i = Math.min(Math.floor(x), ramp.length - 2);
  return [0, 1, 2].map((k) => ramp[i][k] + (x - i) * (ramp[i + 1][k] - ramp[i][k]));
}

// blue below zero, where the cut locus is, over white to brown
export function laplacianColor(t) {
  const low = [0.10, 0.28, 0.62], middle = [0.95, 0.95, 0.95], high = [0.65, 0.38, 0.12];
  const x = 2 * t - 1;
  return middle.map((m, k) => m + Math.abs(x) * ((x < 0 ? low : high)[k] - m));
}

// of the points whose nearest source has that number: light, and for 12 sources well apart
const fields = schemeSet3.map(channels);
export const cellColor = (source) => fields[source % fields.length];

export function makeTexture(colorAt) {
  const data = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) data.set([...colorAt(i / (size - 1)).map((x) => Math.round(255 * x)), 255], 4 * i);
  const texture = new THREE.DataTexture(data, size, 1);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export const cssColor = (rgb) => `rgb(${rgb.map((x) => Math.round(255 * x)).join(' ')})`;

export const stops = (colorAt, count = 9) =>
  Array.from({ length: count }, (_, i) => cssColor(colorAt(i / (count - 1))));
