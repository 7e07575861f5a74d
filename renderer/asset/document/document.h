#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "asset/container/container.h"
#include "asset/document/tinygltf_model.h"
#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar::asset {

struct BufferSource {
  std::optional<std::string> uri;  ///< none = GLB's BIN chunk
  std::uint64_t byteLength = 0;
  bool fallback = false;  ///< for readers without meshopt: its views are compressed, it need not have bytes
};

struct ImageSource {
  std::optional<std::string> uri;
  int bufferView = -1;  ///< exactly one of uri and bufferView is given
  std::string mimeType;
};

/// Where a material has its TELAR_materials_fabric from.
struct FabricSource {
  bool inExtras = false;
  std::string preset;   ///< that there is; empty = it names none
  int withPreset = -1;  ///< index into the model's materials of the one with its preset, -1 = it names none
};

/// A glTF document whose types, ranges and references are known to be right. What needs the buffers' bytes (views,
/// accessors, indices) or the whole node graph is not checked yet.
struct Document {
  tinygltf::Model model;              ///< without buffers, images, cameras and lights, which are the lists below
  std::vector<FabricSource> fabrics;  ///< by material of the file; the model's further ones are those with presets
  std::vector<BufferSource> buffers;
  std::vector<ImageSource> images;
  std::vector<std::optional<ModelCamera>> cameras;  ///< none = malformed, left out with a warning
  std::vector<std::optional<ModelLight>> lights;
};

/// @param tolerant an unknown extension that is required is a warning
/// @throws Error{E_JSON, E_SCHEMA, E_REF, E_VERSION, E_EXT_REQUIRED, L_*, X_CANCELLED}
Document readDocument(const Container& container, const Limits& limits, const CancelToken& cancel, Warnings& warnings,
                      bool tolerant = false);

}  // namespace telar::asset
