#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
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

/// The texels of a file that headOf() took, in their order.
class HalfReader {
 public:
  /// Nothing when they are not that many texels.
  static std::optional<HalfReader> open(std::span<const std::byte> file, std::size_t texels);
  /// The next texels as RGBA halfs, alpha 1; all texels together are at most those of the file.
  void read(std::span<std::uint16_t> rgba);

 private:
  HalfReader(std::unique_ptr<std::uint8_t[]> planes, std::size_t halfs) : planes_(std::move(planes)), halfs_(halfs) {}

  std::unique_ptr<std::uint8_t[]> planes_;  ///< high bytes of all halfs, then the low ones
  std::size_t halfs_, next_ = 0;
  std::array<std::uint16_t, 3> previous_{};
};

}  // namespace telar::ibl
