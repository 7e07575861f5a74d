// main() of a MeshPhysicalMaterial whose surface is shaded by telar's text. <...> are chunks of three.js; the place of
// TELAR_LIGHT_LOOPS takes its loops over the lights, which call RE_Direct for each.
void main() {
  vec4 diffuseColor = vec4(diffuse, opacity);
  vec3 totalEmissiveRadiance = emissive;
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#if ALPHA_TO_COVERAGE
#if defined(USE_COLOR_ALPHA)
  float telarAlpha = coverSamples(vColor.a);
#else
  float telarAlpha = coverSamples(1.0);
#endif
  diffuseColor *= texture(coverageMap, vMapUv);
#elif ALPHA_MEANS
  diffuseColor *= straightTexel(texture(coverageMap, vMapUv));
#else
#include <map_fragment>
#endif
#include <color_fragment>
#include <alphamap_fragment>
#if !ALPHA_TO_COVERAGE
#include <alphatest_fragment>
#endif
#include <alphahash_fragment>
#if ALPHA_TO_COVERAGE
  diffuseColor.a = telarAlpha;
#endif
#include <emissivemap_fragment>

  SurfaceInfo telarSurface = surfaceInfo(diffuseColor.rgb);
  Reflected telarDirect = nothingReflected();
  Reflected telarSuns = nothingReflected();
  vec3 geometryPosition = -vViewPosition;
  vec3 geometryNormal = telarSurface.n;
  vec3 geometryViewDir = telarSurface.v;
#undef RE_Direct
#undef RE_Direct_RectArea
#undef RE_IndirectSpecular
#if SUNS > 0
#define RE_Direct(light, position, normal, view, coatNormal, material, reflected) \
  if (isSun(light.color)) telarSuns = addSun(telarSuns, telarSurface, light.direction, light.color); \
  else telarDirect = addLight(telarDirect, telarSurface, lightDirection(light.direction), light.color)
#else
#define RE_Direct(light, position, normal, view, coatNormal, material, reflected) telarDirect = addLight(telarDirect, telarSurface, lightDirection(light.direction), light.color)
#endif
TELAR_LIGHT_LOOPS
#if FACETS && FACET_LIGHTS > 0
  addFacetLight(telarDirect, telarSuns, telarSurface);
#endif
#include <lights_fragment_maps>
#if RECT_LIGHTS > 0
  telarDirect = addAreaLight(telarDirect, telarSurface);
#endif
  Incident telarIncident = incidentLight(telarSurface);
  telarIncident.irradiance = irradiance;
  Reflected telarIndirect = indirectLight(telarSurface, telarIncident, telarSuns);
#if OCCLUSION_MAP
  telarIndirect = occluded(telarIndirect, telarSurface);
#endif
  vec3 totalDiffuse = telarDirect.diffuse + telarIndirect.diffuse;
#ifdef USE_TRANSMISSION
  PhysicalMaterial material;
  material.diffuseContribution = telarSurface.diffuse;
  material.specularColorBlended = telarSurface.f0;
  material.specularF90 = telarSurface.f90;
  material.roughness = telarSurface.perceptualRoughness;
  material.ior = ior;
#ifdef USE_DISPERSION
  material.dispersion = dispersion;
#endif
  vec3 normal = telarSurface.n;
#endif
#include <transmission_fragment>
  vec3 outgoingLight = composedRadiance(telarSurface, totalDiffuse, telarDirect, telarIndirect, totalEmissiveRadiance);

#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}
