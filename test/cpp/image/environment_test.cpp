#include <sys/resource.h>

#include <cmath>
#include <utility>

#include "image/sample_files.h"

using namespace sample;

namespace {

constexpr float HALF_MAX = 65504.0f;

std::vector<float> redsOf(const File& file) {
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

// Four rows of 8 texels, of run lengths: R is one run, G literals, B both; the exponents are those of [1, 2).
TEST(Environment, HdrRunsAreThoseOfFlatRows) {
  const std::vector<std::uint8_t> row{2,   2, 0, 8,   136, 255, 8, 0,   51,  102, 153, 204,
                                      255, 9, 1, 131, 51,  1,   7, 132, 102, 136, 129};
  const std::vector<float> reds = redsOf(flatHdr(8, 1, row));
  EXPECT_EQ(reds, std::vector<float>(8, 2));
  const auto image = telar::readEnvironment(flatHdr(8, 1, row), {}, {});
  const std::vector<std::uint8_t> greens{0, 51, 102, 153, 204, 255, 9, 1}, blues{51, 51, 51, 7, 102, 102, 102, 102};
  for (std::size_t x = 0; x < 8; ++x) {
    const auto same = telar::readEnvironment(flatHdr(1, 1, {255, greens[x], blues[x], 129}), {}, {});
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(image.pixels[x * 4 + c], same.pixels[c]) << x << " " << c;
  }
}

// 128 literals are the most of one code; from 129 on it is a run.
TEST(Environment, HdrCodeOf128IsLiterals) {
  std::vector<std::uint8_t> row{2, 2, 0, 128, 128}, flat;
  for (int x = 0; x < 128; ++x)
    row.push_back(std::uint8_t(2 * x)), flat.insert(flat.end(), {std::uint8_t(2 * x), 0, 0, 129});
  for (const std::uint8_t value : {0, 0, 129}) row.insert(row.end(), {255, value, 129, value});  // runs of 127 and 1
  EXPECT_EQ(redsOf(flatHdr(128, 1, row)), redsOf(flatHdr(128, 1, flat)));
}

TEST(Environment, HdrRunsThatFitNoRowAreRefused) {
  const std::vector<std::uint8_t> whole{2, 2, 0, 8, 136, 1, 136, 1, 136, 1, 136, 129};
  EXPECT_EQ(codeOf([&] { telar::readEnvironment(flatHdr(8, 1, whole), {}, {}); }), "");
  const auto with = [&](std::size_t at, std::uint8_t byte) {
    auto row = whole;
    row[at] = byte;
    return flatHdr(8, 1, row);
  };
  for (const File& file : {with(3, 9), with(4, 137), with(4, 135), with(4, 0), with(4, 128), with(10, 9)})
    EXPECT_EQ(codeOf([&] { telar::readEnvironment(file, {}, {}); }), "E_ENVIRONMENT_CORRUPT");
  for (std::size_t n = 0; n < whole.size(); ++n) {
    const File file = flatHdr(8, 1, {whole.begin(), whole.begin() + long(n)});
    EXPECT_EQ(codeOf([&] { telar::readEnvironment(file, {}, {}); }), "E_ENVIRONMENT_CORRUPT") << n;
  }
}

TEST(Environment, HdrHeaderMayHaveLinesOfWindows) {
  const auto file = [](std::string_view end) {
    std::string text = "#?RADIANCE|# a comment|FORMAT=32-bit_rle_rgbe||-Y 1 +X 2|";
    for (std::size_t at; (at = text.find('|')) != std::string::npos;) text.replace(at, 1, end);
    text.append("\xff\r\n\x80\r\n\xff\x80", 8);
    const auto bytes = std::as_bytes(std::span(text));
    return File(bytes.begin(), bytes.end());
  };
  const std::vector<float> reds = redsOf(file("\n"));
  EXPECT_EQ(redsOf(file("\r\n")), reds);
  EXPECT_EQ(reds[0], 1);
  EXPECT_EQ(codeOf([&] { redsOf(file("\r")); }), "E_ENVIRONMENT_CORRUPT");
}

TEST(Environment, HdrOfAFewBytesAllocatesNoLargePicture) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's own memory is above the limit";
#endif
  const auto tooShort = [] { telar::readEnvironment(flatHdr(8192, 4096, {2, 2, 32, 0}), {}, {}); };
  struct rlimit before;
  getrlimit(RLIMIT_AS, &before);
  const struct rlimit little { 64 << 20, before.rlim_max };
  setrlimit(RLIMIT_AS, &little);
  const std::string code = codeOf(tooShort);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_EQ(code, "E_ENVIRONMENT_CORRUPT");
}

TEST(Environment, HdrNeedsNoLibrary) {
  setenv("TELAR_LIBRARY_DIR", "/nonexistent", 1);
  EXPECT_EQ(codeOf([] { telar::readEnvironment(flatHdr(1, 1, {1, 1, 1, 128}), {}, {}); }), "");
  useBuiltLibrary();
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

// Cubes are made for the longer side.
TEST(Environment, AMapThatIsNoTwiceAsWideAsHighCountsByItsLongerSide) {
  const auto code = [](int width, int height) {
    return codeOf([&] { telar::readEnvironment(flatHdr(width, height, {}), {}, {}); });
  };
  for (const auto& [width, height] : {std::pair{8194, 1}, {16384, 1}, {20000, 4}, {2, 4097}, {2, 20000}, {1, 8192}})
    EXPECT_EQ(code(width, height), "L_ENVIRONMENT_PIXELS") << width << " x " << height;
  // Not too large: what is wrong is that they have no texels.
  for (const auto& [width, height] : {std::pair{8192, 4096}, {8192, 1}, {2, 4096}})
    EXPECT_EQ(code(width, height), "E_ENVIRONMENT_CORRUPT") << width << " x " << height;
  try {
    telar::readEnvironment(flatHdr(16384, 1, {}), {}, {});
  } catch (const telar::Error& error) {
    EXPECT_STREQ(error.what(),
                 "L_ENVIRONMENT_PIXELS: an environment of 16384 x 1 pixels costs as much as one of 16384 x 8192: "
                 "134217728 is over the limit of 33554432; give a smaller map, or raise this limit for files that you "
                 "trust");
    EXPECT_EQ(error.limit->actual, 134217728);
  }
}

TEST(Environment, StopsWhenCancelled) {
  telar::CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(codeOf([&] { telar::readEnvironment(flatHdr(1, 1, {1, 1, 1, 128}), {}, cancel); }), "X_CANCELLED");
}
