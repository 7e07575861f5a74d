// A level of an environment atlas from the one before: one of the two passes of a Gaussian blur on the sphere, around a pole or
// towards it. Directions turn in equal steps about an axis.
// src: a separable Gaussian, cut at three deviations; step, weights and order of three r150 to r180
precision mediump float;
precision mediump int;
#include "sampler_precision.glsl"

#include "environment/atlas.glsl"

#define TAPS 20  // a side at most, with the one in the middle

uniform sampler2D sourceAtlas;
uniform highp vec2 atlasTexel;
uniform float atlasMaxMip;
uniform float sourceMip;
uniform float tapWeight[TAPS];
uniform int tapCount;
uniform float tapStep;  // rad
uniform vec3 pole;      // not unit
uniform bool aroundPole;
in vec3 vDirection;
out highp vec4 fragmentColor;

vec3 turnAxis() {
  vec3 axis = aroundPole ? pole : cross(pole, vDirection);
  if (axis == vec3(0.0)) axis = vec3(vDirection.z, 0.0, -vDirection.x);
  return normalize(axis);
}

// The radiance in the direction that is turned by an angle.
vec3 radianceTurned(vec3 axis, float angle) {
  float cosine = cos(angle);
  vec3 turned = vDirection * cosine + cross(axis, vDirection) * sin(angle);
  turned = turned + axis * dot(axis, vDirection) * (1.0 - cosine);
  return atlasLevel(sourceAtlas, atlasTexel, atlasMaxMip, turned, sourceMip);
}

void main() {
  vec3 axis = turnAxis();
  highp vec3 sum = tapWeight[0] * radianceTurned(axis, 0.0);
  for (int tap = 1; tap < TAPS; ++tap) {
    if (tap >= tapCount) break;
    float angle = tapStep * float(tap);
    sum += tapWeight[tap] * radianceTurned(axis, -angle);
    sum += tapWeight[tap] * radianceTurned(axis, angle);
  }
  fragmentColor = vec4(sum, 1.0);
}
