#include "asset/scene/instances.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "asset/check/pointer.h"
#include "asset/geometry/repair.h"
#include "asset/geometry/sphere.h"
#include "asset/pose/transform.h"

namespace telar::asset {
namespace {

constexpr const char* EXTENSION = "EXT_mesh_gpu_instancing";
constexpr const char* COLOR = "_COLOR_0";

/// Accessors of the extension, by name; null where three.js draws the mesh once.
const tinygltf::Value* attributesOf(int node, const GeometryReader::Sources& from) {
  const auto& model = from.document.model;
  const auto& source = model.nodes[static_cast<std::size_t>(node)];
  const auto found = source.extensions.find(EXTENSION);
  if (found == source.extensions.end() || source.mesh < 0) return nullptr;
  const auto& attributes = found->second.Get("attributes");
  if (attributes.Keys().empty()) return nullptr;
  const auto& primitives = model.meshes[static_cast<std::size_t>(source.mesh)].primitives;
  const bool triangles = std::all_of(primitives.begin(), primitives.end(),
                                     [](const auto& primitive) { return primitive.mode >= MODE_TRIANGLES; });
  return triangles ? &attributes : nullptr;
}

int accessorOf(const tinygltf::Value& attributes, const char* name) {
  return attributes.Has(name) ? attributes.Get(name).GetNumberAsInt() : -1;
}

std::string whereOf(int node, const std::string& name) {
  return pointer("nodes", node, "extensions", EXTENSION, "attributes", name);
}

bool hasType(const std::string& name, const tinygltf::Accessor& info) {
  if (name == COLOR) {
    const bool vector = info.type == TINYGLTF_TYPE_VEC3 || info.type == TINYGLTF_TYPE_VEC4;
    return vector && info.componentType != COMPONENT_U32;
  }
  if (name == "ROTATION") return info.type == TINYGLTF_TYPE_VEC4 && info.componentType != COMPONENT_U32;
  const bool placed = name == "TRANSLATION" || name == "SCALE";
  return !placed || (info.type == TINYGLTF_TYPE_VEC3 && info.componentType != COMPONENT_U32);
}

/// Values of one attribute, `width` floats each; empty where the file has none.
std::vector<float> readAttribute(const tinygltf::Value& attributes, const char* name, const Accessors& accessors) {
  const int accessor = accessorOf(attributes, name);
  if (accessor < 0) return {};
  std::vector<float> out(accessors.count(accessor) * accessors.components(accessor));
  const bool fetched = std::string_view(name) == COLOR;  // the others are read for matrices
  accessors.readFloats(accessor, out, fetched ? Normalizing::kFetched : Normalizing::kDivided);
  return out;
}

bool isFinite(const glm::mat4& matrix) {
  const float* first = &matrix[0][0];
  return std::all_of(first, first + 16, [](float x) { return std::isfinite(x); });
}

/// Centre of the sphere around a primitive's instances, as InstancedMesh.computeBoundingSphere finds it.
glm::dvec3 centerOf(const Primitive& primitive, const std::vector<glm::mat4>& matrices) {
  Sphere all;
  for (const glm::mat4& matrix : matrices)
    all.add(Sphere::around(fileBoundsOf(primitive)).transformed(glm::dmat4(matrix)));
  return all.center;
}

}  // namespace

std::uint64_t countInstances(int node, const GeometryReader::Sources& from) {
  const auto* attributes = attributesOf(node, from);
  if (!attributes) return 1;
  std::uint64_t count = 0;
  for (const std::string& name : attributes->Keys()) {
    const int accessor = accessorOf(*attributes, name.c_str());
    if (!hasType(name, from.accessors.info(accessor))) {
      fail("E_INSTANCING", "the accessor has a type that this attribute of instances cannot have", whereOf(node, name));
    }
    if (count != 0 && from.accessors.count(accessor) != count) {
      fail("E_INSTANCING", "the attributes of the instances have different numbers of elements", whereOf(node, name));
    }
    count = from.accessors.count(accessor);
  }
  return count;
}

std::shared_ptr<const Instances> readInstances(int node, const Mesh& mesh, const GeometryReader::Sources& from) {
  const auto& source = from.document.model.nodes[static_cast<std::size_t>(node)];
  const auto* attributes = attributesOf(node, from);
  if (!attributes) {
    if (source.extensions.contains(EXTENSION)) {
      from.warnings.add("W_INSTANCING", "a mesh of points or lines, or without attributes, is drawn once",
                        pointer("nodes", node, "extensions", EXTENSION));
    }
    return nullptr;
  }
  const std::uint64_t count = countInstances(node, from);
  from.memory.charge(2 * count * (sizeof(glm::mat4) + sizeof(glm::vec3)), pointer("nodes", node));
  const auto loan = from.memory.lend(count * (2 * sizeof(glm::vec3) + 2 * sizeof(glm::vec4)), pointer("nodes", node));
  const auto translations = readAttribute(*attributes, "TRANSLATION", from.accessors);
  const auto rotations = readAttribute(*attributes, "ROTATION", from.accessors);
  const auto scales = readAttribute(*attributes, "SCALE", from.accessors);
  const auto colors = readAttribute(*attributes, COLOR, from.accessors);
  const std::size_t colorWidth = colors.empty() ? 0 : from.accessors.components(accessorOf(*attributes, COLOR));
  Instances out;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 1024 == 0) from.cancel.check();
    Transform place;
    for (int k = 0; k < 3; ++k) {
      if (!translations.empty()) place.translation[k] = translations[i * 3 + static_cast<std::size_t>(k)];
      if (!scales.empty()) place.scale[k] = scales[i * 3 + static_cast<std::size_t>(k)];
    }
    if (!rotations.empty()) {
      const float* q = &rotations[i * 4];
      place.rotation = {q[0], q[1], q[2], q[3]};
    }
    const glm::mat4 matrix(matrixOf(place));
    if (!isFinite(matrix)) continue;
    out.matrices.push_back(matrix);
    if (colorWidth == 0) continue;
    const float* rgb = &colors[i * colorWidth];
    out.colors.emplace_back(rgb[0], rgb[1], rgb[2]);
  }
  if (out.matrices.size() < count) {
    from.warnings.add("W_NONFINITE", std::to_string(count - out.matrices.size()) + " instances are not finite",
                      pointer("nodes", node, "extensions", EXTENSION));
  }
  if (repairColors(out.colors) > 0) {
    from.warnings.add("W_NONFINITE", "colours of instances were out of range and were clamped", whereOf(node, COLOR));
  }
  for (const Primitive& primitive : mesh.primitives) out.centers.push_back(centerOf(primitive, out.matrices));
  const auto morphs = [](const Primitive& p) { return p.deformers && !p.deformers->targets.empty(); };
  if (std::any_of(mesh.primitives.begin(), mesh.primitives.end(), morphs)) {
    from.warnings.add("W_INSTANCING", "three.js cannot draw instances of a mesh with morph targets; telar draws them",
                      pointer("nodes", node));
  }
  if (source.skin >= 0) {
    from.warnings.add("W_SKIN", "the skin of an instanced mesh is not applied, as in three.js",
                      pointer("nodes", node, "skin"));
  }
  return std::make_shared<const Instances>(std::move(out));
}

}  // namespace telar::asset
