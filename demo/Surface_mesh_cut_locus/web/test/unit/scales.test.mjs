// Colors and what they stand for.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { branchScale } from '../../src/branch_scale.js';
import { branchColor, cellColor, cssColor, distanceColors, laplacianColor, stops } from '../../src/color_maps.js';
import { maps } from '../../src/state.js';

const luminance = ([r, g, b]) => 0.2126 * r ** 2.2 + 0.7152 * g ** 2.2 + 0.0722 * b ** 2.2;
const steps = Array.from({ length: 101 }, (_, i) => i / 100);

test('colors are colors', () => {
  for (const colorAt of [...Object.values(distanceColors), branchColor, laplacianColor])
    for (const t of steps) assert.ok(colorAt(t).every((x) => x >= 0 && x <= 1), `${colorAt.name} ${t}`);
  assert.equal(cssColor([0, 0.5, 1]), 'rgb(0 128 255)');
  assert.equal(stops(branchColor, 4).length, 4);
});

test('distances and branches are told by their lightness alone, which sinks', () => {
  for (const colorAt of [...Object.values(distanceColors), branchColor])
    for (const t of steps.slice(1)) assert.ok(luminance(colorAt(t)) < luminance(colorAt(t - 0.01)) + 1e-3, `${colorAt.name} ${t}`);
});

test('the Laplacian is blue below zero, brown above, and lightest there', () => {
  const [low, zero, high] = [0, 0.5, 1].map(laplacianColor);
  assert.ok(low[2] > low[0] && high[0] > high[2]);
  assert.ok(luminance(zero) > luminance(low) && luminance(zero) > luminance(high));
});

test('every scale of colors of distances has a name that links know', () => {
  assert.deepEqual(Object.keys(distanceColors), maps);
});

test('twelve sources have twelve colors', () => {
  assert.equal(new Set(Array.from({ length: 12 }, (_, i) => cellColor(i).join())).size, 12);
  assert.deepEqual(cellColor(13), cellColor(1));
});

test('places on the scale of the branches are in the order of their numbers', () => {
  for (const [method, values] of [['default', [0, 0.001, 0.005, 0.05, 0.5, 1]], ['laplacian', [0, 1, 2, 3.1]]]) {
    const { place } = branchScale({ method });
    values.slice(1).forEach((value, i) => assert.ok(place(value) > place(values[i]), `${method} ${value}`));
  }
  assert.ok(Math.abs(branchScale({ method: 'default' }).place(0.005)) < 1e-12);
  assert.ok(Math.abs(branchScale({ method: 'laplacian' }).place(Math.PI) - 1) < 1e-12);
});
