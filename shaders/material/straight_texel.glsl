// Straight colour and alpha of a texel that is premultiplied (texture/coverage_level.frag).
vec4 straightTexel(vec4 texel) { return vec4(texel.rgb / max(texel.a, 1.0 / 512.0), texel.a); }
