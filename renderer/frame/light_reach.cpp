#include "frame/light_reach.h"

#include <algorithm>
#include <cmath>

#include "frame/sample_passes.h"

namespace telar::frame {
namespace {

/// Part of the largest number that a distance is computed from by which it may be off: some 100 times what a float
/// rounds.
constexpr double ROUNDING = 1e-5;

/// The largest coordinate that a matrix makes of a box about the origin, nothing cancelled.
glm::dvec3 mostOf(const glm::dmat4& matrix, const glm::dvec3& box) {
  glm::dvec3 sum = glm::abs(glm::dvec3(matrix[3]));
  for (int axis = 0; axis < 3; ++axis) sum += glm::abs(glm::dvec3(matrix[axis])) * box[axis];
  return sum;
}

/// The largest term of the model's coordinates in view space, as the vertex stage adds them up.
double largestTerm(const Scene& scene, const glm::dmat4& view) {
  double most = 0;
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    const glm::dmat4 toView = view * node.world;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (primitive.bounds.empty()) continue;
      const glm::dvec3 own = glm::max(glm::abs(primitive.bounds.min), glm::abs(primitive.bounds.max));
      glm::dvec3 box = own;
      if (node.instances) {
        for (const glm::mat4& matrix : node.instances->matrices) box = glm::max(box, mostOf(glm::dmat4(matrix), own));
      }
      const glm::dvec3 terms = mostOf(toView, box);
      most = std::max({most, terms.x, terms.y, terms.z});
    }
  }
  return most;
}

/// Whether fragments may lie beside the triangles that they are of: with several samples they are shaded at the middle
/// of a pixel, wherever the sample is that a triangle covers; merged quads are shaded as one of their triangles.
bool areShadedBeside(const Shot& shot) { return samplePassesOf(shot).samples > 1 || shot.mergeQuads; }

/// Pixels by which a fragment may lie beside the model: half of one, and as much for passes that are moved.
constexpr double BESIDE = 2;

/// Whether no line of sight through a pixel of the bounds, or one beside it, meets the sphere of a light.
bool liesBeside(const Bounds& bounds, const Camera& camera, int height, const glm::dvec3& light, double range) {
  const double radius = bounds.diagonal() / 2;
  const glm::dvec3 model(camera.view * glm::dvec4(bounds.middle(), 1.0));
  const double pixel = 2 / (std::abs(camera.projection[1][1]) * height);  // metres; in perspective at a depth of 1
  if (camera.orthographic) return glm::distance(glm::dvec2(model), glm::dvec2(light)) > radius + range + BESIDE * pixel;
  const double toModel = glm::length(model), toLight = glm::length(light);
  if (radius >= toModel || range >= toLight) return false;
  // Lines go on behind the camera.
  const double apart = std::acos(std::min(std::abs(glm::dot(model, light)) / (toModel * toLight), 1.0));
  return apart > std::asin(radius / toModel) + std::asin(range / toLight) + BESIDE * pixel;
}

}  // namespace

bool reaches(const Scene& scene, const Shot& shot, const Camera& camera, const glm::dvec3& position, double range) {
  const Bounds& bounds = scene.bounds;
  if (range <= 0 || bounds.empty()) return true;
  const double gap = glm::distance(position, glm::clamp(position, bounds.min, bounds.max));
  if (gap <= range) return true;
  const glm::dvec3 seen(camera.view * glm::dvec4(position, 1.0));
  const double margin = ROUNDING * (gap + glm::length(seen) + largestTerm(scene, camera.view));
  if (gap <= range + margin) return true;
  return areShadedBeside(shot) && !liesBeside(bounds, camera, shot.height, seen, range + margin);
}

}  // namespace telar::frame
