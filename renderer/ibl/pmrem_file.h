#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ibl/cube.h"

/// A prefiltered cube on disk (.pmrem): header {"TPMR", version, faceSize, levels, digest of what follows}, then one
/// DEFLATE stream of RGB halfs, level by level and face by face, split into byte planes of row differences.
namespace telar::ibl {

std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube);

/// Nothing when the bytes are not a whole, undamaged file of this version: the caller then prefilters again.
std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file);

/// Writes beside the target and renames, so that a reader never sees half a file. A cache that cannot be written is not
/// an error: returns false.
bool writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace telar::ibl
