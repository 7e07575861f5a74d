#include "ktx2/uastc_modes.h"

#include <algorithm>

namespace telar::ktx2 {
namespace {

// The partitions that ASTC shares with BC7, a bit or two a texel; ASTC makes them from the seeds 28, 20, 16, 29, ...
constexpr std::uint16_t TWO_SUBSETS[] = {0xcccc, 0x8888, 0x1111, 0xecc8, 0x377f, 0xfeec, 0x0137, 0x137f,
                                         0xc800, 0x0013, 0xfe80, 0x17ff, 0x0017, 0x00ff, 0xfff0, 0x0fff,
                                         0xff71, 0x8eff, 0x08ce, 0x008c, 0x7310, 0xceff, 0x7331, 0x088c,
                                         0xceef, 0x6666, 0xf00f, 0x5555, 0x0f0f, 0x36c9};
constexpr std::uint16_t SPLIT_SUBSETS[] = {0x00f0, 0x4444, 0x0133, 0xcc80, 0xf0ff, 0x2222, 0xffc8,
                                           0xccce, 0x3c03, 0x00ee, 0x7700, 0x3003, 0x00ce, 0xff80,
                                           0x6fff, 0x1333, 0x11ff, 0x136c, 0x00ef};
constexpr std::uint32_t THREE_SUBSETS[] = {0xa5a50000, 0xaa005555, 0xaa000055, 0x0000aa55, 0x25252525, 0x94949494,
                                           0x58585858, 0x56560202, 0x92929292, 0x55aa0055, 0xa05050a0};

/// One bit a texel to two.
std::uint32_t spread(std::uint16_t bits) {
  std::uint32_t out = 0;
  for (unsigned i = 0; i < 16; ++i) out |= (bits >> i & 1u) << (2 * i);
  return out;
}

template <std::size_t N>
std::uint32_t twoSubsets(const std::uint16_t (&list)[N], std::uint32_t pattern) {
  return pattern < N ? spread(list[pattern]) : 0;
}

/// How ASTC spreads the plain bits between the steps of the digit: bit i of the result is bit `from[i]` of the value,
/// -1 = 0; and the step. src: Khronos Data Format Specification 1.3, table "ASTC color unquantization parameters".
struct Spread {
  EndpointCode code;
  signed char from[9];  ///< lowest first
  unsigned step;
};
constexpr Spread SPREADS[] = {{{2, 3}, {-1, 1, 1, -1, 1, -1, -1, -1, 1}, 93},
                              {{3, 5}, {2, 1, 2, -1, -1, -1, -1, 1, 2}, 26},
                              {{4, 3}, {1, 2, 3, -1, -1, -1, 1, 2, 3}, 22},
                              {{5, 5}, {4, -1, -1, -1, -1, 1, 2, 3, 4}, 6},
                              {{6, 3}, {5, -1, -1, -1, 1, 2, 3, 4, 5}, 5}};

/// Repeats the bits from the top down.
std::uint8_t repeatBits(std::uint32_t value, unsigned bits) {
  std::uint32_t out = 0;
  for (int shift = 8 - static_cast<int>(bits); shift > -static_cast<int>(bits); shift -= static_cast<int>(bits)) {
    out |= shift >= 0 ? value << shift : value >> -shift;
  }
  return static_cast<std::uint8_t>(out);
}

}  // namespace

std::uint32_t subsetsOf(std::size_t mode, std::uint32_t pattern) {
  if (UASTC_MODES[mode].subsets == 3) return pattern < std::size(THREE_SUBSETS) ? THREE_SUBSETS[pattern] : 0;
  return mode == MODE_SPLIT ? twoSubsets(SPLIT_SUBSETS, pattern) : twoSubsets(TWO_SUBSETS, pattern);
}

std::uint8_t unquantize(EndpointCode code, std::uint32_t bits, std::uint32_t digit) {
  if (code.radix == 1) return repeatBits(bits, code.bits);
  const auto* spread = std::find_if(std::begin(SPREADS), std::end(SPREADS), [&](const Spread& s) {
    return s.code.bits == code.bits && s.code.radix == code.radix;
  });
  std::uint32_t plain = 0;
  for (unsigned i = 0; i < 9; ++i) {
    if (spread->from[i] >= 0) plain |= (bits >> spread->from[i] & 1u) << i;
  }
  const std::uint32_t mirror = bits & 1 ? 0x1ff : 0;
  const std::uint32_t value = (digit * spread->step + plain) ^ mirror;
  return static_cast<std::uint8_t>((mirror & 0x80) | (value >> 2));
}

}  // namespace telar::ktx2
