// GGX lobe of one roughness at v = n by importance sampling, for the sharp levels of the cube. Each sample reads the
// source level whose texel has the sample's solid angle.
// src: Heitz 2018, "Sampling the GGX Distribution of Visible Normals", at v = n; Krivanek & Colbert 2008, "Real-time
//      Shading with Filtered Importance Sampling"; sample count, bias and order of three r187
precision highp float;
precision highp int;
precision highp samplerCube;

#include "brdf/constants.glsl"

uniform samplerCube sourceMap;
uniform float perceptualRoughness;
uniform float lodBias;
in vec3 vDirection;
out vec4 fragmentColor;

// Van der Corput sequence in base 2, [0, 1).
float radicalInverse(uint bits) {
  bits = (bits << 16u) | (bits >> 16u);
  bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
  bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
  bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
  bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
  return float(bits) * 2.3283064365386963e-10;
}

void main() {
  vec3 n = normalize(vDirection);
  if (perceptualRoughness < 0.001) {
    fragmentColor = vec4(textureLod(sourceMap, n, 0.0).rgb, 1.0);
    return;
  }
  float alpha = perceptualRoughness * perceptualRoughness;
  float a2 = alpha * alpha;
  vec3 up = abs(n.z) < 0.999 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 t = normalize(cross(up, n));
  vec3 b = cross(n, t);
  vec3 sum = vec3(0.0);
  float weight = 0.0;
  for (uint i = 0u; i < uint(SAMPLES); ++i) {
    float x = float(i) / float(SAMPLES);
    float inverseQ = 1.0 / (1.0 - x + a2 * x);
    float NoL = (1.0 - x - a2 * x) * inverseQ;
    if (NoL > 0.0) {
      float phi = 2.0 * PI * radicalInverse(i);
      float sinTheta = 2.0 * alpha * sqrt(x * (1.0 - x)) * inverseQ;
      vec3 l = n * NoL + (t * cos(phi) + b * sin(phi)) * sinTheta;
      float lod = max(log2(a2 * inverseQ) + lodBias, 0.0);
      sum += textureLod(sourceMap, l, lod).rgb * NoL;
      weight += NoL;
    }
  }
  fragmentColor = vec4(sum / weight, 1.0);
}
