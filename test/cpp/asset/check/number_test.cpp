#include "asset/check/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace telar::asset {
namespace {

using Wide = unsigned __int128;

/// The same question in arithmetic that cannot wrap: (2^64)^2 < 2^128.
bool fitsExactly(std::uint64_t available, std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
                 std::uint64_t element) {
  if (count == 0) return offset <= available;
  return Wide{offset} + Wide{count - 1} * stride + element <= available;
}

/// Values where wrapping would happen, and their neighbours, as often as plain random ones.
std::uint64_t draw(std::mt19937_64& random) {
  static constexpr std::uint64_t EDGES[] = {0,          1,          4,          12,         252,        0x7fffffff,
                                            0xffffffff, 1ull << 32, 1ull << 53, 1ull << 62, 1ull << 63, ~0ull};
  const std::uint64_t edge = EDGES[random() % std::size(EDGES)] + random() % 5 - 2;
  switch (random() % 4) {
    case 0:
      return edge;
    case 1:
      return random();
    case 2:
      return random() >> random() % 64;
    default:
      return random() % 4096;
  }
}

TEST(Fits, AgreesWithWideArithmetic) {
  std::mt19937_64 random(20261121);
  int yes = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint64_t v[] = {draw(random), draw(random), draw(random), draw(random), draw(random)};
    const bool expected = fitsExactly(v[0], v[1], v[2], v[3], v[4]);
    yes += expected;
    ASSERT_EQ(fits(v[0], v[1], v[2], v[3], v[4]), expected)
        << v[0] << " " << v[1] << " " << v[2] << " " << v[3] << " " << v[4];
  }
  EXPECT_GT(yes, 50'000);  // both answers were really asked for
  EXPECT_LT(yes, 950'000);
}

TEST(ToFloat, SaturatesInsteadOfOverflowing) {
  EXPECT_EQ(toFloat(1e300), std::numeric_limits<float>::max());
  EXPECT_EQ(toFloat(-1e300), std::numeric_limits<float>::lowest());
  EXPECT_EQ(toFloat(0.1), 0.1f);
}

}  // namespace
}  // namespace telar::asset
