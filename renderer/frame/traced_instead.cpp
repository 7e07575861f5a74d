#include <algorithm>

#include "frame/variant.h"
#include "telar/reference.h"

namespace telar {
namespace {

/// Triangles of the model for each pixel of the picture from which on the tracer costs no more. On llvmpipe a pass
/// takes 0.16 us a triangle and a sample of its pixels 2.7 to 4.3 us, a path 2.1 to 4.3 us; pixels of a garment settle
/// after some 250 of up to 1024 on average. The table is in js/docs/reference.md.
constexpr double TRIANGLES_A_PIXEL = 0.5;

/// Whether the tracer leaves something out or shows it otherwise than the raster: glass, points and lines.
bool isTracedOtherwise(const Scene& scene, const Shot& shot) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (frame::materialAt(scene, static_cast<int>(i), shot.shading).layers.transmissionFactor > 0) return true;
  }
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const Primitive& primitive) { return primitive.topology != Topology::kTriangles; });
  });
}

}  // namespace

std::optional<Shot> tracedInstead(const Scene& scene, const Shot& shot) {
  if (!shot.isHigh || shot.shading != ShadingModel::kFabric || !shot.layers.empty()) return std::nullopt;
  if (shot.debugOutput != DebugOutput::kNone) return std::nullopt;
  const double pixels = static_cast<double>(shot.width) * shot.height;
  if (static_cast<double>(scene.triangleCount) < TRIANGLES_A_PIXEL * pixels) return std::nullopt;
  if (isTracedOtherwise(scene, shot)) return std::nullopt;
  Shot traced = shot;
  traced.reference =
      Shot::Reference{.samples = shot.samples, .transport = Shot::Reference::Transport::kDirect, .bounces = 0};
  traced.samples = 1;
  traced.lens.reset();  // the raster shows everything sharp
  return traced;
}

}  // namespace telar
