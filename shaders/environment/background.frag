// The environment as background, tone mapped like the model.
precision highp float;
#include "sampler_precision.glsl"
#define ATLAS (BLURRED && THREE_PREFILTER_TERM != THREE_PREFILTER_CUBE)
#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#if ATLAS
#include "environment/atlas.glsl"
#include "environment/atlas_levels.glsl"
#elif BLURRED
#include "brdf/environment.glsl"
#endif
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "output.glsl"

#if ATLAS
uniform sampler2D backgroundMap;    // prefiltered
uniform vec2 backgroundTexel;       // 1 / its size
#else
uniform samplerCube backgroundMap;  // sharp, or prefiltered where it is blurred
#endif
#if BLURRED
uniform float backgroundBlur;       // a perceptual roughness
uniform float backgroundMaxLod;
#endif
uniform mat3 backgroundRotation;  // world to environment
uniform float backgroundIntensity;
in vec3 vDirection;
out vec4 fragmentColor;

void main() {
  vec3 direction = backgroundRotation * vDirection;
#if ATLAS
  vec3 radiance = atlasRadiance(backgroundMap, backgroundTexel, backgroundMaxLod, direction, atlasMip(backgroundBlur));
#elif BLURRED
  vec3 radiance = textureLod(backgroundMap, direction, lodFromRoughness(backgroundBlur, backgroundMaxLod)).rgb;
#else
  vec3 radiance = texture(backgroundMap, direction).rgb;
#endif
  fragmentColor = outputColor(radiance * backgroundIntensity, 1.0);
}
