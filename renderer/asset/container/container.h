#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "asset/check/warnings.h"
#include "telar/limits.h"

namespace telar::asset {

/// The parts of a .glb or .gltf file; both point into the file's bytes.
struct Container {
  std::string_view json;
  std::uint64_t jsonOffset = 0;    ///< bytes from the start of the file
  std::span<const std::byte> bin;  ///< GLB's BIN chunk
  bool hasBin = false;
};

/// Splits a file by its magic bytes, never by its name.
/// @throws Error{E_EMPTY, E_NOT_GLTF, E_JSON, E_GLB_HEADER, E_GLB_VERSION, E_GLB_LENGTH, E_GLB_CHUNK, L_FILE_BYTES,
///         L_JSON_BYTES} with the byte offset. src: glTF 2.0 specification, section 4.4 "Binary glTF Layout"
Container openContainer(std::span<const std::byte> file, const Limits& limits, Warnings& warnings);

}  // namespace telar::asset
