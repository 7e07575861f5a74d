#include "telar/part_opacities.h"

#include <string>
#include <variant>

#include "telar/error.h"

namespace telar {
namespace {

constexpr float NONE = -1;

bool isMeant(const PartQuery& part, int index, const std::string& name) {
  if (const int* wanted = std::get_if<int>(&part.which)) return index == *wanted;
  return matchesName(std::get<std::string>(part.which), name);
}

std::string shown(const PartQuery& part) {
  const char* kind = part.kind == PartQuery::Kind::kNode ? "node " : "material ";
  if (const int* index = std::get_if<int>(&part.which)) return kind + std::to_string(*index);
  return kind + telar::quoted(std::get<std::string>(part.which));
}

}  // namespace

bool matchesName(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0, star = std::string_view::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++, taken = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1, n = ++taken;  // the last star takes one character more
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

PartOpacities::PartOpacities(const Scene& scene, const std::vector<Shot::Ghost>& ghost) {
  if (ghost.empty()) return;
  scene_ = &scene;
  nodes_.assign(scene.nodes.size(), NONE);
  materials_.assign(scene.fileMaterials, NONE);
  for (std::size_t g = 0; g < ghost.size(); ++g) {
    const auto& [part, opacity] = ghost[g];
    bool found = false;
    if (part.kind == PartQuery::Kind::kNode) {
      std::vector<char> within(scene.nodes.size());
      for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const bool beneath = node.parent >= 0 && within[static_cast<std::size_t>(node.parent)] != 0;
        within[i] = static_cast<char>(isMeant(part, node.file.node, node.name) || beneath);
        if (within[i] != 0) nodes_[i] = opacity, found |= node.mesh >= 0;
      }
    } else {
      for (std::size_t i = 0; i < materials_.size(); ++i) {
        if (isMeant(part, static_cast<int>(i), scene.materials[i].name)) materials_[i] = opacity, found = true;
      }
    }
    if (!found)
      throw Error("E_FRAME", "shot.ghost[" + std::to_string(g) + "]: the model draws no " + shown(part))
          .at("/ghost/" + std::to_string(g));
  }
}

float PartOpacities::of(const Node& node, int material) const {
  if (!scene_) return 1;
  const float own = nodes_[static_cast<std::size_t>(&node - scene_->nodes.data())];
  const float worn = material >= 0 ? materials_[static_cast<std::size_t>(material)] : NONE;
  return (own == NONE ? 1 : own) * (worn == NONE ? 1 : worn);
}

}  // namespace telar
