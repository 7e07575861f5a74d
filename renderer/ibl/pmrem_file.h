#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ibl/cube.h"

/// A prefiltered cube on disk (.pmrem): header {"TPMR", version, faceSize, levels, key, digest of all the rest}, then
/// one DEFLATE stream of RGB halfs, level by level and face by face, split into byte planes of row differences.
namespace telar::ibl {

/// @param key says of which map it is: the SHA-256 of its file, or "studio"
std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube, std::string_view key);

/// Nothing when the bytes are not a whole, undamaged file of this version and of this key: the caller then prefilters
/// again.
std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file, std::string_view key);

}  // namespace telar::ibl
