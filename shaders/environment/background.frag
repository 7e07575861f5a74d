// The environment as background, tone mapped like the model.
precision highp float;
precision highp samplerCube;

#include "brdf/constants.glsl"
#include "brdf/math.glsl"
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "output.glsl"

uniform samplerCube backgroundMap;
uniform mat3 backgroundRotation;  // world to environment
uniform float backgroundIntensity;
in vec3 vDirection;
out vec4 fragmentColor;

void main() {
  fragmentColor = outputColor(texture(backgroundMap, backgroundRotation * vDirection).rgb * backgroundIntensity, 1.0);
}
