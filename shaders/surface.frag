// Metallic-roughness material under punctual and indirect light, as three.js 0.187's MeshStandardMaterial shades it;
// with UNLIT as its MeshBasicMaterial.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp samplerCube;

#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#include "brdf/tone_mapping.glsl"
#include "brdf/color.glsl"
#include "output.glsl"
#include "material/fragment_inputs.glsl"
#if !UNLIT
#include "brdf/roughness.glsl"
#include "brdf/distribution.glsl"
#include "brdf/visibility.glsl"
#include "brdf/fresnel.glsl"
#include "brdf/specular.glsl"
#include "brdf/diffuse.glsl"
#include "brdf/multiscatter.glsl"
#include "brdf/light.glsl"
#include "brdf/occlusion.glsl"
#include "brdf/environment.glsl"
#include "material/normal.glsl"
#endif
#include "material/surface_info.glsl"
#if !UNLIT
#include "light/punctual.glsl"
#include "light/indirect.glsl"
#endif

out vec4 fragmentColor;

void main() {
  vec4 baseColor = baseColorAndAlpha();
#if ALPHA_MASK
  if (baseColor.a < alphaCutoff) discard;
#endif
#if ALPHA_OPAQUE
  baseColor.a = 1.0;
#endif
#if UNLIT
  vec3 radiance = baseColor.rgb;
#else
  SurfaceInfo s = surfaceInfo(baseColor.rgb);
  Reflected indirect = indirectLight(s);
#if OCCLUSION_MAP
  float occlusion = diffuseOcclusion(texture(occlusionMap, vOcclusionUv).r, occlusionStrength);
  indirect.diffuse *= occlusion;
#if ENVIRONMENT
  indirect.specular *= specularOcclusion(s.perceptualRoughness, occlusion, s.NoV);
#endif
#endif
#if POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS > 0
  Reflected direct = punctualLight(s);
  vec3 radiance = (direct.diffuse + indirect.diffuse) + (direct.specular + indirect.specular);
#else
  vec3 radiance = indirect.diffuse + indirect.specular;
#endif
#if EMISSIVE
  radiance += emittedRadiance();
#endif
#endif
  fragmentColor = outputColor(radiance, baseColor.a);
}
