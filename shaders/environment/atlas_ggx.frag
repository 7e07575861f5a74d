// A level of an environment atlas from the one before, under a GGX lobe; with roughness 0 the level that it reads, as its own
// faces have it: a border becomes what the faces beside it hold.
// src: Heitz 2018, "Sampling the GGX Distribution of Visible Normals", for a viewer along the normal, weighted by NoL after
//      Karis 2013; read at one level, as three r181 to r186 do
precision highp float;
precision highp int;
precision highp sampler2D;

#include "brdf/constants.glsl"
#include "environment/atlas.glsl"
#include "environment/ggx_samples.glsl"

uniform sampler2D sourceAtlas;
uniform vec2 atlasTexel;
uniform float atlasMaxMip;
uniform float sourceMip;
uniform float perceptualRoughness;
in vec3 vDirection;
out vec4 fragmentColor;

const float MIRROR_ROUGHNESS_MAX = 0.001;

vec3 sourceRadiance(vec3 direction) { return atlasLevel(sourceAtlas, atlasTexel, atlasMaxMip, direction, sourceMip); }

// Half vector about (0, 0, 1): a point of the disk, lifted to the hemisphere and stretched.
vec3 visibleNormal(vec2 u, float alpha) {
  float phi = 2.0 * PI * u.y;
  vec2 disk = sqrt(u.x) * vec2(cos(phi), sin(phi));
  float up = sqrt(max(0.0, 1.0 - disk.x * disk.x - disk.y * disk.y));
  return normalize(vec3(alpha * disk, up));
}

vec3 reflectedRadiance(vec3 n, float alpha) {
  mat2x3 across = axesAcross(n);
  vec4 sum = vec4(0.0);  // weighted radiance, weights
  for (int i = 0; i < SAMPLES; ++i) {
    vec3 m = visibleNormal(hammersley(i), alpha);
    vec3 h = normalize(across[0] * m.x + across[1] * m.y + n * m.z);
    vec3 l = normalize(2.0 * dot(n, h) * h - n);
    float NoL = dot(n, l);
    if (NoL > 0.0) sum += vec4(sourceRadiance(l) * NoL, NoL);
  }
  return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
}

void main() {
  vec3 n = normalize(vDirection);
  bool mirror = perceptualRoughness < MIRROR_ROUGHNESS_MAX;
  fragmentColor = vec4(mirror ? sourceRadiance(n) : reflectedRadiance(n, perceptualRoughness * perceptualRoughness), 1.0);
}
