// Metallic-roughness material and the layers of KHR_materials_* under punctual and indirect light, as three.js's
// MeshStandardMaterial and MeshPhysicalMaterial shade them; with UNLIT as its MeshBasicMaterial.
#if ALPHA_TO_COVERAGE && SAMPLE_MASK
#extension GL_OES_sample_variables : require
#endif
precision highp float;
precision highp int;

#if VISIBILITY_BUFFER
#define VARYING
#else
#define VARYING in
#endif

#include "sampler_precision.glsl"

#if FULL_DETAIL
// Several passes over the picture filter what is shaded, not the maps: cloth is darker and softer than its mean normals are.
#if OWN_PLACES
vec2 placeInCell(vec2 uv);
#define texture(map, at) texture(map, placeInCell(at), -16.0)
#else
#define texture(map, at) texture(map, at, -16.0)
#endif
#endif

#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "shading/three_terms.glsl"
#include "output.glsl"
#if ALPHA_TO_COVERAGE || ENVIRONMENT_SAMPLES > 0 || FLAT_SHADOWS + CUBE_SHADOWS > 0 || OWN_PLACES
#include "pixel_noise.glsl"
#endif
#include "material/fragment_inputs.glsl"
#if OWN_PLACES
#include "material/place_in_cell.glsl"
#endif
#if !UNLIT
#include "shading/includes_common.glsl"
#if ENVIRONMENT_SAMPLES > 0
#include "brdf/importance.glsl"
#endif
#if TRANSMISSION
#include "brdf/transmission.glsl"
#endif
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
#if OWN_PLACES
#undef texture
#define texture(map, at) texture(map, at, -16.0)
#endif
#if !UNLIT
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
#include "shadow/filter.glsl"
#endif
#include "light/punctual.glsl"
#include "light/area.glsl"
#include "light/indirect.glsl"
#include "light/occluded.glsl"
#if TRANSMISSION
#include "light/transmission.glsl"
#endif
#endif
#if ALPHA_TO_COVERAGE
#include "material/coverage.glsl"
#endif
#if DEBUG_OUTPUT
#include "debug_output.glsl"
#endif

out vec4 fragmentColor;

void main() {
#if VISIBILITY_BUFFER
  readVaryings();
#endif
  vec4 baseColor = baseColorAndAlpha();
#if ALPHA_TO_COVERAGE
#if VERTEX_COLOR
  baseColor.a = coverSamples(vColor.a);
#else
  baseColor.a = coverSamples(1.0);
#endif
#elif ALPHA_MASK
  if (baseColor.a < alphaCutoff) discard;
#endif
#if ALPHA_OPAQUE && !ALPHA_TO_COVERAGE
  baseColor.a = 1.0;
#endif
#if UNLIT
  vec3 radiance = baseColor.rgb;
#else
  SurfaceInfo s = surfaceInfo(baseColor.rgb);
  Reflected direct = nothingReflected();
  Reflected suns = nothingReflected();
#if POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS > 0
  direct = punctualLight(s);
#if SUNS > 0
  suns = sunLight(s);
#endif
#if FACETS
  addFacetLight(direct, suns, s);
#endif
#endif
  Incident incident = incidentLight(s);
  Reflected indirect = indirectLight(s, incident, suns);
#if OCCLUSION_MAP
  indirect = occluded(indirect, s);
#endif
#if RECT_LIGHTS + DISK_LIGHTS > 0
  direct = addAreaLight(direct, s);
#endif
  vec3 diffuse = direct.diffuse + indirect.diffuse;
#if TRANSMISSION
  vec4 transmitted = transmittedLight(s);
  float transmission = transmissionWeight();
  diffuse = mix(diffuse, vec3(transmitted), transmission);
#if THREE_GLASS_ALPHA_TERM == THREE_GLASS_ALPHA_ADDED_TENTH
  baseColor.a *= glassOpacityWithTenth(transmitted.a, transmission);
#else
  baseColor.a *= mix(1.0, transmitted.a, transmission);
#endif
#endif
#if EMISSIVE
  vec3 emitted = emittedRadiance();
#else
  vec3 emitted = vec3(0.0);
#endif
  vec3 radiance = composedRadiance(s, diffuse, direct, indirect, emitted);
#endif
#if DEBUG_OUTPUT
  fragmentColor = debugColor(baseColor, radiance);
#if !UNLIT
  fragmentColor += debugShading(s, incident, direct, indirect);
#endif
#if TRANSMISSION
  fragmentColor += debugTransmitted(transmitted);
#endif
#elif FULL_DETAIL
  fragmentColor = outputOfPass(radiance, baseColor.a);
#else
  fragmentColor = outputColor(radiance, baseColor.a);
#endif
}
