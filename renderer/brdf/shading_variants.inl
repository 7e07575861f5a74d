// Every shading for some sets of layers, without the text of the layers that a set leaves out. The types keep all their members.
// Included before the shadings with every layer on, so that their names do not meet.
#define LAYER_SHEEN 1
#define LAYER_FLATNESS 2
#define LAYER_DIFFUSE_TRANSMISSION 4
#define LAYER_WEAVE 8
#define LAYER_CLEARCOAT 16
#define LAYER_OTHERS 32  // a stretched highlight, a thin film, a rough diffuse lobe
#define LAYER_ALL 63

#include "brdf/layers_off.inc"
#define SPECULAR 1
#define SHEEN (TELAR_LAYERS & LAYER_SHEEN)
#define FLATNESS (TELAR_LAYERS & LAYER_FLATNESS)
#define DIFFUSE_TRANSMISSION (TELAR_LAYERS & LAYER_DIFFUSE_TRANSMISSION)
#define WEAVE (TELAR_LAYERS & LAYER_WEAVE)
#define CLEARCOAT (TELAR_LAYERS & LAYER_CLEARCOAT)
#define ANISOTROPY (TELAR_LAYERS & LAYER_OTHERS)
#define IRIDESCENCE (TELAR_LAYERS & LAYER_OTHERS)
#define DIFFUSE_ROUGHNESS (TELAR_LAYERS & LAYER_OTHERS)
#undef WEAVE_MAP
#define WEAVE_MAP WEAVE
#undef CLEARCOAT_NORMAL_MAP
#define CLEARCOAT_NORMAL_MAP CLEARCOAT
// A path sees what is finer than a pixel.
#undef NORMAL_VARIANCE
#define NORMAL_VARIANCE 0
#undef YARN_RELIEF
#define YARN_RELIEF 0

// Without its layers some of the text has no use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"

#define TELAR_VARIANT bare
#define TELAR_LAYERS 0
#include "brdf/shading_variant.inl"

#define TELAR_VARIANT soft
#define TELAR_LAYERS (LAYER_SHEEN | LAYER_FLATNESS)
#include "brdf/shading_variant.inl"

#define TELAR_VARIANT knitted
#define TELAR_LAYERS (LAYER_SHEEN | LAYER_DIFFUSE_TRANSMISSION)
#include "brdf/shading_variant.inl"

#define TELAR_VARIANT coated
#define TELAR_LAYERS LAYER_CLEARCOAT
#include "brdf/shading_variant.inl"

#define TELAR_VARIANT woven
#define TELAR_LAYERS (LAYER_SHEEN | LAYER_FLATNESS | LAYER_DIFFUSE_TRANSMISSION | LAYER_WEAVE)
#include "brdf/shading_variant.inl"

#define TELAR_VARIANT layered
#define TELAR_LAYERS LAYER_ALL
#include "brdf/shading_variant.inl"

#pragma GCC diagnostic pop

namespace {

int layersOf(const SurfaceInfo& s) {
  int layers = 0;
  if (max3(s.sheenColor) > 0) layers |= LAYER_SHEEN;
  if (s.flatness > 0) layers |= LAYER_FLATNESS;
  if (s.diffuseTransmission > 0) layers |= LAYER_DIFFUSE_TRANSMISSION;
  if (s.warp.coverage + s.weft.coverage > 0) layers |= LAYER_WEAVE;
  if (s.clearcoat > 0) layers |= LAYER_CLEARCOAT;
  if (s.anisotropyStrength > 0 || s.iridescence > 0 || s.diffuseRoughness > 0) layers |= LAYER_OTHERS;
  return layers;
}

// Those that leave out most come first.
constexpr const ShadingVariant* FABRIC[] = {&bare::fabricVariant,   &soft::fabricVariant,  &knitted::fabricVariant,
                                            &coated::fabricVariant, &woven::fabricVariant, &layered::fabricVariant};
constexpr const ShadingVariant* THREE[] = {&bare::threeVariant,   &soft::threeVariant,  &knitted::threeVariant,
                                           &coated::threeVariant, &woven::threeVariant, &layered::threeVariant};

}  // namespace

const ShadingVariant& shadingVariant(ShadingModel shading, const SurfaceInfo& s) {
  if (shading != ShadingModel::kThree && shading != ShadingModel::kFabric) return layered::principledVariant;
  const int layers = layersOf(s);
  for (const ShadingVariant* variant : shading == ShadingModel::kFabric ? FABRIC : THREE) {
    if ((layers & ~variant->layers) == 0) return *variant;
  }
  return layered::fabricVariant;
}

[[gnu::flatten]] void readWeaveTexel(MaterialInputs& m, const vec4& texel) {
  layered::withWeaveTexel(m, texel, vec2(0.0));
}

[[gnu::flatten]] void shadeRoughness(MaterialInputs& m, Real geometric) { layered::withShadedRoughness(m, geometric); }

[[gnu::flatten]] void readSurface(SurfaceInfo& s, const MaterialInputs& m, const Normals& normals, const vec3& v,
                                  bool specular, bool woven) {
  new (&s) SurfaceInfo(layered::baseSurface(m, normals, v));  // in place
  if (specular) layered::withSpecular(s, m);
  layered::withLayers(s, m, normals);
  if (woven) layered::withWeave(s, m, normals);
}

#undef LAYER_SHEEN
#undef LAYER_FLATNESS
#undef LAYER_DIFFUSE_TRANSMISSION
#undef LAYER_WEAVE
#undef LAYER_CLEARCOAT
#undef LAYER_OTHERS
#undef LAYER_ALL
#include "brdf/shading_layers_off.inl"
// The others follow with every layer on.
#include "brdf/shading_layers_on.inl"
