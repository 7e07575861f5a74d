#pragma once
#include <string>
#include <variant>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

/// A part of a model that a camera may frame.
struct PartQuery {
  enum class Kind {
    kNode,      ///< the nodes of this name, with all that is beneath them
    kMaterial,  ///< all that is drawn with the materials of this name
  } kind = Kind::kNode;
  std::variant<int, std::string> which;  ///< index in the file, or name: several may have it
  std::string variant;                   ///< KHR_materials_variants name that materials are drawn in; empty = none
};

/// What a part measures as one JSON object, for resolveShot: {found, bounds: {min, max} | null, outline: [[x, y, z],
/// ...]}, metres in world space as describeScene() has them. Where the part draws nothing bounds is null, and `names`
/// lists what there is in its place, at most PART_NAMES_MAX of them in the file's order.
/// @throws Error{X_CANCELLED}
std::string describePart(const Scene& scene, const PartQuery& query, const CancelToken& cancel);

constexpr std::size_t PART_NAMES_MAX = 256;

}  // namespace telar
