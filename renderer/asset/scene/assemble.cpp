#include "asset/scene/assemble.h"

#include <algorithm>

#include "asset/check/number.h"
#include "asset/check/pointer.h"
#include "asset/document/extension_value.h"
#include "asset/material/material.h"
#include "asset/pose/animation.h"
#include "asset/pose/place.h"
#include "asset/pose/skins.h"
#include "asset/pose/transform.h"
#include "asset/scene/instances.h"

namespace telar::asset {
namespace {

/// Triangles, lines or points of one draw, from the accessor's count (not read yet).
double elementCount(int mode, double corners) {
  if (mode == MODE_TRIANGLES) return corners / 3;
  if (mode == MODE_STRIP || mode == MODE_FAN) return std::max(0.0, corners - 2);
  return mode == MODE_LINES ? corners / 2 : corners;
}

/// Of the streams that are drawn.
std::uint64_t bytesOf(const Primitive& primitive) {
  const auto size = [](const auto& stream) { return std::uint64_t{stream.size()} * sizeof(stream[0]); };
  return size(primitive.positions) + size(primitive.normals) + size(primitive.tangents) + size(primitive.uvs[0]) +
         size(primitive.uvs[1]) + size(primitive.colors) + size(primitive.visibility[0]) +
         size(primitive.visibility[1]) + size(primitive.indices);
}

}  // namespace

/// Sums of work, from counts alone: nothing has been decoded yet, and accessors may share bytes or have none.
void Assembler::checkWork(const std::vector<Visit>& visits) const {
  double draws = 0, elements = 0, vertices = 0, instances = 0;
  std::vector<bool> met(model().meshes.size(), false);
  for (const Visit& visit : visits) {
    const auto& node = model().nodes[static_cast<std::size_t>(visit.node)];
    const int mesh = node.mesh;
    if (mesh < 0) continue;
    const auto places = static_cast<double>(countInstances(visit.node, from_));
    instances += places > 1 ? places : 0;
    checkLimit("L_INSTANCES", static_cast<double>(from_.limits.instances), instances, pointer("nodes", visit.node));
    const auto& primitives = model().meshes[static_cast<std::size_t>(mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto& primitive = primitives[i];
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end()) continue;
      const auto points = static_cast<double>(from_.accessors.count(position->second));
      const double corners =
          primitive.indices < 0 ? points : static_cast<double>(from_.accessors.count(primitive.indices));
      const auto targets = static_cast<double>(primitive.targets.size());
      if (!met[static_cast<std::size_t>(mesh)]) vertices += points * (1 + targets);
      if (node.skin >= 0 || targets > 0) vertices += points;  // the deformed copy
      elements += elementCount(primitive.mode, corners) * places;
      const std::string where = pointer("meshes", mesh, "primitives", i);
      checkSum("L_VERTICES", static_cast<double>(from_.limits.vertices), vertices, where);
      checkSum("L_TRIANGLES", static_cast<double>(from_.limits.triangles), elements, where);
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
  out.file = mesh;
  std::vector<Primitive> primitives;
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    if (auto primitive = geometry_.read(mesh, i, joints_[static_cast<std::size_t>(mesh)]))
      primitives.push_back(std::move(*primitive));
  }
  out.primitives = std::move(primitives);
  scene_.meshes.push_back(std::move(out));
  return known = static_cast<int>(scene_.meshes.size()) - 1;
}

/// By mesh: how many joints the smallest of the skins has that move it.
void Assembler::findJoints(const std::vector<Visit>& visits) {
  joints_.assign(model().meshes.size(), 0);
  for (const Visit& visit : visits) {
    const auto& node = model().nodes[static_cast<std::size_t>(visit.node)];
    if (node.mesh < 0 || node.skin < 0) continue;
    auto& joints = joints_[static_cast<std::size_t>(node.mesh)];
    const std::size_t count = model().skins[static_cast<std::size_t>(node.skin)].joints.size();
    joints = joints == 0 ? count : std::min(joints, count);
  }
}

/// Weights of the morph targets as the file stands: the node's over the mesh's.
std::vector<float> Assembler::weightsOf(const tinygltf::Node& source, int node) const {
  std::vector<float> out(morphTargetsOf(model(), node), 0.0f);
  if (out.empty()) return out;
  for (const auto* weights : {&model().meshes[static_cast<std::size_t>(source.mesh)].weights, &source.weights}) {
    for (std::size_t i = 0; i < std::min(out.size(), weights->size()); ++i) out[i] = toFloat((*weights)[i]);
  }
  return out;
}

void Assembler::readMotion(const std::vector<int>& nodes) {
  Motion motion;
  for (std::size_t i = 0; i < model().skins.size(); ++i) {
    from_.cancel.check();
    motion.skins.push_back(readSkin(static_cast<int>(i), nodes, from_));
  }
  motion.animations = AnimationReader(from_, nodes).read();
  if (motion.skins.empty() && motion.animations.empty()) return;
  scene_.motion = std::make_shared<const Motion>(std::move(motion));
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
  out.transform = transformOf(source);
  out.file.node = visit.node;
  out.world = matrixOf(out.transform);
  if (out.parent >= 0) out.world = scene_.nodes[static_cast<std::size_t>(out.parent)].world * out.world;
  // A node that is squeezed to nothing may grow in an animation.
  if (!model().animations.empty() || !isCollapsed(out.world)) {
    out.file.light = lightOf(source);
    out.file.camera = cameraOf(source);
  }
  out.file.mesh = source.mesh;
  scene_.nodes.push_back(std::move(out));
}

/// Reads what the node draws; without an animation, only where it is to be seen. Elsewhere file.mesh only says that
/// there is one.
void Assembler::addMesh(Node& node) {
  if (node.file.mesh < 0 || (model().animations.empty() && isCollapsed(node.world))) return;
  const auto& source = model().nodes[static_cast<std::size_t>(node.file.node)];
  node.file.mesh = readMesh(source.mesh);
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(node.file.mesh)];
  node.instances = readInstances(node.file.node, mesh, from_);
  node.skin = source.skin;
  node.weights = weightsOf(source, node.file.node);
}

void Assembler::readMaterials() {
  for (std::size_t i = 0; i < model().materials.size(); ++i) {
    if (i % 256 == 0) from_.cancel.check();
    // A material with its preset has the faults that it has without.
    const bool again = i >= from_.document.fabrics.size();
    Warnings heard;
    scene_.materials.push_back(readMaterial(static_cast<int>(i), from_.document, again ? heard : from_.warnings));
  }
  scene_.fileMaterials = from_.document.fabrics.size();
}

void Assembler::loadImages() {
  const ImageLoader loader(from_);
  std::vector<int> canonical(from_.document.images.size());
  for (std::size_t i = 0; i < canonical.size(); ++i) canonical[i] = loader.canonical(static_cast<int>(i));
  for (Material& material : scene_.materials) {
    for (const TextureUse& use : texturesOf(material))
      use.texture->image = canonical[static_cast<std::size_t>(use.texture->image)];
  }
  std::vector<bool> reached(scene_.materials.size(), false);
  const auto reach = [&](int material) {
    if (material < 0) return;
    reached[static_cast<std::size_t>(material)] = true;
    const int withPreset = scene_.materials[static_cast<std::size_t>(material)].withPreset;
    if (withPreset >= 0) reached[static_cast<std::size_t>(withPreset)] = true;
  };
  for (const Mesh& mesh : scene_.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      reach(primitive.material);
      for (const auto& [variant, material] : primitive.variantMaterials) reach(material);
    }
  }
  std::vector<ImageUse> uses(from_.document.images.size());
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (!reached[i]) continue;
    for (const TextureUse& use : texturesOf(scene_.materials[i])) {
      ImageUse& image = uses[static_cast<std::size_t>(use.texture->image)];
      (use.color ? image.color : image.data) = true;
      (use.texture->basisu ? image.byBasisu : image.otherwise) = true;
    }
  }
  LoadedImages loaded = loader.load(std::move(uses));
  for (Material& material : scene_.materials) {
    for (const TextureUse& use : texturesOf(material)) {
      use.texture->image = static_cast<int>(loaded.first[static_cast<std::size_t>(use.texture->image)]);
      if (loaded.missing[static_cast<std::size_t>(use.texture->image)]) *use.texture = TextureRef{};
    }
  }
  scene_.images = SharedList<Image8>(std::shared_ptr<const std::vector<Image8>>(std::move(loaded.images)));
  scene_.pendingImages = std::move(loaded.pending);
  scene_.fileImages = scene_.images.size();
}

/// What deforms is copied for the moment that is drawn: at rest, and in a pose where there is one. Each is uploaded.
void Assembler::chargeDeformedCopies() {
  const std::uint64_t moments = scene_.motion && !scene_.motion->animations.empty() ? 2 : 1;
  for (const Node& node : scene_.nodes) {
    if (node.file.mesh < 0 || (node.skin < 0 && node.weights.empty())) continue;
    const auto mesh = static_cast<std::size_t>(node.file.mesh);
    if (mesh >= scene_.meshes.size()) continue;  // left out: see addMesh()
    for (const Primitive& primitive : scene_.meshes[mesh].primitives) {
      if (primitive.deformers) from_.memory.charge(2 * moments * bytesOf(primitive), pointer("nodes", node.file.node));
    }
  }
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
  findJoints(visits);
  std::vector<int> nodes(model().nodes.size(), -1);  // by node of the file
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (i % 1024 == 0) from_.cancel.check();
    nodes[static_cast<std::size_t>(visits[i].node)] = static_cast<int>(i);
    addNode(visits[i]);
  }
  for (Node& node : scene_.nodes) addMesh(node);
  scene_.fileMeshes = scene_.meshes.size();
  readMotion(nodes);
  readMaterials();
  loadImages();
  scene_.fileWarnings = from_.warnings.count();
  chargeDeformedCopies();
  place(scene_, from_.warnings, from_.cancel);
  if (!scene_.motion || scene_.motion->animations.empty()) needGeometry(scene_);
  return std::move(scene_);
}

}  // namespace telar::asset
