#include "asset/document/document.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "asset/check/pointer.h"
#include "asset/document/camera_light.h"
#include "asset/document/extensions.h"
#include "asset/document/fabric_presets.h"
#include "asset/document/json_read.h"
#include "asset/document/schema.h"

namespace telar::asset {
namespace {

using nlohmann::json;

/// Before all other checks, because a glTF 1.0 file fails those with messages that mislead.
void checkVersion(const json& document) {
  const auto asset = document.find("asset");
  if (asset == document.end() || !asset->is_object()) fail("E_SCHEMA", "the property \"asset\" is missing", "/asset");
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string()) {
    fail("E_SCHEMA", "the asset gives no version", "/asset/version");
  }
  const auto& text = version->get_ref<const std::string&>();
  if (text != "2" && !text.starts_with("2.")) {
    fail("E_VERSION", "the asset is glTF " + telar::quoted(text) + ", expected 2.0", "/asset/version");
  }
  const auto least = asset->find("minVersion");
  if (least != asset->end() && least->is_string() && *least != "2.0") {
    fail("E_VERSION",
         "the asset needs glTF " + telar::quoted(least->get_ref<const std::string&>()) + ", telar reads 2.0",
         "/asset/minVersion");
  }
}

std::vector<std::string> texts(const json& document, const char* key) {
  std::vector<std::string> out;
  const auto list = document.find(key);
  if (list == document.end() || !list->is_array()) return out;
  for (const json& item : *list) {
    if (item.is_string()) out.push_back(item.get<std::string>());
  }
  return out;
}

std::optional<std::string> takeUri(json& object) {
  const auto uri = object.find("uri");
  if (uri == object.end()) return std::nullopt;
  return std::move(uri->get_ref<std::string&>());
}

std::vector<BufferSource> takeBuffers(json& reduced) {
  std::vector<BufferSource> out;
  for (json& buffer : reduced["buffers"]) {
    bool fallback = false;
    for (const auto& [name, extension] : buffer["extensions"].items()) {
      fallback = fallback || extension.value("fallback", false);
    }
    out.push_back({takeUri(buffer), buffer["byteLength"].get<std::uint64_t>(), fallback});
  }
  reduced.erase("buffers");
  return out;
}

std::vector<ImageSource> takeImages(json& reduced) {
  std::vector<ImageSource> out;
  for (json& image : reduced["images"]) {
    ImageSource source{takeUri(image), image.value("bufferView", -1), image.value("mimeType", "")};
    if (source.uri.has_value() == (source.bufferView >= 0)) {
      fail("E_SCHEMA", "an image must have either a uri or a bufferView", pointer("images", out.size()));
    }
    out.push_back(std::move(source));
  }
  reduced.erase("images");
  return out;
}

void checkAccessorTypes(const json& reduced) {
  static constexpr std::string_view TYPES[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  const auto accessors = reduced.find("accessors");
  if (accessors == reduced.end()) return;
  for (std::size_t i = 0; i < accessors->size(); ++i) {
    const auto& type = (*accessors)[i]["type"].get_ref<const std::string&>();
    if (std::find(std::begin(TYPES), std::end(TYPES), type) != std::end(TYPES)) continue;
    fail("E_ACCESSOR", "the accessor has the unknown type " + telar::quoted(type), pointer("accessors", i, "type"));
  }
}

/// tinygltf would drop translation, rotation and scale beside a matrix without a word.
void checkTransforms(const json& reduced) {
  const auto nodes = reduced.find("nodes");
  if (nodes == reduced.end()) return;
  for (std::size_t i = 0; i < nodes->size(); ++i) {
    const json& node = (*nodes)[i];
    if (node.contains("matrix") &&
        (node.contains("translation") || node.contains("rotation") || node.contains("scale"))) {
      fail("E_SCHEMA", "a node must have either a matrix or translation, rotation and scale",
           pointer("nodes", i, "matrix"));
    }
    const auto rotation = node.find("rotation");
    if (rotation != node.end() && *rotation == json::array({0.0, 0.0, 0.0, 0.0})) {
      fail("E_SCHEMA", "a rotation must be a unit quaternion, this one is zero", pointer("nodes", i, "rotation"));
    }
  }
}

/// tinygltf refuses a channel whose target has no path, which is no more than a channel that moves nothing.
void writeOutPaths(json& reduced) {
  const auto animations = reduced.find("animations");
  if (animations == reduced.end()) return;
  for (json& animation : *animations) {
    for (json& channel : animation["channels"]) channel["target"].emplace("path", "");
  }
}

/// tinygltf refuses an index accessor without a buffer view, which Draco primitives and all-zero accessors have: they
/// get a stand-in view while it parses.
class StandInView {
 public:
  explicit StandInView(json& reduced) {
    json& views = reduced["bufferViews"];
    if (!views.is_array()) views = json::array();
    view_ = static_cast<int>(views.size());
    views.push_back({{"buffer", 0}, {"byteLength", 1}});
    for (json& accessor : reduced["accessors"]) accessor.emplace("bufferView", view_);
  }

  void remove(tinygltf::Model& model) const {
    model.bufferViews.pop_back();
    for (auto& accessor : model.accessors) {
      if (accessor.bufferView == view_) accessor.bufferView = -1;
    }
  }

 private:
  int view_ = 0;
};

const json* lightList(const json& document) {
  static constexpr const char* PATH[] = {"extensions", "KHR_lights_punctual", "lights"};
  const json* at = &document;
  for (const char* key : PATH) {
    const auto found = at->is_object() ? at->find(key) : at->end();
    if (found == at->end()) return nullptr;
    at = &*found;
  }
  return at;
}

/// Marks the lights that several nodes name, of the scene or not, as GLTFLoader counts them.
void markCopies(Document& document) {
  std::vector<int> uses(document.lights.size());
  for (const tinygltf::Node& node : document.model.nodes) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    if (found == node.extensions.end()) continue;
    const auto light = static_cast<std::size_t>(found->second.Get("light").GetNumberAsInt());
    if (light < uses.size() && ++uses[light] == 2 && document.lights[light]) document.lights[light]->isCopied = true;
  }
}

}  // namespace

Document readDocument(const Container& container, const Limits& limits, const CancelToken& cancel, Warnings& warnings,
                      bool tolerant) {
  json document = readJson(container.json, container.jsonOffset, limits, cancel);
  if (!document.is_object()) {
    throw Error("E_JSON", "the top value of glTF JSON must be an object").atOffset(container.jsonOffset);
  }
  checkVersion(document);
  checkExtensions(texts(document, "extensionsUsed"), texts(document, "extensionsRequired"), warnings, tolerant);

  json reduced = reduce(DOCUMENT_RULE, document, limits, cancel);
  checkAccessorTypes(reduced);
  checkTransforms(reduced);
  Document out;
  const auto cameras = document.find("cameras");
  if (cameras != document.end()) out.cameras = readCameras(*cameras, warnings);
  if (const json* lights = lightList(document)) out.lights = readLights(*lights, warnings);
  document = nullptr;  // the largest part of the memory held here, when buffers are data: URIs

  out.buffers = takeBuffers(reduced);
  out.images = takeImages(reduced);
  out.fabrics = applyFabricPresets(reduced, warnings);
  writeOutPaths(reduced);
  const StandInView standIn(reduced);
  cancel.check();
  out.model = parseModel(reduced.dump());
  standIn.remove(out.model);
  markCopies(out);
  return out;
}

}  // namespace telar::asset
