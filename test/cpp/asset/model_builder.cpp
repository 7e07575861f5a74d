#include "asset/model_builder.h"

namespace telar::test {
namespace {

void append(Bytes& out, const void* data, std::size_t size) {
  const std::size_t at = out.size();
  out.resize(at + size);
  std::memcpy(out.data() + at, data, size);
}

void appendU32(Bytes& out, std::uint32_t value) { append(out, &value, sizeof value); }

}  // namespace

ModelBuilder::ModelBuilder()
    : doc({{"asset", {{"version", "2.0"}}},
           {"scene", 0},
           {"scenes", {{{"nodes", json::array()}}}},
           {"nodes", json::array()},
           {"meshes", json::array()},
           {"accessors", json::array()},
           {"bufferViews", json::array()}}) {}

std::size_t ModelBuilder::componentsOf(const char* type) {
  const std::string name = type;
  if (name == "SCALAR") return 1;
  return name.starts_with("VEC") ? static_cast<std::size_t>(name[3] - '0') : 16;
}

int ModelBuilder::view(const Bytes& data, int stride) {
  bin.resize((bin.size() + 3) / 4 * 4);
  json view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", data.size()}};
  if (stride > 0) view["byteStride"] = stride;
  doc["bufferViews"].push_back(view);
  bin.insert(bin.end(), data.begin(), data.end());
  return static_cast<int>(doc["bufferViews"].size()) - 1;
}

int ModelBuilder::accessor(int view, int componentType, std::size_t count, const char* type, bool normalized) {
  json accessor = {{"componentType", componentType}, {"count", count}, {"type", type}};
  if (view >= 0) accessor["bufferView"] = view;
  if (normalized) accessor["normalized"] = true;
  doc["accessors"].push_back(accessor);
  return static_cast<int>(doc["accessors"].size()) - 1;
}

json& ModelBuilder::primitive(json attributes) {
  const auto mesh = doc["meshes"].size();
  doc["meshes"].push_back({{"primitives", {{{"attributes", std::move(attributes)}}}}});
  doc["scenes"][0]["nodes"].push_back(doc["nodes"].size());
  doc["nodes"].push_back({{"mesh", mesh}});
  return doc["meshes"][mesh]["primitives"][0];
}

json& ModelBuilder::quad() {
  const int position = accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 5126, "VEC3");
  const int indices = accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, 5123, "SCALAR");
  json& out = primitive({{"POSITION", position}});
  out["indices"] = indices;
  return out;
}

int ModelBuilder::image() {
  const int at = view(pngPixel());
  doc["images"].push_back({{"bufferView", at}, {"mimeType", "image/png"}});
  return static_cast<int>(doc["images"].size()) - 1;
}

Bytes ModelBuilder::glb() const {
  json whole = doc;
  if (!bin.empty()) whole["buffers"] = {{{"byteLength", bin.size()}}};
  return glbOf(whole.dump(), bin);
}

Bytes ModelBuilder::gltf() const {
  json whole = doc;
  whole["buffers"] = {{{"byteLength", bin.size()}, {"uri", "data:application/octet-stream;base64," + base64(bin)}}};
  const std::string text = whole.dump();
  Bytes out;
  append(out, text.data(), text.size());
  return out;
}

Bytes glbOf(const std::string& jsonText, const Bytes& bin) {
  std::string text = jsonText;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  Bytes data = bin;
  data.resize((data.size() + 3) / 4 * 4);
  Bytes out;
  append(out, "glTF", 4);
  appendU32(out, 2);
  appendU32(out, static_cast<std::uint32_t>(12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size())));
  appendU32(out, static_cast<std::uint32_t>(text.size()));
  append(out, "JSON", 4);
  append(out, text.data(), text.size());
  if (data.empty()) return out;
  appendU32(out, static_cast<std::uint32_t>(data.size()));
  append(out, "BIN\0", 4);
  append(out, data.data(), data.size());
  return out;
}

std::string base64(const Bytes& data) {
  static const char* DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < data.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < data.size() ? std::to_integer<std::uint32_t>(data[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= data.size() ? DIGITS[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

Bytes pngPixel() {
  // 1 x 1, 8-bit RGBA (255, 0, 0, 255)
  static const unsigned char PNG[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
      0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00,
      0x0d, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xf0, 0x1f, 0x00, 0x05, 0x00, 0x01, 0xff,
      0x56, 0xc7, 0x2f, 0x0d, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  Bytes out;
  append(out, PNG, sizeof PNG);
  return out;
}

std::shared_ptr<const Scene> load(const Bytes& file, const Limits& limits) { return loadBytes(file, limits, {}); }
std::shared_ptr<const Scene> load(const ModelBuilder& model, const Limits& limits) { return load(model.glb(), limits); }

std::string errorOf(const Bytes& file, const Limits& limits) {
  try {
    load(file, limits);
    return "";
  } catch (const Error& error) {
    return error.code + (error.pointer ? " at " + *error.pointer : "");
  }
}

std::string errorOf(const ModelBuilder& model, const Limits& limits) { return errorOf(model.glb(), limits); }

bool hasWarning(const Scene& scene, const std::string& code) {
  for (const Warning& warning : scene.warnings) {
    if (warning.code == code) return true;
  }
  return false;
}

}  // namespace telar::test
