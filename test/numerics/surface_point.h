#pragma once
#include "brdf/shading.h"
#include "materials.h"

namespace telar::numerics {

/// One evaluation of a shading: a surface as the renderer would read it, and the light of one direction.
struct SurfacePoint {
  ShadingModel model = ShadingModel::kThree;  ///< that reads it
  Material material;
  brdf_f::SurfaceInfo info;  ///< in single precision: its numbers are exact for both sides
  glm::vec3 l{0, 0, 1};
};

/// The directions of a point about its normal.
struct Directions {
  double NoV = 1, NoL = 1;
  double phi = 0;     ///< azimuth of l against v, radians
  double turn = 0.7;  ///< azimuth of v against the tangent
};

/// A plane facing +Z, seen and lit so.
SurfacePoint pointOn(ShadingModel model, const Material& material, const Directions& directions);

/// The same surface with the places of viewer and light exchanged.
SurfacePoint exchanged(const SurfacePoint& point);

/// Any material with any layers, any directions and orientation; forced edge values among them; now and then a normal
/// map that turns the normal from the viewer.
SurfacePoint randomPoint(ShadingModel model, std::uint64_t seed);

/// The grid: every combination of edge values of roughness, directions, reflectance, sheen, metalness, coat and
/// stretch.
std::uint64_t gridSize();
SurfacePoint gridPoint(ShadingModel model, std::uint64_t index);

/// Whether it shows warp or weft, as the reader of materials has it.
bool hasYarns(const SurfacePoint& point);

/// What a message says of a point.
std::string describe(const SurfacePoint& point);

/// The same surface, its numbers widened.
brdf_d::SurfaceInfo inDouble(const brdf_f::SurfaceInfo& info);

/// The members of SurfaceInfo in order, as numbers.
std::vector<float> numbersOf(const brdf_f::SurfaceInfo& info);
std::size_t numberCount();

/// GLSL statements that fill `SurfaceInfo s` from `float p[]`, numbersOf() from p[first] on.
std::string glslReader(std::size_t first);

}  // namespace telar::numerics
