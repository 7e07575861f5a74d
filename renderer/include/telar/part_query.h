#pragma once
#include <string>
#include <variant>

namespace telar {

/// A part of a model: what a camera frames, what is measured, what is stitched.
struct PartQuery {
  enum class Kind {
    kNode,      ///< the nodes of this name, with all that is beneath them
    kMaterial,  ///< all that is drawn with the materials of this name
  } kind = Kind::kNode;
  std::variant<int, std::string> which;  ///< index in the file, or name: several may have it
  std::string variant;                   ///< KHR_materials_variants name that materials are drawn in; empty = none
};

}  // namespace telar
