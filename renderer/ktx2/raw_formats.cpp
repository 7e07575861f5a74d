#include "ktx2/raw_formats.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/unaligned.h"

namespace telar::ktx2 {
namespace {

/// By the values of VkFormat. RGB8 and RGB16 are not among them: KTX2Loader refuses them.
constexpr RawFormat FORMATS[] = {
    {9, "R8", 1, Stored::kByte},         {15, "R8", 1, Stored::kByte},          {16, "RG8", 2, Stored::kByte},
    {22, "RG8", 2, Stored::kByte},       {37, "RGBA8", 4, Stored::kByte},       {43, "RGBA8", 4, Stored::kByte},
    {76, "R16F", 1, Stored::kHalf},      {83, "RG16F", 2, Stored::kHalf},       {91, "RGBA16", 4, Stored::kWord},
    {97, "RGBA16F", 4, Stored::kHalf},   {100, "R32F", 1, Stored::kFloat},      {103, "RG32F", 2, Stored::kFloat},
    {109, "RGBA32F", 4, Stored::kFloat}, {122, "B10G11R11", 3, Stored::kSmall}, {123, "E5B9G9R9", 3, Stored::kShared}};

constexpr std::uint16_t HALF_ONE = 0x3c00, HALF_EXPONENT = 0x7c00;

bool isFinite(std::uint16_t half) { return (half & HALF_EXPONENT) != HALF_EXPONENT; }

/// Reads `count` components of type T at texel `i`, little-endian as this machine is.
template <class T>
void copyComponents(const std::uint8_t* from, unsigned count, T (&texel)[4]) {
  std::memcpy(texel, from, count * sizeof(T));
}

bool readByte(const RawFormat& format, const std::uint8_t* from, std::uint8_t (&texel)[4]) {
  copyComponents(from, format.components, texel);
  return true;
}

bool readHalf(const RawFormat& format, const std::uint8_t* from, std::uint16_t (&texel)[4]) {
  copyComponents(from, format.components, texel);
  return std::all_of(std::begin(texel), std::end(texel), isFinite);
}

bool readFloat(const RawFormat& format, const std::uint8_t* from, float (&texel)[4]) {
  copyComponents(from, format.components, texel);
  return std::all_of(std::begin(texel), std::end(texel), [](float x) { return std::isfinite(x); });
}

bool readWord(const RawFormat& format, const std::uint8_t* from, float (&texel)[4]) {
  std::uint16_t words[4] = {};
  copyComponents(from, format.components, words);
  std::transform(words, words + format.components, texel,
                 [](std::uint16_t x) { return static_cast<float>(x) / 65535.0f; });
  return true;
}

/// Floats of 5 bits exponent and 6 or 5 bits mantissa are the upper bits of a half without its sign.
bool readSmall(const RawFormat&, const std::uint8_t* from, std::uint16_t (&texel)[4]) {
  const auto word = loadUnaligned<std::uint32_t>(from);
  texel[0] = static_cast<std::uint16_t>((word & 0x7ff) << 4);
  texel[1] = static_cast<std::uint16_t>((word >> 11 & 0x7ff) << 4);
  texel[2] = static_cast<std::uint16_t>((word >> 22) << 5);
  return std::all_of(std::begin(texel), std::end(texel), isFinite);
}

/// Mantissa * 2^(exponent - 15 - 9): 9 bits from 2^-24 to 2^7, each of which a half holds.
/// src: OpenGL ES 3.0, section 3.8.3.2, "Encoding of shared exponent"
bool readShared(const RawFormat&, const std::uint8_t* from, std::uint16_t (&texel)[4]) {
  const auto word = loadUnaligned<std::uint32_t>(from);
  for (int c = 0; c < 3; ++c) {
    const auto mantissa = static_cast<float>(word >> (9 * c) & 0x1ff);
    texel[c] = glm::packHalf1x16(std::ldexp(mantissa, static_cast<int>(word >> 27) - 24));
  }
  return true;
}

template <class T>
using Read = bool(const RawFormat& format, const std::uint8_t* from, T (&texel)[4]);

template <class T>
bool expand(const RawFormat& format, Bytes from, std::span<std::uint8_t> to, Read<T> read, T one) {
  const std::uint8_t* source = data(from);
  for (std::size_t at = 0; at < to.size(); at += 4 * sizeof(T), source += format.bytes()) {
    T texel[4] = {0, 0, 0, one};
    if (!read(format, source, texel)) return false;
    std::memcpy(&to[at], texel, sizeof texel);
  }
  return true;
}

}  // namespace

unsigned RawFormat::bytes() const {
  switch (stored) {
    case Stored::kByte:
      return components;
    case Stored::kWord:
    case Stored::kHalf:
      return 2 * components;
    case Stored::kFloat:
      return 4 * components;
    default:
      return 4;
  }
}

TexelType RawFormat::type() const {
  if (stored == Stored::kByte) return TexelType::kByte;
  return stored == Stored::kWord || stored == Stored::kFloat ? TexelType::kFloat : TexelType::kHalf;
}

unsigned RawFormat::alignment() const {
  if (stored == Stored::kByte) return 1;
  return stored == Stored::kWord || stored == Stored::kHalf ? 2 : 4;
}

const RawFormat* rawFormatOf(std::uint32_t vkFormat) {
  const auto* found = std::find_if(std::begin(FORMATS), std::end(FORMATS),
                                   [&](const RawFormat& format) { return format.vkFormat == vkFormat; });
  return found == std::end(FORMATS) ? nullptr : found;
}

bool expandRaw(const RawFormat& format, Bytes from, std::span<std::uint8_t> to) {
  switch (format.stored) {
    case Stored::kByte:
      return expand<std::uint8_t>(format, from, to, readByte, 255);
    case Stored::kHalf:
      return expand<std::uint16_t>(format, from, to, readHalf, HALF_ONE);
    case Stored::kWord:
      return expand<float>(format, from, to, readWord, 1);
    case Stored::kFloat:
      return expand<float>(format, from, to, readFloat, 1);
    case Stored::kSmall:
      return expand<std::uint16_t>(format, from, to, readSmall, HALF_ONE);
    default:
      return expand<std::uint16_t>(format, from, to, readShared, HALF_ONE);
  }
}

}  // namespace telar::ktx2
