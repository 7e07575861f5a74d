#include <cmath>

#include "image/sample_files.h"

using namespace sample;

namespace {

constexpr float HALF_MAX = 65504.0f;

std::vector<float> redsOf(const File& file) {
  useBuiltLibrary();
  const auto image = telar::readEnvironment(file, {}, {});
  std::vector<float> reds;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) reds.push_back(image.pixels[i]);
  return reds;
}

/// An uncompressed 32-bit EXR with one row; made here because it holds NaN and infinity.
File exrRow(const std::vector<float>& reds) {
  telar::Frame frame{std::uint32_t(reds.size()), 1, telar::PixelType::kRgbaF32, File(reds.size() * 16)};
  for (std::size_t i = 0; i < reds.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) std::memcpy(frame.pixels.data() + i * 16 + c * 4, &reds[i], 4);
  }
  useBuiltLibrary();
  return encoded(frame, telar::OutputOptions::Format::kExr, 32);
}

}  // namespace

// mantissa / 255 * 2^(exponent - 128), with the bits that a half has no room for dropped.
TEST(Environment, HdrValuesAreThoseOfThree) {
  const std::vector<float> reds = redsOf(flatHdr(4, 1, {255, 0, 0, 128, 255, 0, 0, 129, 51, 0, 0, 130, 9, 9, 9, 0}));
  EXPECT_EQ(reds, (std::vector<float>{1, 2, 0.7998046875f, 0}));
}

TEST(Environment, HdrIsClampedToTheLargestHalf) {
  EXPECT_EQ(redsOf(flatHdr(1, 1, {255, 255, 255, 255})), std::vector<float>{HALF_MAX});
}

TEST(Environment, ExrNanAndInfinityBecomeFinite) {
  const float inf = INFINITY;
  EXPECT_EQ(redsOf(exrRow({NAN, inf, -inf, -1, 1e30f, 0.5f})), (std::vector<float>{0, HALF_MAX, 0, 0, HALF_MAX, 0.5f}));
}

TEST(Environment, AtFullRangeOnlyWhatNoHalfHoldsDiffers) {
  useBuiltLibrary();
  const float inf = INFINITY;
  const auto image = telar::readEnvironment(exrRow({NAN, inf, -inf, 1.6e9f, 1e30f, 0.1f, HALF_MAX}), {}, {},
                                            telar::EnvironmentRange::kFull);
  const std::vector<float> expected{0, HALF_MAX, 0, 1.6e9f, 1e20f, redsOf(exrRow({0.1f}))[0], HALF_MAX};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(image.pixels[i * 4], expected[i]) << i;
}

TEST(Environment, AlphaIsOne) {
  useBuiltLibrary();
  EXPECT_EQ(telar::readEnvironment(exrRow({0.25f}), {}, {}).pixels[3], 1);
}

TEST(Environment, LimitHoldsBeforeTheLibraryIsNeeded) {
  setenv("TELAR_LIBRARY_DIR", "/nonexistent", 1);
  telar::Limits limits;
  limits.environmentPixels = 7;
  EXPECT_EQ(codeOf([&] { telar::readEnvironment(flatHdr(4, 2, {}), limits, {}); }), "L_ENVIRONMENT_PIXELS");
  EXPECT_EQ(codeOf([&] { telar::readEnvironment(flatHdr(2000000000, 2000000000, {}), {}, {}); }),
            "L_ENVIRONMENT_PIXELS");
  useBuiltLibrary();
}

TEST(Environment, StopsWhenCancelled) {
  telar::CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(codeOf([&] { telar::readEnvironment(flatHdr(1, 1, {1, 1, 1, 128}), {}, cancel); }), "X_CANCELLED");
}
