#pragma once
#include <string>

#include "asset/material/texture_ref.h"

namespace telar::asset {

/// Reads the KHR_materials_* extensions of one material as three.js 0.187's GLTFLoader does; textures of a layer whose
/// factor is 0 are left out, because nothing reads them. Values out of their range are clamped with W_RANGE.
/// @param where JSON pointer of `extensions`
/// @return whether GLTFLoader makes the material a MeshPhysicalMaterial
bool readPhysicalLayers(const tinygltf::ExtensionMap& extensions, const std::string& where, TextureReader& textures,
                        Warnings& warnings, PhysicalLayers& out);

}  // namespace telar::asset
