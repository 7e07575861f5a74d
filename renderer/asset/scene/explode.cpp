#include "telar/explode.h"

#include <array>
#include <new>
#include <optional>

#include "asset/geometry/drawn_points.h"

namespace telar {
namespace {

/// Part of a mesh's area that its vector area has to be for it to face somewhere: a hemisphere has 0.5, a tube 0.
constexpr double FACING = 0.25;

/// What a part looks like from far away.
struct Facing {
  glm::dvec3 normal{0};  ///< vector area, m^2
  double area = 0;       ///< m^2
  Bounds bounds;

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 cross = glm::cross(b - a, c - a) * 0.5;
    normal += cross;
    area += glm::length(cross);
    for (const glm::dvec3& p : {a, b, c}) bounds.add(p);
  }
};

void addPrimitive(Facing& facing, const glm::dmat4& world, const Primitive& primitive) {
  if (primitive.topology != Topology::kTriangles) return;
  const bool indexed = !primitive.indices.empty();
  const std::size_t count = indexed ? primitive.indices.size() : primitive.positions.size();
  const double sign = glm::determinant(glm::dmat3(world)) < 0 ? -1 : 1;
  for (std::size_t i = 0; i + 2 < count; i += 3) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = indexed ? primitive.indices[i + k] : i + k;
      p[k] = glm::dvec3(world * glm::dvec4(glm::dvec3(primitive.positions[at]), 1.0));
    }
    sign > 0 ? facing.add(p[0], p[1], p[2]) : facing.add(p[0], p[2], p[1]);
  }
}

/// Unit; none where a part faces nowhere and lies in the middle.
std::optional<glm::dvec3> wayOf(const Facing& facing, const glm::dvec3& centre) {
  if (facing.bounds.empty()) return std::nullopt;
  if (glm::length(facing.normal) > FACING * facing.area) return glm::normalize(facing.normal);
  const glm::dvec3 away = facing.bounds.middle() - centre;
  if (glm::length(away) == 0) return std::nullopt;
  return glm::normalize(away);
}

}  // namespace

std::shared_ptr<const Scene> explodeScene(const std::shared_ptr<const Scene>& model, double distance,
                                          const CancelToken& cancel) {
  try {
    auto out = std::make_shared<Scene>(*model);
    out->model = model->model ? model->model : model;
    const glm::dvec3 centre = model->bounds.middle();
    asset::DrawnPoints points(cancel);
    out->bounds = Bounds();
    for (Node& node : out->nodes) {
      cancel.check();
      if (node.mesh < 0) continue;
      const auto& primitives = out->meshes[static_cast<std::size_t>(node.mesh)].primitives;
      Facing facing;
      for (const Primitive& primitive : primitives) {
        if (!node.instances) addPrimitive(facing, node.world, primitive);
        for (std::size_t i = 0; node.instances && i < node.instances->matrices.size(); ++i)
          addPrimitive(facing, node.world * glm::dmat4(node.instances->matrices[i]), primitive);
      }
      const auto way = wayOf(facing, centre);
      if (way) node.world[3] += glm::dvec4(*way * distance, 0.0);
      for (const Primitive& primitive : primitives)
        points.visit(node, primitive, [&](const glm::dvec3& p) { out->bounds.add(p); });
    }
    return out;
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory to move the parts of the model");
  }
}

}  // namespace telar
