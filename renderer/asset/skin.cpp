#include "asset/skin.h"

#include <algorithm>

#include "asset/pointer.h"

namespace telar::asset {
namespace {

void checkJoints(int accessor, std::size_t joints, const Accessors& accessors, const std::string& where) {
  const auto& info = accessors.info(accessor);
  const bool integers = info.componentType == COMPONENT_U8 || info.componentType == COMPONENT_U16;
  if (info.type != TINYGLTF_TYPE_VEC4 || !integers) {
    fail("E_SKIN", "joint indices must be VEC4 of unsigned bytes or shorts", where);
  }
  std::vector<std::uint32_t> indices(info.count * 4);
  accessors.readUnsigned(accessor, indices);
  if (std::any_of(indices.begin(), indices.end(), [&](std::uint32_t joint) { return joint >= joints; })) {
    fail("E_SKIN", "a vertex names a joint that the skin does not have", where);
  }
}

}  // namespace

void checkSkin(int skin, int mesh, const Document& document, const Accessors& accessors, const CancelToken& cancel) {
  const auto& source = document.model.skins[static_cast<std::size_t>(skin)];
  const int matrices = source.inverseBindMatrices;
  if (matrices >= 0) {
    const auto& info = accessors.info(matrices);
    if (info.type != TINYGLTF_TYPE_MAT4 || info.componentType != COMPONENT_F32 || info.count < source.joints.size()) {
      fail("E_SKIN", "the inverse bind matrices must be one MAT4 of floats for each joint",
           pointer("skins", skin, "inverseBindMatrices"));
    }
  }
  const auto& primitives = document.model.meshes[static_cast<std::size_t>(mesh)].primitives;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    cancel.check();
    const auto& attributes = primitives[i].attributes;
    const auto found = attributes.find("JOINTS_0");
    if (found == attributes.end() || primitives[i].extensions.contains("KHR_draco_mesh_compression")) continue;
    const auto position = attributes.find("POSITION");
    const std::string where = pointer("meshes", mesh, "primitives", i, "attributes", "JOINTS_0");
    if (position == attributes.end() || accessors.count(position->second) != accessors.count(found->second)) {
      fail("E_ACCESSOR", "the accessor has another number of elements than POSITION", where);
    }
    checkJoints(found->second, source.joints.size(), accessors, where);
  }
}

}  // namespace telar::asset
