// The environment as background, tone mapped like the model.
precision highp float;
precision highp samplerCube;

#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#if BLURRED
#include "brdf/environment.glsl"
#endif
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "output.glsl"

uniform samplerCube backgroundMap;  // sharp, or prefiltered where it is blurred
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
#if BLURRED
  vec3 radiance = textureLod(backgroundMap, direction, lodFromRoughness(backgroundBlur, backgroundMaxLod)).rgb;
#else
  vec3 radiance = texture(backgroundMap, direction).rgb;
#endif
  fragmentColor = outputColor(radiance * backgroundIntensity, 1.0);
}
