#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace telar::ktx2 {

using Texels4x4 = std::array<std::array<std::uint8_t, 4>, 16>;  ///< RGBA, rows from the top

/// Decodes one block of UASTC LDR 4x4, as linear (not sRGB) ASTC is decoded, to 8 bits. src: Khronos Data Format
/// Specification 1.3, chapters "UASTC" and "ASTC".
/// @return false for a block that no encoder may write; `out` is then left as it is
bool decodeUastcBlock(std::span<const std::uint8_t, 16> block, Texels4x4& out);

}  // namespace telar::ktx2
