#pragma once
#include "brdf/brdf.h"
#include "telar/shading.h"

/// How the lobes of one surface add up, compiled from the text that the fragment shader runs (shaders/shading), with
/// every layer on: a layer of weight 0 changes nothing. In float and in double, as brdf.h.
#include "brdf/shading_layers_on.inl"
#define float Real

namespace telar::brdf_f {
#include "brdf/shading_declarations.inl"

/// withWeaveTexel() of no threads within a pixel, in place.
void readWeaveTexel(MaterialInputs& m, const vec4& texel);
/// withShadedRoughness() in place.
void shadeRoughness(MaterialInputs& m, Real geometric);

/// baseSurface(), and where they are wanted withSpecular() and withWeave(), with withLayers() between: one call without
/// copies.
void readSurface(SurfaceInfo& s, const MaterialInputs& m, const Normals& normals, const vec3& v, bool specular,
                 bool woven);

/// A shading without the layers that some surfaces do not have: each function is one call, without copies of the
/// surface, and costs what its layers cost. What is left out changes nothing but roundings.
struct ShadingVariant {
  int layers;  ///< bits of those it has
  void (*prepare)(SurfaceInfo& s);
  /// addPunctual() of irradiance 1. @param s  prepared  @param l  unit
  Reflected (*punctual)(const SurfaceInfo& s, const vec3& l);
  Reflected (*dome)(const SurfaceInfo& s, const vec3& irradiance);  ///< addDome()
  /// addBehind(); null where none comes through.
  Reflected (*behind)(const Reflected& lit, const SurfaceInfo& s, const vec3& irradiance);
  /// composedRadiance(). @param diffuse  in place of that of `lit`
  vec3 (*composed)(const SurfaceInfo& s, const vec3& diffuse, const Reflected& lit);
  /// composed() of punctual(). @param diffuse  factor on the diffuse lobe
  vec3 (*bsdfCosine)(const SurfaceInfo& s, const vec3& l, Real diffuse);
  void (*lobeMixture)(const SurfaceInfo& s, LobeMixture& lobes);
  vec3 (*sampleMixture)(const LobeMixture& lobes, const vec2& u);
  Real (*pdfMixture)(const LobeMixture& lobes, const vec3& l);
};
/// The variant that leaves out most of what a surface does not have. Relief is always left out.
/// @param s  before preparedSurface()
const ShadingVariant& shadingVariant(ShadingModel shading, const SurfaceInfo& s);
}  // namespace telar::brdf_f

namespace telar::brdf_d {
#include "brdf/shading_declarations.inl"
}  // namespace telar::brdf_d

#undef float
#include "brdf/shading_layers_off.inl"
