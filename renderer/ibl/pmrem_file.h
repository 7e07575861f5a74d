#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ibl/atlas.h"
#include "ibl/cube.h"

/// Prefiltered environments on disk (.pmrem), as ibl/half_file.h packs them: cubes ("TPMR", level by level and face by
/// face) and atlases ("TPMA", row by row).
namespace telar::ibl {

/// @param key says of which map it is: the SHA-256 of its file, or "studio"
std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube, std::string_view key);
std::vector<std::byte> packPmrem(const gl::Context& context, const Atlas& atlas, std::string_view key);

/// Nothing when the bytes are not a whole, undamaged file of this version and of this key: the caller then prefilters
/// again.
std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file, std::string_view key);
std::optional<Atlas> unpackAtlas(const gl::Context& context, std::span<const std::byte> file, std::string_view key);

}  // namespace telar::ibl
