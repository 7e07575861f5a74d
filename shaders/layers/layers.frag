// What the nearest surface is at the centre of a pixel, without light: its place, its normal, its colour, whose it is, and
// how much of the lights' light something hides from it.
precision highp float;
precision highp int;

#define VARYING in

#include "octahedron.glsl"
#include "sampler_precision.glsl"
#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#include "shading/three_terms.glsl"
#if ALPHA_TO_COVERAGE || ENVIRONMENT_SAMPLES > 0 || FLAT_SHADOWS + CUBE_SHADOWS > 0
#include "pixel_noise.glsl"
#endif
#include "material/fragment_inputs.glsl"
#if !UNLIT
#include "shading/includes_common.glsl"
#if SHADING_THREE
#include "shading/includes_three.glsl"
#endif
#if SHADING_FABRIC
#include "shading/includes_fabric.glsl"
#endif
#if SHADING_PRINCIPLED
#include "shading/includes_principled.glsl"
#endif
#include "material/surface_info.glsl"
#endif
#include "material/base_color.glsl"
#if !UNLIT
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
#include "shadow/filter.glsl"
#endif
#include "light/punctual.glsl"
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
#include "layers/hidden.glsl"
#endif
#endif

uniform mat3 viewToWorld;
uniform vec2 layerIds;  // part, material

layout(location = 0) out vec4 layerPlace;   // shading normal, world space; metres along the view
layout(location = 1) out vec4 layerColor;   // base colour, linear Rec.709; part of the light that is hidden
layout(location = 2) out vec4 layerNumber;  // part, material; geometric normal, view space, x and y on an octahedron

void main() {
  vec4 baseColor = baseColorAndAlpha();
#if ALPHA_MASK
  if (baseColor.a < alphaCutoff) discard;
#elif !ALPHA_OPAQUE
  if (baseColor.a < 0.5) discard;
#endif
#if UNLIT
  vec3 normal = vec3(0.0, 0.0, 1.0);
  vec3 facing = normal;
  vec3 albedo = baseColor.rgb;
#else
  vec3 normal = surfaceInfo(baseColor.rgb).n;
  vec3 facing = cross(dFdx(vViewPosition), dFdy(vViewPosition));
  facing = dot(facing, facing) > 0.0 ? normalize(facing) : viewDirection();
  if (dot(facing, viewDirection()) < 0.0) facing = -facing;
  vec3 albedo = materialInputs(baseColor.rgb).baseColor;
#endif
  layerPlace = vec4(viewToWorld * normal, vViewPosition.z);
#if UNLIT || FLAT_SHADOWS + CUBE_SHADOWS == 0
  layerColor = vec4(albedo, 0.0);
#else
  layerColor = vec4(albedo, hiddenPart(facing));
#endif
  layerNumber = vec4(layerIds, octahedronPlace(facing));
}
