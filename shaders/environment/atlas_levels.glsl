// Which level of an environment atlas (environment/atlas.glsl) stands for a roughness, and the read between two levels.
// src: three r150 to r186; the levels' widths are chosen after the GGX lobe

// On the line from (r, mip) = near to far.
float mipBetween(float r, vec2 near, vec2 far) {
  return (near.x - r) * (far.y - near.y) / (near.x - far.x) + near.y;
}

// perceptualRoughness  [0, 1]; 0 gives infinity
float atlasMip(float perceptualRoughness) {
  float r = perceptualRoughness;
  const vec2 A = vec2(1.0, ATLAS_MIP_ROUGHEST), B = vec2(0.8, -1.0), C = vec2(0.4, 2.0), D = vec2(0.305, 3.0), E = vec2(0.21, 4.0);
  if (r >= B.x) return mipBetween(r, A, B);
  if (r >= C.x) return mipBetween(r, B, C);
  if (r >= D.x) return mipBetween(r, C, D);
  if (r >= E.x) return mipBetween(r, D, E);
  return -2.0 * log2(1.16 * r);
}

// Linear between the two levels about a mip.
vec3 atlasRadiance(sampler2D atlas, vec2 texel, float maxMip, vec3 direction, float mip) {
  float level = clamp(mip, ATLAS_MIP_ROUGHEST, maxMip);
  float beyond = fract(level);
  vec3 rougher = atlasLevel(atlas, texel, maxMip, direction, floor(level));
  if (beyond == 0.0) return rougher;
  return mix(rougher, atlasLevel(atlas, texel, maxMip, direction, floor(level) + 1.0), beyond);
}
