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
template <typename Vector, typename Exact>
void addTargets(std::vector<Vector>& base, const Deformation& deformation, const std::vector<MorphTarget>& targets,
                std::vector<Vector> MorphTarget::*stream) {
  std::vector<Exact> sums(base.begin(), base.end());
  bool changed = false;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const double weight = weightOf(deformation, t);
    const auto& deltas = targets[t].*stream;
    if (weight == 0 || deltas.empty()) continue;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += Exact(deltas[i]) * weight;
    changed = true;
  }
  if (!changed) return;
  for (std::size_t i = 0; i < base.size(); ++i) base[i] = Vector(sums[i]);
}

void morph(Primitive& out, const Deformation& deformation, const std::vector<MorphTarget>& targets) {
  addTargets<glm::vec3, glm::dvec3>(out.positions, deformation, targets, &MorphTarget::positions);
  if (!out.normals.empty()) {
    addTargets<glm::vec3, glm::dvec3>(out.normals, deformation, targets, &MorphTarget::normals);
  }
  if (out.colors.empty()) return;
  addTargets<glm::vec4, glm::dvec4>(out.colors, deformation, targets, &MorphTarget::colors);
  for (glm::vec4& color : out.colors) {
    for (int i = 0; i < 4; ++i) color[i] = std::isfinite(color[i]) ? color[i] : 1.0f;
  }
}

/// Matrix that moves one vertex in the node's space.
glm::dmat4 vertexMatrix(const Deformation& deformation, const glm::u16vec4& joints, const glm::vec4& weights) {
  glm::dmat4 sum(0.0);
  for (int k = 0; k < 4; ++k) {
    // Without weight, a joint may be anything, even not finite.
    if (weights[k] != 0) sum += deformation.joints[joints[k]] * static_cast<double>(weights[k]);
  }
  return deformation.worldToNode * sum;
}

void skin(Primitive& out, const Deformation& deformation, const Deformers& deformers) {
  Sphere sphere;
  for (std::size_t i = 0; i < out.positions.size(); ++i) {
    const glm::dmat4 matrix = vertexMatrix(deformation, deformers.joints[i], deformers.weights[i]);
    const glm::dvec3 position(matrix * glm::dvec4(glm::dvec3(out.positions[i]), 1.0));
    sphere.add(position);
    out.positions[i] = glm::vec3(position);
    if (!out.normals.empty()) out.normals[i] = glm::vec3(glm::dmat3(matrix) * glm::dvec3(out.normals[i]));
    if (out.tangents.empty()) continue;
    const glm::dvec3 tangent = glm::dmat3(matrix) * glm::dvec3(out.tangents[i]);
    out.tangents[i] = glm::vec4(glm::vec3(tangent), out.tangents[i].w);
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
  out.center = (source.bounds.min + source.bounds.max) * 0.5;  // three.js's sphere does not follow morph targets
  morph(out, deformation, source.deformers->targets);
  if (isSkinned(deformation, source)) skin(out, deformation, *source.deformers);
  dropped += dropBad(out);
  out.bounds = Bounds();
  if (out.positions.empty()) return out;
  repairNormals(out);
  repairTangents(out);
  const auto used = usedVertices(out.positions.size(), out.indices);
  if (used.empty()) {
    for (const auto& position : out.positions) out.bounds.add(glm::dvec3(position));
  }
  for (const std::uint32_t index : used) out.bounds.add(glm::dvec3(out.positions[index]));
  return out;
}

}  // namespace telar::asset
