#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "telar/load.h"

namespace telar::test {

using nlohmann::json;
using Bytes = std::vector<std::byte>;

template <typename T>
Bytes bytesOf(const std::vector<T>& values) {
  Bytes out(values.size() * sizeof(T));
  if (!out.empty()) std::memcpy(out.data(), values.data(), out.size());
  return out;
}

/// Builds small glTF documents: one buffer (GLB's BIN chunk), one scene, and whatever a test adds to `doc`.
class ModelBuilder {
 public:
  ModelBuilder();

  /// Appends data at a multiple of 4 bytes. @return index of the new buffer view
  int view(const Bytes& data, int stride = 0);
  /// @return index of the new accessor
  int accessor(int view, int componentType, std::size_t count, const char* type, bool normalized = false);
  template <typename T>
  int accessor(const std::vector<T>& values, int componentType, const char* type, bool normalized = false) {
    return accessor(view(bytesOf(values)), componentType, values.size() / componentsOf(type), type, normalized);
  }
  /// Adds a node with a mesh of one primitive. @return the primitive
  json& primitive(json attributes);
  /// A quad of 1 x 1 m in the XY plane: 4 vertices, 2 triangles, indexed. @return the primitive
  json& quad();
  /// 1 x 1 PNG. @return index of the new image
  int image();

  Bytes glb() const;
  /// .gltf text whose buffer is a data: URI.
  Bytes gltf() const;

  json doc;
  Bytes bin;

 private:
  static std::size_t componentsOf(const char* type);
};

Bytes glbOf(const std::string& jsonText, const Bytes& bin);
std::string base64(const Bytes& data);
Bytes pngPixel();

std::shared_ptr<const Scene> load(const ModelBuilder& model, const Limits& limits = {});
std::shared_ptr<const Scene> load(const Bytes& file, const Limits& limits = {});

/// Code, and " at <pointer>" where there is one, of the error that loading ends with; "" when it does not.
std::string errorOf(const ModelBuilder& model, const Limits& limits = {});
std::string errorOf(const Bytes& file, const Limits& limits = {});

bool hasWarning(const Scene& scene, const std::string& code);

}  // namespace telar::test
