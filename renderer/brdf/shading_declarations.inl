// Included in a namespace where Real is the scalar type and `float` stands for it.
#include "../material/surface_types.glsl"
#include "material/input_types.glsl"
// After what it samples.
#include "../light/lobe_types.glsl"

Reflected nothingReflected();

/// (A, B) of the split sum as a release of three.js has it: brdf::dfgOf().
vec2 splitSum(const ThreeTerms& three, Real perceptualRoughness, Real NoV);

// From what the file says of a material to a surface, shaders/material/layers.glsl.
MaterialInputs withShadedRoughness(MaterialInputs m, Real geometric);
MaterialInputs withWeaveTexel(MaterialInputs m, vec4 texel, vec2 threads);
vec3 bumpedNormal(vec3 n, vec3 dpdx, vec3 dpdy, vec2 rise, Real face);
Normals facingViewer(Normals normals, vec3 v);
SurfaceInfo baseSurface(MaterialInputs m, Normals normals, vec3 v);
SurfaceInfo withSpecular(SurfaceInfo s, MaterialInputs m);
SurfaceInfo withLayers(SurfaceInfo s, MaterialInputs m, Normals normals);
SurfaceInfo withWeave(SurfaceInfo s, MaterialInputs m, Normals normals);
YarnLobe yarnLobe(vec3 n, vec3 axis, vec3 aside, vec2 turn, Real slope, Real coverage, Real roughness, Real anisotropy,
                  vec3 specularColor);

SurfaceInfo withVisibility(SurfaceInfo s, vec4 side, vec4 other);
Reflected visibleLight(Reflected indirect, SurfaceInfo s);

// Importance sampling, shaders/light/lobe_mixture.glsl.
LobeMixture lobeMixture(SurfaceInfo s);
vec3 sampleMixture(LobeMixture lobes, vec2 u);
Real pdfMixture(LobeMixture lobes, vec3 l);

// What each shading provides.
#define TELAR_SHADING_FUNCTIONS                                                 \
  SurfaceInfo preparedSurface(SurfaceInfo s);                                   \
  Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor); \
  Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance);             \
  Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident);    \
  vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted);

/// As three.js: the release in SurfaceInfo.
namespace three {
TELAR_SHADING_FUNCTIONS
}  // namespace three

/// telar's cloth.
namespace fabric {
TELAR_SHADING_FUNCTIONS
Reflected addBehind(Reflected sum, SurfaceInfo s, vec3 irradiance);
}  // namespace fabric

/// three-r115 and disney-2012, by the terms in SurfaceInfo.
namespace principled {
TELAR_SHADING_FUNCTIONS
Reflected addBehind(Reflected sum, SurfaceInfo s, vec3 irradiance);
}  // namespace principled

#undef TELAR_SHADING_FUNCTIONS

/// The functions of one shading.
struct ShadingFunctions {
  decltype(&three::preparedSurface) preparedSurface;
  decltype(&three::addPunctual) addPunctual;
  decltype(&three::addDome) addDome;
  decltype(&three::addEnvironment) addEnvironment;
  decltype(&three::composedRadiance) composedRadiance;
  decltype(&fabric::addBehind) addBehind =
      nullptr;  ///< light of domes on the other side, where a shading lets any through
};

/// A principled shading is what `terms` of its SurfaceInfo say: set them before preparedSurface().
ShadingFunctions shadingFunctions(ShadingModel shading);
