#include "asset/pose/skins.h"

#include <algorithm>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

constexpr std::size_t MATRIX_FLOATS = 16;

}  // namespace

Skin readSkin(int skin, const std::vector<int>& nodes, const GeometryReader::Sources& from) {
  const auto& source = from.document.model.skins[static_cast<std::size_t>(skin)];
  Skin out;
  for (const int joint : source.joints) out.joints.push_back(nodes[static_cast<std::size_t>(joint)]);
  if (std::find(out.joints.begin(), out.joints.end(), -1) != out.joints.end()) {
    from.warnings.add("W_SKIN", "a joint is not in the drawn scene; it stands at the origin, as in three.js",
                      pointer("skins", skin, "joints"));
  }
  out.inverseBindMatrices.assign(out.joints.size(), glm::mat4(1));
  const int matrices = source.inverseBindMatrices;
  if (matrices < 0) return out;
  const auto& info = from.accessors.info(matrices);
  if (info.type != TINYGLTF_TYPE_MAT4 || info.componentType != COMPONENT_F32 || info.count < out.joints.size()) {
    fail("E_SKIN", "the inverse bind matrices must be one MAT4 of floats for each joint",
         pointer("skins", skin, "inverseBindMatrices"));
  }
  float* first = &out.inverseBindMatrices.front()[0][0];
  from.accessors.readFloats(matrices, {first, out.joints.size() * MATRIX_FLOATS});
  return out;
}

}  // namespace telar::asset
