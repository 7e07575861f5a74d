#pragma once
#include <vector>

#include "asset/document/document.h"

namespace telar::asset {

/// Reads one material. Faults that only change its look slightly become warnings (W_RANGE, W_ENUM, W_SAMPLER,
/// W_TEXCOORD, W_TEXTURE) and take the default; a texture's image index is the one of the file.
Material readMaterial(int material, const Document& document, Warnings& warnings);

struct TextureUse {
  TextureRef* texture;
  bool color;  ///< read as a colour, else as data
};

/// The textures that shading of this material reads.
std::vector<TextureUse> texturesOf(Material& material);

}  // namespace telar::asset
