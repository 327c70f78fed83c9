import assert from 'node:assert/strict';
import { test } from 'node:test';
import { clips, defaultState, fromHash, maps, parameterizations, toHash } from '../../src/state.js';
import { generator } from './random.mjs';

const number = (next, low, high) => Number((low + next() * (high - low)).toPrecision(4));

function anyState({ next, pick }) {
  const state = defaultState();
  if (next() < 0.3) Object.assign(state, { sample: null, file: pick(['a.off', 'ä & b=1.ply', '100 %.obj']) });
  else Object.assign(state, { sample: pick(['torus', 'capsule']), faces: pick([100, 5000, 400000]) });
  if (next() < 0.7)
    state.sources = Array.from({ length: 1 + Math.floor(3 * next()) }, () =>
      ({ face: Math.floor(1e5 * next()), coordinates: [0, 1, 2].map(() => number(next, 0, 1)) }));
  state.border = pick(['no', 'also', 'only']);
  state.solver = pick(['exact', 'heat', 'graph']);
  state.method = state.solver === 'exact' ? pick(['default', 'polyhedral', 'laplacian']) : 'laplacian';
  const { parameters, show, look } = state;
  if (next() < 0.5) parameters.width = number(next, 0, 100);
  if (next() < 0.5) parameters.angle = number(next, 0, 3);
  if (next() < 0.5) parameters.laplacian = number(next, -5, 5);
  parameters.keep = pick(['all', 'voronoi', 'medial']);
  parameters.policy = pick(['prune', 'grow']);
  for (const name of Object.keys(show)) if (next() < 0.3) show[name] = !show[name];
  look.color = pick(['plain', 'distance', 'cells', 'laplacian']);
  look.up = pick(['auto', 'y', 'z']);
  look.projection = pick(['perspective', 'orthographic']);
  look.map = pick(maps);
  look.clip = pick(clips);
  look.clipAt = pick([0, 0.37, 1]);
  look.lineWidth = pick([0.5, 1, 2.4]);
  for (const name of ['wireframe', 'occlusion', 'axes']) look[name] = pick([true, false]);
  look.transparency = pick([0, 0.3, 0.9]);
  state.isCut = pick([true, false]);
  state.parameterization = pick(parameterizations);
  state.isEmbedded = pick([true, false]);
  if (next() < 0.5) state.view = [0, 1, 2, 3, 4, 5].map(() => number(next, -3, 3));
  return state;
}

test('a link restores any state', () => {
  const random = generator(47);
  for (let i = 0; i < 500; ++i) {
    const state = anyState(random);
    if (state.file) delete state.faces; // that of a sample
    const { state: read, ignored } = fromHash(toHash(state));
    if (state.file) delete read.faces;
    assert.deepEqual(read, state, toHash(state));
    assert.deepEqual(ignored, []);
  }
});

test('a link of before is read', () => {
  assert.deepEqual(fromHash('#method=direction'), { state: defaultState(), ignored: [] });
});

test('what makes no sense in a link is as by default, and named', () => {
  const standard = defaultState();
  const wrong = {
    show: ['toString', '__proto__', 'constructor,isolines', 'hasOwnProperty'],
    source: ['0,0,0,0', '0,1,0', 'a,b,c,d', '-1,1,0,0', '0.5,1,0,0', '0,-1,1,1', ',,,', '0,1,0,0,3', 'Infinity,1,0,0'],
    border: ['both', 'toString'],
    solver: ['constructor', ''],
    method: ['__proto__', 'fast'],
    faces: ['0', '1e9', 'many', ''],
    width: ['-1', 'NaN', '200', ''],
    angle: ['9', 'x'],
    view: ['0,0,0,0,0,0', '1,2,3', 'a,b,c,d,e,f'],
    transparency: ['1', '-0.1', 'none'],
    projection: ['flat'],
    map: ['toString', 'jet'],
    clip: ['w', 'constructor'],
    clipAt: ['2', ''],
    lineWidth: ['0', '100'],
    color: ['valueOf'],
    cut: ['yes'],
    file: [''],
    sample: [''],
    toString: ['1'],
    constructor: ['prototype'],
    strength: ['7'],
  };
  for (const [name, texts] of Object.entries(wrong))
    for (const text of texts) {
      const { state, ignored } = fromHash(`#${name}=${text}`);
      assert.deepEqual(ignored, [name], `${name}=${text}`);
      assert.deepEqual(Object.keys(state.show), Object.keys(standard.show));
      if (text !== 'constructor,isolines') assert.deepEqual(state, standard, `${name}=${text}`);
    }
});

test('no text makes reading a link fail', () => {
  const { next, pick } = generator(1);
  const pieces = ['#', '&', '=', ',', '-', '%', '%2C', '%ZZ', 'show', 'source', 'view', 'toString', '__proto__', '0', '1e999', 'NaN', ' '];
  for (let i = 0; i < 3000; ++i) {
    const text = Array.from({ length: Math.floor(12 * next()) }, () => pick(pieces)).join('');
    const { state } = fromHash(`#${text}`);
    assert.equal(typeof state.show.isolines, 'boolean');
    assert.doesNotThrow(() => toHash(state));
  }
});
