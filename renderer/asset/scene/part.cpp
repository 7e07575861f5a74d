#include "telar/part.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "asset/geometry/drawn_points.h"
#include "asset/scene/outline.h"
#include "telar/variant_material.h"

namespace telar {
namespace {

using json = nlohmann::ordered_json;

json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

bool isMeant(const PartQuery& query, int index, const std::string& name) {
  if (const int* wanted = std::get_if<int>(&query.which)) return index == *wanted;
  return name == std::get<std::string>(query.which);
}

class PartMeasure {
 public:
  PartMeasure(const Scene& scene, const PartQuery& query, const CancelToken& cancel)
      : scene_(scene), query_(query), points_(cancel) {
    const auto variant = std::find(scene.variants.begin(), scene.variants.end(), query.variant);
    if (variant != scene.variants.end()) variant_ = static_cast<int>(variant - scene.variants.begin());
  }

  void run(const CancelToken& cancel) {
    std::vector<char> within(scene_.nodes.size());  // nodes that are meant, and those beneath them
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      cancel.check();
      const Node& node = scene_.nodes[i];
      const bool meant = query_.kind == PartQuery::Kind::kNode && isMeant(query_, node.file.node, node.name);
      found_ |= meant;
      within[i] = meant || (node.parent >= 0 && within[static_cast<std::size_t>(node.parent)]);
      if (node.mesh >= 0) measure(node, within[i]);
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
    out["bounds"] = bounds_.empty() ? json(nullptr) : json{{"min", list(bounds_.min)}, {"max", list(bounds_.max)}};
    out["outline"] = json::array();
    for (const glm::dvec3& point : outline_.points()) out["outline"].push_back(list(point));
    if (bounds_.empty()) out["names"] = names();
    return out.dump(-1, ' ', false, json::error_handler_t::replace);
  }

 private:
  void measure(const Node& node, bool within) {
    for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (!within && !wears(node, primitive)) continue;
      points_.visit(node, primitive, [this](const glm::dvec3& p) { bounds_.add(p), outline_.add(p); });
    }
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
  int variant_ = -1;
  bool found_ = false;
  Bounds bounds_;
  asset::Outline outline_;
  asset::DrawnPoints points_;
};

}  // namespace

std::string describePart(const Scene& scene, const PartQuery& query, const CancelToken& cancel) {
  PartMeasure measure(scene, query, cancel);
  measure.run(cancel);
  return measure.describe();
}

}  // namespace telar
