#include "asset/assemble.h"

#include <algorithm>
#include <numeric>

#include "asset/extension_value.h"
#include "asset/material.h"
#include "asset/number.h"
#include "asset/pointer.h"
#include "asset/repair.h"
#include "asset/skin.h"
#include "asset/topology.h"
#include "asset/transform.h"

namespace telar::asset {
namespace {

/// Triangles of one draw, from the accessor's count (not read yet).
double triangleCount(int mode, double corners) {
  if (mode == MODE_TRIANGLES) return corners / 3;
  return mode == MODE_STRIP || mode == MODE_FAN ? std::max(0.0, corners - 2) : 0;
}

std::uint64_t trianglesOf(const Primitive& primitive) {
  if (primitive.topology != Topology::kTriangles) return 0;
  return (primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size()) / 3;
}

Bounds worldBounds(const Primitive& primitive, const std::vector<std::uint32_t>& used, const glm::dmat4& world) {
  Bounds out;
  const auto add = [&](const glm::vec3& p) { out.add(glm::dvec3(world * glm::dvec4(glm::dvec3(p), 1.0))); };
  if (used.empty()) std::for_each(primitive.positions.begin(), primitive.positions.end(), add);
  for (const std::uint32_t index : used) add(primitive.positions[index]);
  return out;
}

bool isDrawable(const Bounds& bounds) {
  return !bounds.empty() && asset::isDrawable(glm::vec3(glm::clamp(bounds.min, -1e30, 1e30))) &&
         asset::isDrawable(glm::vec3(glm::clamp(bounds.max, -1e30, 1e30)));
}

}  // namespace

/// Sums of work, from counts alone: nothing has been decoded yet, and accessors may share bytes or have none.
void Assembler::checkWork(const std::vector<Visit>& visits) const {
  double draws = 0, triangles = 0, vertices = 0;
  std::vector<bool> met(model().meshes.size(), false);
  for (const Visit& visit : visits) {
    const int mesh = model().nodes[static_cast<std::size_t>(visit.node)].mesh;
    if (mesh < 0) continue;
    const auto& primitives = model().meshes[static_cast<std::size_t>(mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto& primitive = primitives[i];
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end()) continue;
      const auto points = static_cast<double>(from_.accessors.count(position->second));
      const double corners =
          primitive.indices < 0 ? points : static_cast<double>(from_.accessors.count(primitive.indices));
      if (!met[static_cast<std::size_t>(mesh)]) vertices += points;
      triangles += triangleCount(primitive.mode, corners);
      const std::string where = pointer("meshes", mesh, "primitives", i);
      checkSum("L_VERTICES", static_cast<double>(from_.limits.vertices), vertices, where);
      checkSum("L_TRIANGLES", static_cast<double>(from_.limits.triangles), triangles, where);
      // Lines and points cost their indices too.
      checkSum("L_TRIANGLES", static_cast<double>(from_.limits.triangles), corners / 3, where);
      checkSum("L_DRAW_CALLS", static_cast<double>(from_.limits.drawCalls), ++draws, where);
    }
    met[static_cast<std::size_t>(mesh)] = true;
  }
}

int Assembler::readMesh(int mesh) {
  int& known = meshes_[static_cast<std::size_t>(mesh)];
  if (known >= 0) return known;
  const auto& source = model().meshes[static_cast<std::size_t>(mesh)];
  Mesh out;
  out.name = source.name;
  std::vector<Primitive> primitives;
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    if (auto primitive = geometry_.read(mesh, i)) primitives.push_back(std::move(*primitive));
  }
  out.primitives = std::move(primitives);
  scene_.meshes.push_back(std::move(out));
  return known = static_cast<int>(scene_.meshes.size()) - 1;
}

int Assembler::meshOf(const tinygltf::Node& source, int node) {
  if (source.mesh < 0) return -1;
  if (source.skin >= 0) {
    checkSkin(source.skin, source.mesh, from_.document, from_.accessors, from_.cancel);
    from_.warnings.add("W_SKIN", "skins are not applied; the mesh is drawn in its bind pose",
                       pointer("nodes", node, "skin"));
  }
  return readMesh(source.mesh);
}

int Assembler::lightOf(const tinygltf::Node& source) {
  const auto found = source.extensions.find("KHR_lights_punctual");
  if (found == source.extensions.end()) return -1;
  const auto& light = from_.document.lights[static_cast<std::size_t>(found->second.Get("light").GetNumberAsInt())];
  if (!light) return -1;
  checkLimit("L_LIGHTS", static_cast<double>(from_.limits.lights), static_cast<double>(scene_.lights.size() + 1));
  scene_.lights.push_back(*light);
  return static_cast<int>(scene_.lights.size()) - 1;
}

int Assembler::cameraOf(const tinygltf::Node& source) const {
  return source.camera < 0 ? -1 : cameras_[static_cast<std::size_t>(source.camera)];
}

/// In the file's order, so that a camera's number is the one that users know from the file.
void Assembler::readCameras() {
  for (const auto& camera : from_.document.cameras) {
    cameras_.push_back(camera ? static_cast<int>(scene_.cameras.size()) : -1);
    if (camera) scene_.cameras.push_back(*camera);
  }
}

void Assembler::addNode(const Visit& visit) {
  const auto& source = model().nodes[static_cast<std::size_t>(visit.node)];
  Node out;
  out.name = source.name;
  out.parent = visit.parent;
  out.local = localMatrix(source);
  out.world = visit.parent < 0 ? out.local : scene_.nodes[static_cast<std::size_t>(visit.parent)].world * out.local;
  if (isCollapsed(out.world)) {
    if (source.mesh >= 0) {
      from_.warnings.add("W_SCALE", "the node's scale is zero or not finite, so its mesh is not drawn",
                         pointer("nodes", visit.node));
    }
  } else {
    out.mesh = meshOf(source, visit.node);
    out.light = lightOf(source);
    out.camera = cameraOf(source);
  }
  scene_.nodes.push_back(std::move(out));
}

/// Sums and bounds over all draws; a draw that leaves the range of fp32 is not drawn.
void Assembler::placeMeshes() {
  std::vector<std::vector<std::vector<std::uint32_t>>> used(scene_.meshes.size());
  for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
    for (const auto& p : scene_.meshes[i].primitives) used[i].push_back(usedVertices(p.positions.size(), p.indices));
  }
  for (Node& node : scene_.nodes) {
    if (node.mesh < 0) continue;
    from_.cancel.check();
    const auto mesh = static_cast<std::size_t>(node.mesh);
    const auto& primitives = scene_.meshes[mesh].primitives;
    Bounds bounds;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const Bounds part = worldBounds(primitives[i], used[mesh][i], node.world);
      bounds.min = glm::min(bounds.min, part.min);
      bounds.max = glm::max(bounds.max, part.max);
    }
    if (!isDrawable(bounds)) {
      if (!primitives.empty()) {
        from_.warnings.add("W_NONFINITE", "the mesh of the node " + telar::quoted(node.name) +
                                              " is too far away or too large to draw");
      }
      node.mesh = -1;
      continue;
    }
    scene_.bounds.min = glm::min(scene_.bounds.min, bounds.min);
    scene_.bounds.max = glm::max(scene_.bounds.max, bounds.max);
    scene_.drawCount += primitives.size();
    for (const auto& p : primitives) {
      scene_.vertexCount += p.positions.size();
      scene_.triangleCount += trianglesOf(p);
    }
  }
  if (scene_.bounds.empty() || scene_.bounds.min == scene_.bounds.max) {
    throw Error("E_NO_GEOMETRY", "the scene has nothing to draw: no mesh of more than one point is left");
  }
}

void Assembler::readMaterials() {
  for (std::size_t i = 0; i < model().materials.size(); ++i) {
    if (i % 256 == 0) from_.cancel.check();
    scene_.materials.push_back(readMaterial(static_cast<int>(i), from_.document, from_.warnings));
  }
}

void Assembler::loadImages() {
  const ImageLoader loader(from_.document, from_.resources, from_.limits, from_.cancel, from_.warnings);
  std::vector<int> canonical(from_.document.images.size());
  for (std::size_t i = 0; i < canonical.size(); ++i) canonical[i] = loader.canonical(static_cast<int>(i));
  for (Material& material : scene_.materials) {
    for (TextureRef* texture : texturesOf(material))
      texture->image = canonical[static_cast<std::size_t>(texture->image)];
  }
  std::vector<bool> reached(scene_.materials.size(), false);
  const auto reach = [&](int material) {
    if (material >= 0) reached[static_cast<std::size_t>(material)] = true;
  };
  for (const Mesh& mesh : scene_.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      reach(primitive.material);
      std::for_each(primitive.variantMaterials.begin(), primitive.variantMaterials.end(), reach);
    }
  }
  std::vector<bool> used(from_.document.images.size(), false);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (!reached[i]) continue;
    for (const TextureRef* texture : texturesOf(scene_.materials[i]))
      used[static_cast<std::size_t>(texture->image)] = true;
  }
  scene_.images = loader.load(used);
}

void Assembler::readNames() {
  scene_.generator = model().asset.generator;
  scene_.copyright = model().asset.copyright;
  scene_.extensionsUsed = model().extensionsUsed;
  const std::size_t drawn = model().defaultScene >= 0 ? static_cast<std::size_t>(model().defaultScene) : 0;
  if (!model().scenes.empty()) scene_.name = model().scenes[drawn].name;
  const auto variants = model().extensions.find("KHR_materials_variants");
  if (variants == model().extensions.end()) return;
  for (const auto& variant : arrayOf(variants->second, "variants")) {
    scene_.variants.push_back(variant.Has("name") ? variant.Get("name").Get<std::string>() : std::string());
  }
}

Scene Assembler::assemble() {
  const auto visits = walkScene(model(), from_.limits, from_.cancel, from_.warnings);
  checkWork(visits);
  meshes_.assign(model().meshes.size(), -1);
  readNames();
  readCameras();
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (i % 1024 == 0) from_.cancel.check();
    addNode(visits[i]);
  }
  placeMeshes();
  readMaterials();
  loadImages();
  return std::move(scene_);
}

}  // namespace telar::asset
