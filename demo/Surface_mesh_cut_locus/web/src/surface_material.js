// How the surface looks: isolines of the distance, the Laplacian, the injectivity disk and a checker texture, each of
// which can be switched on, are computed for each pixel from attributes of the vertices.
import * as THREE from 'three';

const vertexShader = `
attribute float geodesicDistance;
attribute float distanceLaplacian;
varying float vDistance;
varying float vLaplacian;
varying vec3 vNormal;
varying vec2 vUv;
uniform bool isAtlas;

void main() {
  vDistance = geodesicDistance;
  vLaplacian = distanceLaplacian;
  vNormal = normalMatrix * normal;
  vUv = uv;
  vec3 place = isAtlas ? vec3(uv, 0.) : position;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.);
}`;

const fragmentShader = `
varying float vDistance;
varying float vLaplacian;
varying vec3 vNormal;
varying vec2 vUv;
uniform bool isAtlas;
uniform bool showIsolines;
uniform bool showLaplacian;
uniform bool showDisk;
uniform bool showChecker;
uniform float spacing;
uniform float radius;
uniform float laplacianScale;
uniform float checkers;

// blue below zero, where the cut locus is, over white to brown
vec3 diverging(float t) {
  vec3 low = vec3(.10, .28, .62), middle = vec3(.95), high = vec3(.65, .38, .12);
  return t < 0. ? mix(middle, low, min(-t, 1.)) : mix(middle, high, min(t, 1.));
}

void main() {
  vec3 color = vec3(.80, .82, .84);
  bool isReached = vDistance >= 0.;
  if(showLaplacian && isReached)
    color = diverging(vLaplacian / laplacianScale);
  if(showChecker) {
    vec2 square = floor(vUv * checkers);
    color *= mod(square.x + square.y, 2.) < .5 ? .72 : 1.;
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
    float line = (1. - smoothstep(.6 * width, 1.4 * width, off)) * (1. - smoothstep(.3, .8, width));
    color = mix(color, vec3(.25, .30, .38), .75 * line);
  }
  if(!isAtlas) {
    vec3 n = normalize(gl_FrontFacing ? vNormal : -vNormal);
    float light = .35 + .65 * abs(dot(n, normalize(vec3(.25, .35, 1.))));
    color *= gl_FrontFacing ? light : .75 * light;
  }
  gl_FragColor = vec4(color, 1.);
}`;

export function makeSurfaceMaterial(isAtlas = false) {
  return new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: THREE.DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: {
      isAtlas: { value: isAtlas },
      showIsolines: { value: true },
      showLaplacian: { value: false },
      showDisk: { value: false },
      showChecker: { value: false },
      spacing: { value: 0.1 },
      radius: { value: 0 },
      laplacianScale: { value: 1 },
      checkers: { value: 20 },
    },
  });
}
