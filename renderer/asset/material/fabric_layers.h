#pragma once
#include <string>

#include "asset/material/texture_ref.h"

namespace telar::asset {

/// Reads KHR_materials_diffuse_transmission and TELAR_materials_fabric of one material; textures of a layer whose
/// factor is 0 are left out, because nothing reads them. Values out of their range are clamped with W_RANGE, and
/// coverages that sum to more than 1 are scaled down to it.
/// @param front the same material, its factors and base colour texture read
/// @param where JSON pointer of `extensions`
/// @param fabricWhere the same of the object that TELAR_materials_fabric stands in: `extensions` or `extras`
FabricLayers readFabricLayers(const tinygltf::ExtensionMap& extensions, const Material& front, const std::string& where,
                              const std::string& fabricWhere, TextureReader& textures, Warnings& warnings);

/// A back without a colour of its own has that of the front, its texture too.
void colorBack(const Material& front, FabricLayers& fabric);

}  // namespace telar::asset
