// From scene radiance to what the framebuffer holds: the one place where colour is encoded.
uniform float exposure;

#include "tone_mappings.glsl"
#if THREE_NEUTRAL_TONE_MAPPING_TERM == THREE_NEUTRAL_TONE_MAPPING_WHITE
#include "brdf/neutral_white.glsl"
#endif

vec3 displayLight(vec3 radiance) {
#if THREE_NEUTRAL_TONE_MAPPING_TERM == THREE_NEUTRAL_TONE_MAPPING_WHITE && TONE_MAPPING == TONE_MAPPING_NEUTRAL
  return toneMapNeutralWhite(radiance, exposure);
#else
  return toneMapped(radiance, exposure);
#endif
}

// radiance  linear Rec.709, scene light      alpha  straight
// return    OUTPUT_LINEAR: radiance x exposure, capped to what a half holds; else tone mapped and sRGB-encoded
vec4 outputColor(vec3 radiance, float alpha) {
#if OUTPUT_LINEAR
  return vec4(clamp(radiance * exposure, 0.0, RADIANCE_MAX), saturate(alpha));
#else
  // What a thin film takes from one channel makes it negative at grazing angles; tone mapping shows that in all channels.
  return vec4(srgbFromLinear(displayLight(mix(radiance, vec3(0.0), isnan(radiance)))), alpha);
#endif
}

// Of one of several passes, whose mean alone is light: one may be below 0. Linear, capped to what a half holds.
vec4 outputOfPass(vec3 radiance, float alpha) {
  radiance = mix(radiance * exposure, vec3(0.0), isnan(radiance));
  return vec4(clamp(radiance, -RADIANCE_MAX, RADIANCE_MAX), saturate(alpha));
}
