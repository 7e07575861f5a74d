#pragma once
#include <string>

#include "asset/document/document.h"

namespace telar::asset {

constexpr double NORMAL_SCALE_MAX = 1e4;

/// Reads the uses that materials make of textures. Both references outlive it.
class TextureReader {
 public:
  TextureReader(const Document& document, Warnings& warnings) : document_(document), warnings_(warnings) {}

  /// @param texture index into the document's textures
  /// @param transform the use's KHR_texture_transform, may be null
  /// @param where JSON pointer of the use
  /// @return no texture, with W_TEXTURE or W_TEXCOORD, where telar cannot draw it; the image index is the file's
  TextureRef read(int texture, int texCoord, const tinygltf::Value* transform, const std::string& where);

  /// The texture info at `key` of a material extension, which is at `where`; no texture where there is none.
  TextureRef read(const tinygltf::Value& extension, const char* key, const std::string& where);

 private:
  Sampler samplerOf(int index);

  const Document& document_;
  Warnings& warnings_;
};

}  // namespace telar::asset
