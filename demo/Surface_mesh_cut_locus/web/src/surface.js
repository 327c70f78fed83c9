// The surface as it is drawn: its colors, lines of equal distance, the injectivity disk and a checker texture are
// computed for each pixel from attributes of the vertices.
import * as THREE from 'three';
import { distanceColors, laplacianColor, makeTexture } from './color_maps.js';

const vertexShader = `
attribute float geodesicDistance;
attribute float distanceLaplacian;
attribute vec3 cellColor;
varying float vDistance;
varying float vLaplacian;
varying vec3 vCell;
varying vec3 vNormal;
varying vec3 vPlace;
varying vec2 vUv;
uniform bool isAtlas;
#include <clipping_planes_pars_vertex>

void main() {
  vCell = cellColor;
  vDistance = geodesicDistance;
  vLaplacian = distanceLaplacian;
  vNormal = normalMatrix * normal;
  vUv = uv;
  vec4 mvPosition = modelViewMatrix * vec4(isAtlas ? vec3(uv, 0.) : position, 1.);
  vPlace = mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
#include <clipping_planes_vertex>
}`;

const fragmentShader = `
varying float vDistance;
varying float vLaplacian;
varying vec3 vCell;
varying vec3 vNormal;
varying vec3 vPlace;
varying vec2 vUv;
uniform bool isAtlas;
uniform bool isFlat;
uniform float front; // how far a wave has come, or less than 0 if there is none
uniform vec3 wave;
uniform bool showIsolines;
uniform bool showDisk;
uniform bool showChecker;
uniform int coloring; // 0: plain, 1: distance, 2: Laplacian, 3: nearest source
uniform vec3 plain;
uniform float spacing;
uniform float radius;
uniform float largest;
uniform float laplacianScale;
uniform float checkers;
uniform float opacity;
uniform sampler2D distanceMap;
uniform sampler2D laplacianMap;
#include <clipping_planes_pars_fragment>

void main() {
#include <clipping_planes_fragment>
  vec3 color = plain;
  bool isReached = vDistance >= 0. && (front < 0. || vDistance <= front);
  if(coloring == 1 && isReached)
    color = texture2D(distanceMap, vec2(vDistance / largest, .5)).rgb;
  if(coloring == 2 && isReached)
    color = texture2D(laplacianMap, vec2(.5 + .5 * vLaplacian / laplacianScale, .5)).rgb;
  if(coloring == 3 && isReached)
    color = vCell;
  if(showChecker) {
    vec2 square = floor(vUv * checkers);
    color *= mod(square.x + square.y, 2.) < .5 ? .82 : 1.;
  }
  if(showDisk && isReached) {
    float width = fwidth(vDistance);
    color = mix(color, vec3(.45, .76, .47), .6 * (1. - smoothstep(-width, width, vDistance - radius)));
    color = mix(color, vec3(.05, .40, .12), 1. - smoothstep(width, 2. * width, abs(vDistance - radius)));
  }
  if(showIsolines && isReached) {
    float level = vDistance / spacing, width = fwidth(level);
    float off = abs(fract(level - .5) - .5);
    // where lines are closer than pixels they fade into their mean
    float line = (1. - smoothstep(.3 * width, width, off)) * (1. - smoothstep(.3, .8, width));
    color *= 1. - .22 * line;
  }
  if(front >= 0. && vDistance >= 0.) {
    float behind = (front - vDistance) / largest;
    color = mix(color, wave, behind < 0. ? 0. : .25 * exp(-3. * behind) + .65 * exp(-60. * behind));
  }
  if(!isAtlas) {
    vec3 n = isFlat ? cross(dFdx(vPlace), dFdy(vPlace)) : (gl_FrontFacing ? vNormal : -vNormal);
    n = normalize(n);
    float sky = .5 + .5 * dot(n, normalize(vec3(0., .8, .6)));
    float light = .34 + .2 * sky + .28 * max(dot(n, normalize(vec3(-.45, .5, .9))), 0.) + .22 * max(n.z, 0.);
    color *= gl_FrontFacing ? light : .9 * light;
  }
  gl_FragColor = vec4(color * opacity, opacity); // premultiplied
}`;

const colorings = ['plain', 'distance', 'laplacian', 'cells'];

const textures = {}; // of the scales that have been shown

function makeUniforms(isAtlas) {
  return {
    isAtlas: { value: isAtlas },
    isFlat: { value: false },
    showIsolines: { value: true },
    showDisk: { value: false },
    showChecker: { value: false },
    coloring: { value: 0 },
    plain: { value: new THREE.Vector3(0.8, 0.8, 0.8) },
    front: { value: -1 },
    wave: { value: new THREE.Vector3() },
    spacing: { value: 0.1 },
    radius: { value: 0 },
    largest: { value: 1 },
    laplacianScale: { value: 1 },
    checkers: { value: 20 },
    opacity: { value: 1 },
    distanceMap: { value: null },
    laplacianMap: { value: makeTexture(laplacianColor) },
  };
}

export class Surface {
  constructor(isAtlas = false) {
    this.uniforms = makeUniforms(isAtlas);
    const material = (options) => new THREE.ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: this.uniforms,
      clipping: true,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
      ...options,
    });
    const blended = { transparent: true, premultipliedAlpha: true, blending: THREE.NormalBlending };
    const mesh = (options, order) => {
      const result = new THREE.Mesh(new THREE.BufferGeometry(), material(options));
      result.renderOrder = order;
      result.frustumCulled = false;
      return result;
    };
    this.opaque = mesh({ side: THREE.DoubleSide }, 0);
    // Seen through: one layer of backs and above it one of fronts, whatever is between them.
    this.layers = [
      mesh({ side: THREE.BackSide, ...blended }, 0),
      mesh({ side: THREE.FrontSide, ...blended, colorWrite: false }, 1),
      mesh({ side: THREE.FrontSide, ...blended }, 2),
    ];
    this.object = new THREE.Group();
    this.meshes = [this.opaque, ...this.layers];
    this.object.add(...this.meshes);
    this.setOpacity(1);
  }

  setGeometry(geometry) {
    for (const mesh of this.meshes) mesh.geometry = geometry;
  }

  // The scale of colors of distances.
  setMap(name) {
    textures[name] ||= makeTexture(distanceColors[name]);
    return this.setUniforms({ distanceMap: textures[name] });
  }

  get materials() {
    return this.meshes.map(({ material }) => material);
  }

  setOpacity(opacity) {
    this.uniforms.opacity.value = opacity;
    this.opaque.visible = opacity >= 1;
    for (const layer of this.layers) layer.visible = opacity < 1;
  }

  // true if something has changed
  setUniforms(values) {
    let isChanged = false;
    for (const [name, given] of Object.entries(values)) {
      const value = name === 'coloring' ? colorings.indexOf(given) : given;
      if (this.uniforms[name].value === value) continue;
      this.uniforms[name].value = value;
      isChanged = true;
    }
    return isChanged;
  }
}
