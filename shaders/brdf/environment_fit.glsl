// The split sum without a table: draft quality. Shared text: see README.md.

// (A, B) of the split sum, as the table holds them, each about [0, 1]; up to 0.4 off it for rough metals.
// src: Karis 2014, "Physically Based Shading on Mobile", Unreal Engine 4
vec2 dfgKaris(float perceptualRoughness, float NoV) {
  vec4 r = perceptualRoughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a004 = min(pow2(r.x), exp2(-9.28 * NoV)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a004 + vec2(r.z, r.w);
}

// The same of an earlier game: gloss is 1 - perceptualRoughness.
// src: Lazarov 2013, "Getting More Physical in Call of Duty: Black Ops II", listing of section 7
vec2 dfgLazarov(float perceptualRoughness, float NoV) {
  float gloss = 1.0 - perceptualRoughness;
  vec4 t = gloss * vec4(1.0 / 0.96, 0.475, (0.0275 - 0.25 * 0.04) / 0.96, 0.25) +
           vec4(0.0, 0.0, (0.015 - 0.75 * 0.04) / 0.96, 0.75);
  float atBlack = saturate(t.x * min(t.y, exp2(-9.28 * NoV)) + t.z);
  return vec2(saturate(t.w) - atBlack, atBlack);
}
