#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pass/plan/texture_slots.h"
#include "shader/variant_key.h"
#include "telar/scene.h"

namespace telar::pass {

/// One output of the vertex stage: shaders/material/varyings.glsl, shaders/shadow/varyings.glsl.
struct Varying {
  std::string name;
  int components = 0;             ///< floats; of an array, of all of it
  int elements = 0;               ///< of an array, else 0
  std::vector<std::string> same;  ///< others that have its value
};

/// Those of a program, in the order in which they are captured.
std::vector<Varying> varyingsOf(const shader::VariantKey& key);
/// First component of a map's texture coordinates among them.
std::size_t uvComponent(const shader::VariantKey& key, const TextureSlot& slot);
/// Of each map of a material, in the order of its texture slots, the first one that has the same texture coordinates.
std::vector<std::uint8_t> sharedUvs(const Material& material, const shader::VariantKey& key);
/// Floats of all of them.
std::size_t componentsOf(const std::vector<Varying>& varyings);

/// What stands beside the varyings of a fragment, after them: front, pixel.
constexpr std::size_t FRAGMENT_FACTS = 3;
/// How many of them a program reads, the first ones: none, front, or all.
std::size_t factsOf(const shader::VariantKey& key);
/// Texels of four floats that have all of a fragment.
std::size_t texelsOf(const shader::VariantKey& key);

/// A surface program that reads its varyings from a map, with the text that reads those of the key.
/// @param source  of surface.frag with VISIBILITY_BUFFER
std::string withVaryings(std::string source, const shader::VariantKey& key);

}  // namespace telar::pass
