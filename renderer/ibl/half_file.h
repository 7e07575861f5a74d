#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace telar::ibl {

/// What a file of half floats says of itself.
struct HalfFileHead {
  char magic[4];
  std::uint32_t version;
  std::uint32_t faceSize;
  std::uint32_t levels;
};

/// Prefiltered environments as bytes: the head, the key, the digest of all the rest, then one DEFLATE stream of RGB
/// halfs, split into byte planes of differences to the texel before.
/// @param rgba  the alpha is left out
/// @param key says of which map it is, up to 64 characters
std::vector<std::byte> packHalfs(const HalfFileHead& head, std::string_view key, std::span<const std::uint16_t> rgba);

/// The head of a whole, undamaged file of this key; nothing otherwise.
std::optional<HalfFileHead> headOf(std::span<const std::byte> file, std::string_view key);

/// RGBA halfs of a file that headOf() took, alpha 1; nothing when they are not that many texels.
std::optional<std::vector<std::uint16_t>> unpackHalfs(std::span<const std::byte> file, std::size_t texels);

}  // namespace telar::ibl
