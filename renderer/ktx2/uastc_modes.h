#pragma once
#include <cstdint>
#include <span>

namespace telar::ktx2 {

/// How the endpoints of a mode are quantised: plain bits, with one digit of base 3 or 5 above them (1 = none).
struct EndpointCode {
  unsigned bits;
  unsigned radix;
};

/// What the mode of a UASTC block says. `code` stands in the lowest `codeBits` bits of the block.
struct UastcMode {
  std::uint8_t code, codeBits;
  std::uint8_t hintBits;  ///< for other targets, after the mode
  std::uint8_t subsets, planes, components;
  std::uint8_t weightBits;
  EndpointCode endpoints;
};

constexpr std::size_t MODE_SOLID = 8;         ///< one colour, no endpoints
constexpr std::size_t MODE_SPLIT = 7;         ///< has patterns of its own
constexpr std::size_t MODE_LUMINANCE_2 = 17;  ///< its second plane is always alpha

/// In the order of their numbers.
constexpr UastcMode UASTC_MODES[19] = {
    {0x01, 4, 15, 1, 1, 3, 4, {6, 3}}, {0x35, 6, 15, 1, 1, 3, 2, {8, 1}}, {0x1d, 5, 15, 2, 1, 3, 3, {4, 1}},
    {0x03, 5, 15, 3, 1, 3, 2, {2, 3}}, {0x13, 5, 15, 2, 1, 3, 2, {3, 5}}, {0x0b, 5, 15, 1, 1, 3, 3, {8, 1}},
    {0x1b, 5, 15, 1, 2, 3, 2, {5, 5}}, {0x07, 5, 15, 2, 1, 3, 2, {3, 5}}, {0x17, 5, 0, 0, 0, 4, 0, {0, 1}},
    {0x0f, 5, 23, 2, 1, 4, 2, {4, 1}}, {0x02, 3, 17, 1, 1, 4, 4, {4, 3}}, {0x00, 2, 17, 1, 2, 4, 2, {4, 3}},
    {0x06, 3, 17, 1, 1, 4, 3, {6, 3}}, {0x1f, 5, 23, 1, 2, 4, 1, {8, 1}}, {0x0d, 5, 23, 1, 1, 4, 2, {8, 1}},
    {0x05, 7, 23, 1, 1, 2, 4, {8, 1}}, {0x15, 6, 23, 2, 1, 2, 2, {8, 1}}, {0x25, 6, 23, 1, 2, 2, 2, {8, 1}},
    {0x09, 4, 15, 1, 1, 3, 5, {5, 1}},
};

/// Subsets of the 16 texels, 2 bits a texel, the top left one lowest. @param pattern as in the block
/// @return 0 (no pattern) for an unknown one
std::uint32_t subsetsOf(std::size_t mode, std::uint32_t pattern);

/// A quantised endpoint value as 8 bits.
std::uint8_t unquantize(EndpointCode code, std::uint32_t bits, std::uint32_t digit);

}  // namespace telar::ktx2
