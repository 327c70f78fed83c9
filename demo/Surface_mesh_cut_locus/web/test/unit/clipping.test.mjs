import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { Clipping } from '../../src/clipping.js';
import { clips } from '../../src/state.js';
import { generator } from './random.mjs';

const box = new THREE.Box3(new THREE.Vector3(-1, -2, -3), new THREE.Vector3(1, 2, 3));

test('a part of a box is kept', () => {
  const clipping = new Clipping();
  assert.ok(!clipping.set('no', 0.5, box) && clipping.keeps(new THREE.Vector3(5, 5, 5)));
  assert.ok(clipping.set('x', 0.25, box), 'there is a plane now');
  assert.ok(clipping.keeps(new THREE.Vector3(-0.6, 0, 0)) && !clipping.keeps(new THREE.Vector3(-0.4, 0, 0)));
  assert.ok(!clipping.set('-z', 0.5, box), 'another plane is as many');
  assert.ok(clipping.keeps(new THREE.Vector3(1, 1, 0.1)) && !clipping.keeps(new THREE.Vector3(0, 0, -0.1)));
  assert.ok(clipping.set('no', 0.5, box));
});

test('a point on a ray is within its limits if it is kept', () => {
  const { next, pick } = generator(17);
  const clipping = new Clipping();
  const raycaster = new THREE.Raycaster();
  const any = () => new THREE.Vector3(4 * next() - 2, 4 * next() - 2, 4 * next() - 2);
  for (let i = 0; i < 2000; ++i) {
    clipping.set(pick(clips), next(), box);
    raycaster.ray.set(any(), any().normalize());
    clipping.limit(raycaster);
    const t = 5 * next();
    const isWithin = t >= raycaster.near && t <= raycaster.far;
    assert.equal(isWithin, clipping.keeps(raycaster.ray.at(t, new THREE.Vector3())));
  }
});
