// From scene radiance to what the framebuffer holds: the one place where colour is encoded.
uniform float exposure;

#include "tone_mappings.glsl"

// radiance  linear Rec.709, scene light      alpha  straight
// return    OUTPUT_LINEAR: radiance x exposure, capped to what a half holds; else tone mapped and sRGB-encoded
vec4 outputColor(vec3 radiance, float alpha) {
#if OUTPUT_LINEAR
  return vec4(clamp(radiance * exposure, 0.0, RADIANCE_MAX), saturate(alpha));
#else
  // What a thin film takes from one channel makes it negative at grazing angles; tone mapping shows that in all channels.
  return vec4(srgbFromLinear(toneMapped(mix(radiance, vec3(0.0), isnan(radiance)), exposure)), alpha);
#endif
}

// Of one of several passes, whose mean alone is light: one may be below 0. Linear, capped to what a half holds.
vec4 outputOfPass(vec3 radiance, float alpha) {
  radiance = mix(radiance * exposure, vec3(0.0), isnan(radiance));
  return vec4(clamp(radiance, -RADIANCE_MAX, RADIANCE_MAX), saturate(alpha));
}
