#pragma once
#include <cmath>
#include <thread>
#include <vector>

#include "brdf/shading.h"

/// The functions of a shading in either precision.
namespace telar::numerics {

template <class Real>
struct Side;

template <>
struct Side<float> {
  using Vec3 = glm::vec3;
  using Info = brdf_f::SurfaceInfo;
  using Incident = brdf_f::Incident;
  using Reflected = brdf_f::Reflected;
  static Reflected nothing() { return brdf_f::nothingReflected(); }
  static brdf_f::ShadingFunctions functions(ShadingModel model) { return brdf_f::shadingFunctions(model); }
};

template <>
struct Side<double> {
  using Vec3 = glm::dvec3;
  using Info = brdf_d::SurfaceInfo;
  using Incident = brdf_d::Incident;
  using Reflected = brdf_d::Reflected;
  static Reflected nothing() { return brdf_d::nothingReflected(); }
  static brdf_d::ShadingFunctions functions(ShadingModel model) { return brdf_d::shadingFunctions(model); }
};

/// One shading of one surface.
template <class Real>
class Shaded {
 public:
  using Vec3 = typename Side<Real>::Vec3;

  Shaded(ShadingModel model, const typename Side<Real>::Info& info)
      : functions_(Side<Real>::functions(model)), info_(functions_.preparedSurface(info)) {}

  /// By lobe, of a light of irradiance 1 on a surface that faces it.
  typename Side<Real>::Reflected lobes(const Vec3& l) const {
    return functions_.addPunctual(Side<Real>::nothing(), info_, l, Vec3(1));
  }
  /// Composed radiance of the same light.
  Vec3 direct(const Vec3& l) const { return composed(lobes(l), Side<Real>::nothing()); }
  /// Of an ambient light of irradiance 1.
  Vec3 dome() const {
    return composed(Side<Real>::nothing(), functions_.addDome(Side<Real>::nothing(), info_, Vec3(1)));
  }
  /// Of an environment of radiance 1 everywhere.
  Vec3 environment() const {
    typename Side<Real>::Incident incident{};
    incident.environmentIrradiance = Vec3(static_cast<Real>(3.14159265358979));
    incident.radiance = incident.coatRadiance = incident.weftRadiance = incident.sheenRadiance = Vec3(1);
    return composed(Side<Real>::nothing(), functions_.addEnvironment(Side<Real>::nothing(), info_, incident));
  }
  Vec3 composed(const typename Side<Real>::Reflected& direct, const typename Side<Real>::Reflected& indirect) const {
    return functions_.composedRadiance(info_, direct.diffuse + indirect.diffuse, direct, indirect, Vec3(0));
  }
  const typename Side<Real>::Info& info() const { return info_; }

 private:
  decltype(Side<Real>::functions(ShadingModel::kThree)) functions_;
  typename Side<Real>::Info info_;
};

template <class Vec3>
bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class Vec3>
auto least(const Vec3& v) {
  return std::min(v.x, std::min(v.y, v.z));
}

/// Runs work(first, last, part) over [0, count) on every core; `part` numbers the threads.
template <class Work>
unsigned inParallel(std::uint64_t count, Work work) {
  const unsigned parts = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (unsigned part = 0; part < parts; ++part)
    threads.emplace_back([=, &work] { work(count * part / parts, count * (part + 1) / parts, part); });
  for (std::thread& thread : threads) thread.join();
  return parts;
}

inline unsigned partCount() { return std::max(1u, std::thread::hardware_concurrency()); }

}  // namespace telar::numerics
