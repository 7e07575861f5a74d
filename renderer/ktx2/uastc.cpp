#include "ktx2/uastc.h"

#include "ktx2/uastc_modes.h"

namespace telar::ktx2 {
namespace {

constexpr unsigned VALUES_MAX = 18;  ///< endpoint values of a block: 3 subsets of RGB
constexpr unsigned WEIGHTS_MAX = 32;

/// Reads a block's bits, lowest first. Every mode uses at most its 128 bits.
class Block {
 public:
  explicit Block(std::span<const std::uint8_t, 16> bytes) : bytes_(bytes) {}

  std::uint32_t bits(unsigned count) {
    std::uint32_t out = 0;
    for (unsigned i = 0; i < count && at_ < 128; ++i, ++at_) out |= (bytes_[at_ >> 3] >> (at_ & 7) & 1u) << i;
    return out;
  }

 private:
  std::span<const std::uint8_t, 16> bytes_;
  unsigned at_ = 0;
};

/// Number of the mode; the number of modes for the one code that means none.
std::size_t modeOf(std::uint8_t first) {
  std::size_t mode = 0;
  while (mode < std::size(UASTC_MODES) &&
         (first & ((1u << UASTC_MODES[mode].codeBits) - 1)) != UASTC_MODES[mode].code) {
    ++mode;
  }
  return mode;
}

/// Bits of `count` digits that are packed into one number (5 digits of base 3, or 3 of base 5, at most).
unsigned packedBits(unsigned radix, unsigned count) {
  constexpr unsigned BASE_3[] = {0, 2, 4, 5, 7, 8}, BASE_5[] = {0, 3, 5, 7};
  return radix == 3 ? BASE_3[count] : BASE_5[count];
}

/// All digits come first, then the plain bits of all values.
void readEndpoints(Block& block, EndpointCode code, unsigned count, std::uint8_t (&out)[VALUES_MAX]) {
  std::uint32_t digits[VALUES_MAX] = {};
  const unsigned together = code.radix == 3 ? 5 : 3;
  for (unsigned first = 0; code.radix > 1 && first < count; first += together) {
    const unsigned size = std::min(together, count - first);
    std::uint32_t packed = block.bits(packedBits(code.radix, size));
    for (unsigned i = 0; i < size; ++i, packed /= code.radix) digits[first + i] = packed % code.radix;
  }
  for (unsigned i = 0; i < count; ++i) out[i] = unquantize(code, block.bits(code.bits), digits[i]);
}

/// A weight as 0..64: its bits repeated to six, and 32 left out.
std::uint32_t weightOf(std::uint32_t value, unsigned bits) {
  std::uint32_t out = 0;
  for (int shift = 6 - static_cast<int>(bits); shift > -static_cast<int>(bits); shift -= static_cast<int>(bits)) {
    out |= shift >= 0 ? value << shift : value >> -shift;
  }
  return out > 32 ? out + 1 : out;
}

/// The first texel of each subset has a weight in the lower half, and one bit less.
void readWeights(Block& block, const UastcMode& mode, std::uint32_t subsets, std::uint32_t (&out)[WEIGHTS_MAX]) {
  unsigned met = 0;  // subsets, by bit
  for (unsigned texel = 0; texel < 16; ++texel) {
    const unsigned subset = 1u << (subsets >> (2 * texel) & 3);
    const bool first = (met & subset) == 0;
    met |= subset;
    for (unsigned plane = 0; plane < mode.planes; ++plane) {
      const std::uint32_t value = block.bits(mode.weightBits - first);
      out[texel * mode.planes + plane] = weightOf(value, mode.weightBits);
    }
  }
}

std::uint8_t mix(std::uint32_t low, std::uint32_t high, std::uint32_t weight) {
  const std::uint32_t from = low << 8 | low, to = high << 8 | high;
  return static_cast<std::uint8_t>((from * (64 - weight) + to * weight + 32) >> 14);
}

void solid(Block& block, Texels4x4& out) {
  for (auto& component : out[0]) component = static_cast<std::uint8_t>(block.bits(8));
  out.fill(out[0]);
}

/// Endpoint values of a component: luminance stands for red, green and blue.
unsigned valueOf(unsigned component, unsigned components) {
  if (components == 2) return component == 3 ? 1 : 0;
  return component;
}

}  // namespace

bool decodeUastcBlock(std::span<const std::uint8_t, 16> bytes, Texels4x4& out) {
  const std::size_t number = modeOf(bytes[0]);
  if (number == std::size(UASTC_MODES)) return false;
  const UastcMode& mode = UASTC_MODES[number];
  Block block(bytes);
  block.bits(mode.codeBits);
  if (number == MODE_SOLID) return solid(block, out), true;
  block.bits(mode.hintBits);
  std::uint32_t subsets = 0;
  if (mode.subsets > 1) {
    subsets = subsetsOf(number, block.bits(mode.subsets == 3 ? 4 : 5));
    if (subsets == 0) return false;
  }
  unsigned second = 4;  // component of the second plane
  if (mode.planes == 2) second = number == MODE_LUMINANCE_2 ? 3 : block.bits(2);
  std::uint8_t ends[VALUES_MAX];
  std::uint32_t weights[WEIGHTS_MAX];
  readEndpoints(block, mode.endpoints, 2u * mode.components * mode.subsets, ends);
  readWeights(block, mode, subsets, weights);
  for (unsigned texel = 0; texel < 16; ++texel) {
    const std::uint8_t* own = ends + (subsets >> (2 * texel) & 3) * 2 * mode.components;
    for (unsigned c = 0; c < 4; ++c) {
      const unsigned value = 2 * valueOf(c, mode.components);
      const bool opaque = c == 3 && mode.components == 3;
      const std::uint32_t weight = weights[texel * mode.planes + (c == second)];
      out[texel][c] = opaque ? 255 : mix(own[value], own[value + 1], weight);
    }
  }
  return true;
}

}  // namespace telar::ktx2
