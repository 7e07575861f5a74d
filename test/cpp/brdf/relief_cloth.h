#pragma once
#include <cmath>
#include <vector>

#include "brdf/brdf.h"
#include "brdf/quadrature.h"
#include "brdf/shading.h"

/// Cloth whose normal map is finer than a pixel, against the mean over the texels that it stands for.
namespace telar::test::relief_test {

using brdf_d::Incident;
using brdf_d::Reflected;
using brdf_d::SurfaceInfo;
using glm::dvec3;

inline constexpr double PI = TWO_PI / 2;
inline constexpr double COSINES[] = {0.2, 0.5, 0.8, 0.97};

inline brdf_d::ShadingFunctions fabric() { return brdf_d::shadingFunctions(ShadingModel::kFabric); }

struct Cloth {
  double albedo, roughness, metallic, sheen, sheenRoughness;
};
inline const Cloth WHITE[] = {
    {1, 0.3, 0, 0, 0.3}, {1, 0.9, 0, 0, 0.3}, {1, 0.6, 0, 1, 0.3}, {1, 0.8, 0, 1, 0.8}, {1, 0.4, 1, 0, 0.3}};

/// @param n  shading normal; that of the geometry is +z
inline SurfaceInfo surfaceOf(const Cloth& cloth, const dvec3& n, const dvec3& v, double relief, double slopeVariance,
                             const dvec3& axis = dvec3(0)) {
  SurfaceInfo s{};
  s.n = brdf_d::normalFacing(n, v);
  s.geometricNormal = dvec3(0, 0, 1);
  s.v = v;
  s.NoV = brdf_d::saturate(glm::dot(s.n, v));
  s.baseColor = s.metalColor = dvec3(cloth.albedo);
  s.metallic = cloth.metallic;
  s.diffuse = dvec3(cloth.albedo * (1 - cloth.metallic));
  s.f0Dielectric = dvec3(0.045);
  s.f90 = 1;
  s.perceptualRoughness = cloth.roughness;
  s.alpha = cloth.roughness * cloth.roughness;
  s.sheenColor = dvec3(cloth.sheen);
  s.sheenRoughness = cloth.sheenRoughness;
  s.coatNormal = s.n;
  s.clearcoatRoughness = 0.5;
  s.clearcoatNoV = s.NoV;
  s.relief = relief;
  s.slopeVariance = slopeVariance;
  s.reliefAxis = axis;
  return fabric().preparedSurface(s);
}

inline Reflected lit(const SurfaceInfo& s, const dvec3& l) {
  return fabric().addPunctual(brdf_d::nothingReflected(), s, l, dvec3(1));
}

inline Reflected underSky(const SurfaceInfo& s) {
  Incident sky{};
  sky.environmentIrradiance = dvec3(PI);
  sky.radiance = sky.coatRadiance = sky.weftRadiance = sky.sheenRadiance = dvec3(1);
  return fabric().addEnvironment(brdf_d::nothingReflected(), s, sky);
}

inline double composed(const SurfaceInfo& s, const Reflected& sum) {
  return fabric().composedRadiance(s, sum.diffuse, sum, brdf_d::nothingReflected(), dvec3(0)).x;
}

inline double diffuseOf(const Reflected& r) { return r.diffuse.x; }
inline double sheenOf(const Reflected& r) { return r.sheen.x; }

/// Normals of a relief.
struct Relief {
  const char* name;
  std::vector<dvec3> normals;

  double lost() const {
    dvec3 mean(0);
    for (const dvec3& n : normals) mean += n;
    return 1 - glm::length(mean) / double(normals.size());
  }
  /// As texture/relief.glsl has it.
  double slopeVariance() const {
    double flat = 0;
    for (const dvec3& n : normals) flat += n.z * n.z / (4 - 3 * n.z * n.z);
    return 0.25 * (double(normals.size()) / flat - 1);
  }
};

}  // namespace telar::test::relief_test
