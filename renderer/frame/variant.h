#pragma once
#include <string>

#include "telar/scene.h"
#include "telar/shading.h"
#include "telar/variant_material.h"

namespace telar::frame {

/// Index of a variant (KHR_materials_variants) by its name; -1 for the file's own materials, whose name is empty.
/// @throws Error{E_VARIANT} that lists the names there are
int variantIndex(const Scene& scene, const std::string& name);

/// What a shading draws of a material, or of glTF's default one: shownMaterial().
/// @param index  of materialIndex()
const Material& materialAt(const Scene& scene, int index, ShadingModel shading);

}  // namespace telar::frame
