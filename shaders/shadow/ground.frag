// Black, as opaque as the ground lies in shadow: ShadowMaterial of three.js 0.187.
precision highp float;
precision highp int;

#define VARYING in

#include "sampler_precision.glsl"
#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "shading/three_terms.glsl"
#include "output.glsl"
#include "pixel_noise.glsl"

vec2 pixelCentre() { return gl_FragCoord.xy; }

#include "shadow/filter.glsl"

uniform float opacity;

out vec4 fragmentColor;

void main() {
  float visible = 1.0;
#repeat FLAT_SHADOWS
  visible *= flatShadowVisibility(INDEX);
#end
#repeat CUBE_SHADOWS
  visible *= cubeShadowVisibility(INDEX);
#end
  fragmentColor = outputColor(vec3(0.0), opacity * (1.0 - visible));
}
