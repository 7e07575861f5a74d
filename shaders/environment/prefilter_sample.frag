// What a GGX mirror of one roughness reflects to a viewer along its normal, by importance sampling: for the sharp levels of
// the cube. A sample reads the level of the source whose texel covers the solid angle that it stands for.
// src: Karis 2013, "Real Shading in Unreal Engine 4", the first half of the split sum, weighted by NoL; Heitz 2018, "Sampling
//      the GGX Distribution of Visible Normals"; Krivanek & Colbert 2008, "Real-time Shading with Filtered Importance
//      Sampling". Point set, its turn about the normal and the lod's bias are those of three r187: the same cube comes out.
precision highp float;
precision highp int;
precision highp samplerCube;

#include "brdf/constants.glsl"
#include "environment/ggx_samples.glsl"

uniform samplerCube sourceMap;
uniform float perceptualRoughness;
uniform float lodBias;    // renderer/ibl/prefilter.cpp
uniform float mirrorLod;  // level of the source that is as large as the sharpest one of the cube
in vec3 vDirection;
out vec4 fragmentColor;

// Radiance that a GGX mirror reflects along n.
// For v = n, Heitz draws the microfacet normal m = (alpha sqrt(u.x) e(phi), sqrt(1 - u.x)) / sqrt(q) with
// q = alpha^2 u.x + 1 - u.x. The reflection l lies at twice the angle of m. Its density is q^2 / (4 PI alpha^2), and so the
// level of the source grows with log2(1 / q).
vec3 reflectedRadiance(vec3 n, float alpha) {
  float alpha2 = alpha * alpha;
  mat2x3 across = axesAcross(n);
  vec3 radiance = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec2 u = hammersley(i);
    float cos2 = 1.0 - u.x;       // q times the squared cosine of m's angle
    float sin2 = alpha2 * u.x;    // q times its squared sine
    float perQ = 1.0 / (cos2 + sin2);
    float NoL = (cos2 - sin2) * perQ;
    if (NoL <= 0.0) continue;
    float sinTheta = 2.0 * alpha * sqrt(u.x * cos2) * perQ;
    float phi = 2.0 * PI * u.y;
    vec3 l = n * NoL + across * vec2(cos(phi), sin(phi)) * sinTheta;
    radiance += textureLod(sourceMap, l, max(log2(alpha2 * perQ) + lodBias, 0.0)).rgb * NoL;
    weights += NoL;
  }
  return radiance / weights;
}

void main() {
  vec3 n = normalize(vDirection);
  bool mirror = perceptualRoughness == 0.0;
  vec3 radiance = mirror ? textureLod(sourceMap, n, mirrorLod).rgb : reflectedRadiance(n, perceptualRoughness * perceptualRoughness);
  fragmentColor = vec4(radiance, 1.0);
}
