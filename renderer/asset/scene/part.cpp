#include "telar/part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "asset/geometry/drawn_points.h"
#include "asset/scene/json_vector.h"
#include "asset/scene/outline.h"
#include "telar/part_opacities.h"
#include "telar/variant_material.h"

namespace telar {
namespace {

using json = nlohmann::ordered_json;

bool isMeant(const PartQuery& query, int index, const std::string& name) {
  if (const int* wanted = std::get_if<int>(&query.which)) return index == *wanted;
  return name == std::get<std::string>(query.which);
}

/// -1 = none of this name
int variantOf(const Scene& scene, const std::string& name) {
  const auto variant = std::find(scene.variants.begin(), scene.variants.end(), name);
  return variant == scene.variants.end() ? -1 : static_cast<int>(variant - scene.variants.begin());
}

/// Where something is, of its points.
struct Extent {
  Bounds bounds;
  asset::Outline outline;

  void add(const glm::dvec3& p) { bounds.add(p), outline.add(p); }
  void describe(json& out) const {
    out["bounds"] = bounds.empty() ? json(nullptr) : json{{"min", list(bounds.min)}, {"max", list(bounds.max)}};
    out["outline"] = json::array();
    for (const glm::dvec3& point : outline.points()) out["outline"].push_back(list(point));
  }
};

class PartMeasure {
 public:
  PartMeasure(const Scene& scene, const PartQuery& query, const std::vector<Shot::Ghost>& ghost,
              const CancelToken& cancel)
      : scene_(scene),
        query_(query),
        opacities_(scene, ghost),
        variant_(variantOf(scene, query.variant)),
        points_(cancel) {}

  void run(const CancelToken& cancel) {
    std::vector<char> within(scene_.nodes.size());  // nodes that are meant, and those beneath them
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      cancel.check();
      const Node& node = scene_.nodes[i];
      const bool meant = query_.kind == PartQuery::Kind::kNode && isMeant(query_, node.file.node, node.name);
      found_ |= meant;
      const bool beneath = node.parent >= 0 && within[static_cast<std::size_t>(node.parent)] != 0;
      within[i] = static_cast<char>(meant || beneath);
      if (node.mesh >= 0) measure(node, meant || beneath);
    }
    if (query_.kind == PartQuery::Kind::kMaterial) {
      for (std::size_t i = 0; i < scene_.fileMaterials; ++i) {
        found_ |= isMeant(query_, static_cast<int>(i), scene_.materials[i].name);
      }
    }
  }

  std::string describe() const {
    json out;
    out["found"] = found_;
    extent_.describe(out);
    if (extent_.bounds.empty()) out["names"] = names();
    return out.dump(-1, ' ', false, json::error_handler_t::replace);
  }

 private:
  void measure(const Node& node, bool within) {
    for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (!(within || wears(node, primitive)) || isLeftOut(node, primitive)) continue;
      points_.visit(node, primitive, [this](const glm::dvec3& p) { extent_.add(p); });
    }
  }

  bool isLeftOut(const Node& node, const Primitive& primitive) const {
    return opacities_.of(node, materialIndex(primitive, variant_)) == 0;
  }

  bool wears(const Node& node, const Primitive& primitive) const {
    if (query_.kind != PartQuery::Kind::kMaterial) return false;
    const int index = materialIndex(node, primitive, variant_);
    return index >= 0 && isMeant(query_, index, scene_.materials[static_cast<std::size_t>(index)].name);
  }

  /// Of what a part could be instead: in the file's order, each once.
  json names() const {
    std::map<int, std::string> drawn;  // by index in the file
    for (const Node& node : scene_.nodes) {
      if (node.mesh >= 0) query_.kind == PartQuery::Kind::kNode ? addNodes(&node, drawn) : addMaterials(node, drawn);
    }
    json out = json::array();
    for (const auto& [index, name] : drawn) {
      if (out.size() == PART_NAMES_MAX) break;
      if (!name.empty() && std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    }
    return out;
  }

  /// The node and those above it.
  void addNodes(const Node* node, std::map<int, std::string>& drawn) const {
    while (drawn.emplace(node->file.node, node->name).second && node->parent >= 0) {
      node = &scene_.nodes[static_cast<std::size_t>(node->parent)];
    }
  }

  void addMaterials(const Node& node, std::map<int, std::string>& drawn) const {
    for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      const int index = materialIndex(node, primitive, variant_);
      if (index >= 0) drawn.emplace(index, scene_.materials[static_cast<std::size_t>(index)].name);
    }
  }

  const Scene& scene_;
  const PartQuery& query_;
  PartOpacities opacities_;
  int variant_;
  bool found_ = false;
  Extent extent_;
  asset::DrawnPoints points_;
};

/// Visits each drawn vertex in each of its places, without those of what is left out.
template <typename Visit>
void visitShown(const Scene& scene, const std::string& variant, const std::vector<Shot::Ghost>& ghost,
                const CancelToken& cancel, const Visit& visit) {
  const PartOpacities opacities(scene, ghost);
  const int index = variantOf(scene, variant);
  asset::DrawnPoints points(cancel);
  for (const Node& node : scene.nodes) {
    cancel.check();
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (opacities.of(node, materialIndex(primitive, index)) != 0) points.visit(node, primitive, visit);
    }
  }
}

}  // namespace

std::string describePart(const Scene& scene, const PartQuery& query, const std::vector<Shot::Ghost>& ghost,
                         const CancelToken& cancel) {
  PartMeasure measure(scene, query, ghost, cancel);
  measure.run(cancel);
  return measure.describe();
}

std::string describeShown(const Scene& scene, const std::string& variant, const std::vector<Shot::Ghost>& ghost,
                          const CancelToken& cancel) {
  Extent extent;
  visitShown(scene, variant, ghost, cancel, [&](const glm::dvec3& p) { extent.add(p); });
  json out;
  extent.describe(out);
  return out.dump();
}

std::string describeRanges(const Scene& scene, const std::array<glm::dvec3, 3>& axes, const std::string& variant,
                           const std::vector<Shot::Ghost>& ghost, const CancelToken& cancel) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{}, high{};
  low.fill(INFINITE), high.fill(-INFINITE);
  visitShown(scene, variant, ghost, cancel, [&](const glm::dvec3& p) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double along = glm::dot(p, axes[i]);
      if (std::isfinite(along)) low[i] = std::min(low[i], along), high[i] = std::max(high[i], along);
    }
  });
  json out = json::array();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (low[i] > high[i]) return "null";
    out.push_back({low[i], high[i]});
  }
  return out.dump();
}

}  // namespace telar
