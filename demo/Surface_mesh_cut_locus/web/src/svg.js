// Drawings of the curve for print: as it is seen, what the surface hides dashed, and the outline of the flattened sheet.
import * as THREE from 'three';
import { chainsOf } from './chains.js';

const round = (x) => Number(x.toFixed(2));
const path = (points) => `M${points.map(([x, y]) => `${round(x)} ${round(y)}`).join('L')}`;

function document(width, height, body) {
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" `
    + `fill="none" stroke-linecap="round" stroke-linejoin="round">\n${body}\n</svg>\n`;
}

// of segments, those that a plane leaves
function kept(segments, clipping) {
  const isKept = (i) => clipping.keeps(new THREE.Vector3().fromArray(segments, i));
  return segments.filter((_, i) => isKept(i - i % 6) && isKept(i - i % 6 + 3));
}

// `points` and `lines` are sources, in space.
export function curveToSvg(viewer, segments, { points, lines }, colors) {
  const { width, height } = viewer.boxOf(viewer.model);
  const { camera, probe } = viewer;
  viewer.setAspect(viewer.model, width / height);
  const scale = Math.min(2, 2048 / Math.max(width, height));
  probe.look(viewer.pickable.geometry, camera, Math.round(scale * width), Math.round(scale * height), viewer.clipping.planes);
  const place = (p) => {
    const v = new THREE.Vector3(...p).project(camera);
    return [(v.x + 1) / 2 * width, (1 - v.y) / 2 * height];
  };
  const parts = { hidden: [], seen: [] };
  for (const chain of chainsOf(kept(segments, viewer.clipping))) {
    const isSeen = (i) => probe.sees(new THREE.Vector3(...chain[i - 1]).add(new THREE.Vector3(...chain[i])).multiplyScalar(0.5), 0.01);
    for (let i = 1; i < chain.length;) {
      const seen = isSeen(i);
      const run = [place(chain[i - 1])];
      for (; i < chain.length && isSeen(i) === seen; ++i) run.push(place(chain[i]));
      parts[seen ? 'seen' : 'hidden'].push(path(run));
    }
  }
  const sources = points.filter((point) => viewer.clipping.keeps(new THREE.Vector3(...point))).map((point) => {
    const [x, y] = place(point);
    return `<circle cx="${round(x)}" cy="${round(y)}" r="5" fill="${colors.source}" stroke="#fff"/>`;
  });
  if (lines.length > 0)
    sources.unshift(`<path id="border" stroke="${colors.source}" stroke-width="3" d="${chainsOf(kept(lines, viewer.clipping)).map((chain) => path(chain.map(place))).join('')}"/>`);
  return document(width, height,
    `<path id="hidden" stroke="${colors.hidden}" stroke-width="2" stroke-dasharray="4 5" d="${parts.hidden.join('')}"/>\n`
    + `<path id="seen" stroke="${colors.curve}" stroke-width="3" d="${parts.seen.join('')}"/>\n${sources.join('\n')}`);
}

// Several sheets have the numbers of their sources.
export function outlineToSvg({ border, uv, sheets }, colors) {
  const size = 1000;
  const segments = new Float32Array(3 * border.length);
  border.forEach((v, i) => segments.set([uv[2 * v], uv[2 * v + 1]], 3 * i));
  const place = ([x, y]) => [(1.02 + x) / 2.04 * size, (1.02 - y) / 2.04 * size];
  const paths = chainsOf(segments).map((chain) => path(chain.map(place)));
  const numbers = sheets.length < 2 ? [] : sheets.map(({ source, place: p }) => {
    const [x, y] = place(p);
    return `\n<text x="${round(x)}" y="${round(y)}" fill="${colors.source}" font-family="sans-serif" font-size="24" text-anchor="middle" dominant-baseline="central">${source + 1}</text>`;
  });
  return document(size, size, `<path stroke="${colors.curve}" stroke-width="2" d="${paths.join('')}"/>${numbers.join('')}`);
}
