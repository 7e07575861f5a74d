#include "ktx2/raw_formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "ktx2/ktx2_files.h"

namespace telar::test {
namespace {

constexpr std::uint32_t RGB8 = 23, R16F = 76, RGBA16 = 91, RGBA16F = 97, R32F = 100, RGBA32F = 109, B10G11R11 = 122,
                        E5B9G9R9 = 123;
constexpr std::size_t LEVEL_OFFSET = 80;

template <class T>
File bytesOf(std::initializer_list<T> values) {
  File out(values.size() * sizeof(T));
  std::memcpy(out.data(), values.begin(), out.size());
  return out;
}

/// One texel.
Ktx2Fields texel(std::uint32_t vkFormat, const File& bytes) {
  Ktx2Fields fields = oneBlock();
  fields.vkFormat = vkFormat;
  fields.model = 1;
  fields.width = fields.height = 1;
  fields.levels = {{bytes, bytes.size()}};
  return fields;
}

glm::vec4 decoded(const Ktx2Fields& fields) {
  const auto image = ktx2::decode(fields.write(), {}, {});
  EXPECT_EQ(image.pixels.size(), texelBytes(image.type));
  glm::vec4 out(0);
  if (image.type == TexelType::kFloat) std::memcpy(&out, image.pixels.data(), sizeof out);
  if (image.type != TexelType::kHalf) return out;
  std::uint64_t halves = 0;
  std::memcpy(&halves, image.pixels.data(), sizeof halves);
  return glm::unpackHalf4x16(halves);
}

TEST(RawFormats, ValuesAreExact) {
  EXPECT_EQ(decoded(texel(RGBA16, bytesOf<std::uint16_t>({0, 1, 32768, 65535}))),
            glm::vec4(0, 1 / 65535.0f, 32768 / 65535.0f, 1));
  EXPECT_EQ(decoded(texel(R16F, bytesOf<std::uint16_t>({0x7bff}))), glm::vec4(65504, 0, 0, 1));
  EXPECT_EQ(decoded(texel(RGBA16F, bytesOf<std::uint16_t>({0x0001, 0x8400, 0xfbff, 0}))),
            glm::vec4(std::ldexp(1.0f, -24), -std::ldexp(1.0f, -14), -65504, 0));
  EXPECT_EQ(decoded(texel(R32F, bytesOf<float>({-1e30f}))), glm::vec4(-1e30f, 0, 0, 1));
  EXPECT_EQ(decoded(texel(E5B9G9R9, bytesOf<std::uint32_t>({0xffffffff}))), glm::vec4(65408, 65408, 65408, 1));
  EXPECT_EQ(decoded(texel(E5B9G9R9, bytesOf<std::uint32_t>({1}))), glm::vec4(std::ldexp(1.0f, -24), 0, 0, 1));
  // The largest: exponent 30, all bits of the mantissa.
  EXPECT_EQ(decoded(texel(B10G11R11, bytesOf<std::uint32_t>({0x7bfu | 0x7bfu << 11 | 0x3dfu << 22}))),
            glm::vec4(65024, 65024, 64512, 1));
}

TEST(RawFormats, TexelsThatAreNoNumbersAreRefused) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {infinity, -infinity, nan}) {
    EXPECT_EQ(codeOf(texel(R32F, bytesOf({bad})).write()), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(texel(RGBA32F, bytesOf({0.0f, 0.0f, 0.0f, bad})).write()), "E_IMAGE_CORRUPT");
  }
  for (const std::uint16_t bad : {0x7c00, 0xfc00, 0x7e01}) {
    EXPECT_EQ(codeOf(texel(R16F, bytesOf({bad})).write()), "E_IMAGE_CORRUPT");
  }
  for (const std::uint32_t bad : {0x7c0u, 0x7c0u << 11, 0x3e0u << 22, 0xffffffffu}) {
    EXPECT_EQ(codeOf(texel(B10G11R11, bytesOf({bad})).write()), "E_IMAGE_CORRUPT");
  }
}

TEST(RawFormats, WhatTheLoaderRefusesIsNamed) {
  const std::string message = messageOf(texel(RGB8, File(3)).write());
  EXPECT_EQ(codeOf(texel(RGB8, File(3)).write()), "E_IMAGE_FORMAT");
  EXPECT_EQ(
      message,
      "the KTX2 image is in the format RGB8, which three.js 0.187 refuses as well; use a 2D texture in ETC1S, UASTC "
      "or RGBA8");
  for (const std::uint32_t format : {10u, 29u, 38u, 44u, 50u, 70u, 77u, 84u, 90u, 92u, 98u, 101u, 106u}) {
    EXPECT_EQ(codeOf(texel(format, File(16)).write()), "E_IMAGE_FORMAT") << format;
  }
}

TEST(RawFormats, SizesAreCheckedBeforeTexelsAre) {
  EXPECT_EQ(codeOf(texel(RGBA32F, File(15)).write()), "E_IMAGE_CORRUPT");
  EXPECT_EQ(codeOf(texel(RGBA32F, File(17)).write()), "E_IMAGE_CORRUPT");
  Ktx2Fields huge = texel(RGBA32F, File(16));
  huge.width = huge.height = 8192;
  EXPECT_EQ(codeOf(huge.write()), "E_IMAGE_CORRUPT");
  huge.supercompression = 2;
  huge.levels[0].uncompressed = ~std::uint64_t{0};
  EXPECT_EQ(codeOf(huge.write()), "E_IMAGE_CORRUPT");
}

TEST(RawFormats, ALimitOfBytesCountsWhatATexelTakes) {
  const File file = texel(RGBA32F, File(16)).write();
  EXPECT_EQ(ktx2::readHeader(file, {}).texelBytes, 16u);
  EXPECT_EQ(ktx2::readHeader(texel(E5B9G9R9, File(4)).write(), {}).texelBytes, 8u);
  EXPECT_EQ(ktx2::readHeader(oneBlock().write(), {}).texelBytes, 4u);
  Limits limits;
  limits.imageBytes = 15;
  try {
    readImageHeader(file, limits);
    ADD_FAILURE() << "16 bytes are over a limit of 15";
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "L_IMAGE_BYTES");
  }
}

TEST(RawFormats, LevelsOfNumbersStartAtAMultiple) {
  File file = texel(R32F, bytesOf<float>({1.0f})).write();
  file.push_back(std::byte{0});
  std::uint64_t offset = 0;
  std::memcpy(&offset, file.data() + LEVEL_OFFSET, sizeof offset);
  put(file, LEVEL_OFFSET, offset + 1, 8);
  EXPECT_EQ(codeOf(file), "E_IMAGE_CORRUPT");
}

TEST(RawFormats, LevelsThatAreMissingAreKnown) {
  Ktx2Fields fields = texel(R32F, bytesOf<float>({1.0f, 1.0f}));
  fields.width = 2;
  EXPECT_EQ(ktx2::decode(fields.write(), {}, {}).missingLevels, MissingLevels::kBlack);
  fields.vkFormat = RGBA16F;
  fields.width = 1;
  EXPECT_EQ(ktx2::decode(fields.write(), {}, {}).missingLevels, MissingLevels::kClear);
  EXPECT_EQ(ktx2::decode(oneBlock().write(), {}, {}).missingLevels, MissingLevels::kNone);
}

}  // namespace
}  // namespace telar::test
