#include "asset/pose/deform.h"

#include <algorithm>
#include <cmath>

#include "asset/geometry/repair.h"
#include "asset/geometry/sphere.h"
#include "asset/geometry/topology.h"

namespace telar::asset {
namespace {

bool isSkinned(const Deformation& deformation, const Primitive& primitive) {
  return !deformation.joints.empty() && !primitive.deformers->joints.empty();
}

float weightOf(const Deformation& deformation, std::size_t target) {
  return target < deformation.weights.size() ? deformation.weights[target] : 0.0f;
}

/// base + the sum of weight * target over the targets that have the stream
template <typename Vector>
void addTargets(std::vector<Vector>& base, const Deformation& deformation, const std::vector<MorphTarget>& targets,
                std::vector<Vector> MorphTarget::*stream) {
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const float weight = weightOf(deformation, t);
    const auto& deltas = targets[t].*stream;
    if (weight == 0 || deltas.empty()) continue;
    for (std::size_t i = 0; i < base.size(); ++i) base[i] += deltas[i] * weight;
  }
}

void morph(Primitive& out, const Deformation& deformation, const std::vector<MorphTarget>& targets) {
  addTargets(out.positions, deformation, targets, &MorphTarget::positions);
  if (!out.normals.empty()) {
    addTargets(out.normals, deformation, targets, &MorphTarget::normals);
  }
  if (out.colors.empty()) return;
  addTargets(out.colors, deformation, targets, &MorphTarget::colors);
  for (glm::vec4& color : out.colors) {
    for (int i = 0; i < 4; ++i) color[i] = std::isfinite(color[i]) ? color[i] : 1.0f;
  }
}

/// m * v, the columns added in their order, as compilers of GLSL have it; GLM adds them in pairs.
glm::vec4 times(const glm::mat4& m, const glm::vec4& v) {
  return ((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3] * v.w;
}

/// What the joints do to one vertex.
struct Skinned {
  glm::vec4 position{0.0f};  ///< in world space
  glm::mat4 matrix{0.0f};    ///< of its directions

  void add(const glm::mat4& joint, float weight, const glm::vec3& from) {
    position += times(joint, glm::vec4(from, 1.0f)) * weight;
    for (int column = 0; column < 4; ++column) matrix[column] += joint[column] * weight;
  }
};

void skin(Primitive& out, const Deformation& deformation, const Deformers& deformers) {
  const glm::mat4 toNode(deformation.worldToNode);
  const std::vector<glm::mat4> joints(deformation.joints.begin(), deformation.joints.end());
  Sphere sphere;
  for (std::size_t i = 0; i < out.positions.size(); ++i) {
    Skinned skinned;
    for (int k = 0; k < 4; ++k) {
      // Without weight, a joint may be anything, even not finite.
      const float weight = deformers.weights[i][k];
      if (weight != 0) skinned.add(joints[deformers.joints[i][k]], weight, out.positions[i]);
    }
    out.positions[i] = glm::vec3(times(toNode, skinned.position));
    sphere.add(glm::dvec3(out.positions[i]));
    glm::mat4 matrix;
    for (int column = 0; column < 4; ++column) matrix[column] = times(toNode, skinned.matrix[column]);
    const auto turned = [&](const glm::vec3& direction) {
      return glm::vec3(times(matrix, glm::vec4(direction, 0.0f)));
    };
    if (!out.normals.empty()) out.normals[i] = turned(out.normals[i]);
    if (!out.tangents.empty()) out.tangents[i] = glm::vec4(turned(glm::vec3(out.tangents[i])), out.tangents[i].w);
  }
  // SkinnedMesh has a sphere of its own, around all vertices, drawn or not.
  out.center = sphere.center;
}

/// @return how many elements touched vertices that are not finite
std::size_t dropBad(Primitive& out) {
  const std::vector<bool> bad = findBadVertices(out.positions);
  if (bad.empty()) return 0;
  Order order;
  if (!out.indices.empty()) order = std::move(out.indices);
  const std::size_t dropped = dropElements(out.topology, out.positions.size(), bad, order);
  out.indices = std::move(*order);
  // Nothing is left to draw, and no stream may be longer than another.
  if (!out.indices.empty()) return dropped;
  out.positions = {}, out.normals = {}, out.tangents = {}, out.uvs = {}, out.colors = {}, out.visibility = {};
  return dropped;
}

}  // namespace

bool deforms(const Deformation& deformation, const Primitive& primitive) {
  if (!primitive.deformers) return false;
  const std::size_t targets = std::min(primitive.deformers->targets.size(), deformation.weights.size());
  const auto used = deformation.weights.first(targets);
  return isSkinned(deformation, primitive) || std::any_of(used.begin(), used.end(), [](float w) { return w != 0; });
}

Primitive deformed(const Primitive& source, const Deformation& deformation, std::size_t& dropped) {
  Primitive out = source;
  if (!deforms(deformation, source)) return out;
  out.center = fileBoundsOf(source).middle();  // three.js's sphere does not follow morph targets
  morph(out, deformation, source.deformers->targets);
  if (isSkinned(deformation, source)) skin(out, deformation, *source.deformers);
  dropped += dropBad(out);
  out.bounds = Bounds();
  if (out.positions.empty()) return out;
  repairNormals(out);
  repairTangents(out);
  out.bounds = drawnBounds(out.positions, usedVertices(out.positions.size(), out.indices));
  return out;
}

}  // namespace telar::asset
