#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "image/sample_files.h"

using telar::OutputOptions;
using Format = OutputOptions::Format;
using namespace sample;

namespace {

constexpr Format ALL[] = {Format::kPng, Format::kJpeg, Format::kWebp, Format::kTiff, Format::kExr, Format::kRaw};

OutputOptions optionsOf(Format format) {
  OutputOptions options;
  options.format = format;
  options.bitDepth = format == Format::kExr ? 16 : 8;
  return options;
}

telar::Frame frameFor(const OutputOptions& options, std::uint32_t width, std::uint32_t height) {
  return telar::framePixelType(options) == telar::PixelType::kRgba8 ? frame8(width, height) : frame32(width, height);
}

/// Position behind the type of the first PNG chunk of that type; 0 when there is none.
std::size_t findChunk(const File& png, const std::string& type) {
  const std::string text(reinterpret_cast<const char*>(png.data()), png.size());
  const std::size_t found = text.find(type);
  return found == std::string::npos ? 0 : found + 4;
}

std::uint32_t be32At(const File& file, std::size_t i) {
  return std::uint32_t(at(file, i)) << 24 | at(file, i + 1) << 16 | at(file, i + 2) << 8 | at(file, i + 3);
}

double rmsDifference(const telar::Frame& frame, const telar::Image8& image, int channels) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double d = int(frame.pixels[i]) - image.pixels[i];
    if (int(i % 4) < channels) sum += d * d;
  }
  return std::sqrt(sum / (double(image.pixels.size()) / 4 * channels));
}

void expectSamePixels(const telar::Frame& frame, const File& file) {
  const auto image = telar::decodeImage(file, {}, {});
  ASSERT_EQ(image.width, frame.width);
  ASSERT_EQ(image.height, frame.height);
  EXPECT_EQ(std::memcmp(image.pixels.data(), frame.pixels.data(), frame.pixels.size()), 0);
}

}  // namespace

TEST(Encode, PngKeepsEveryByte) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 300u}, {300u, 1u}, {67u, 45u}}) {
    const auto frame = frame8(width, height);
    expectSamePixels(frame, encoded(frame, Format::kPng));
    expectSamePixels(frame, encoded(frame, Format::kPng, 16));
  }
}

TEST(Encode, PngWithProfileKeepsEveryByte) {
  useBuiltLibrary();
  for (const int bits : {8, 16}) {
    auto options = optionsOf(Format::kPng);
    options.icc = true;
    options.bitDepth = bits;
    options.ppi = 300;
    const auto frame = frame8(67, 45);
    const File file = telar::encode(frame, options, {});
    expectSamePixels(frame, file);
    EXPECT_EQ(at(file, 24), bits);
    EXPECT_NE(findChunk(file, "iCCP"), 0u);
    EXPECT_EQ(be32At(file, findChunk(file, "pHYs")), 11811u);
  }
}

TEST(Encode, PngHoldsDensityAndColourSpace) {
  auto options = optionsOf(Format::kPng);
  EXPECT_EQ(findChunk(telar::encode(frame8(4, 4), options, {}), "pHYs"), 0u);
  options.ppi = 300;
  const File file = telar::encode(frame8(4, 4), options, {});
  const std::size_t density = findChunk(file, "pHYs");
  EXPECT_EQ(be32At(file, density), 11811u);  // 300 / 0.0254
  EXPECT_EQ(be32At(file, density + 4), 11811u);
  EXPECT_EQ(at(file, density + 8), 1);
  EXPECT_EQ(at(file, findChunk(file, "sRGB")), 0);
}

TEST(Encode, WebpAt100IsExactAndBelowKeepsAlpha) {
  const auto frame = frame8(67, 45);
  expectSamePixels(frame, encoded(frame, Format::kWebp, 8, 100));
  const auto image = telar::decodeImage(encoded(frame, Format::kWebp, 8, 80), {}, {});
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) ASSERT_EQ(image.pixels[i], int(frame.pixels[i]));
}

TEST(Encode, WebpOfLessAlphaQualityIsSmallerAndCloseInAlpha) {
  auto frame = frame8(67, 45);
  std::uint32_t noise = 1;
  for (std::size_t i = 3; i < frame.pixels.size(); i += 4) {
    frame.pixels[i] = std::byte((noise = noise * 1664525 + 1013904223) >> 24);
  }
  OutputOptions options = optionsOf(Format::kWebp);
  options.quality = 80;
  const auto exact = telar::encode(frame, options, {});
  options.alphaQuality = 20;
  const auto small = telar::encode(frame, options, {});
  EXPECT_LT(small.size(), exact.size());
  const auto image = telar::decodeImage(small, {}, {});
  int worst = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    worst = std::max(worst, std::abs(int(image.pixels[i]) - int(frame.pixels[i])));
  }
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, 32);
  options.quality = 100;
  expectSamePixels(frame, telar::encode(frame, options, {}));
}

TEST(Encode, JpegIsCloseAndDropsChromaOnlyBelow90) {
  const auto frame = frame8(64, 64, true);
  const File fine = encoded(frame, Format::kJpeg, 8, 95), coarse = encoded(frame, Format::kJpeg, 8, 60);
  EXPECT_LT(rmsDifference(frame, telar::decodeImage(fine, {}, {}), 3), 3);
  EXPECT_LT(rmsDifference(frame, telar::decodeImage(coarse, {}, {}), 3), 12);
  // Sampling factors stand in the frame header: ff c0, length, precision, height, width, components, id, factors.
  const auto factors = [](const File& file) {
    for (std::size_t i = 0; i + 11 < file.size(); ++i) {
      if (at(file, i) == 0xff && at(file, i + 1) == 0xc0) return int(at(file, i + 11));
    }
    return 0;
  };
  EXPECT_EQ(factors(fine), 0x11);
  EXPECT_EQ(factors(coarse), 0x22);
}

TEST(Encode, JpegOfWhatIsNotOpaqueIsThatOverBlack) {
  auto frame = frame8(64, 64, true);
  for (std::size_t i = 0; i < frame.pixels.size(); i += 4) {
    frame.pixels[i] = frame.pixels[i + 1] = frame.pixels[i + 2] = std::byte{200};
    frame.pixels[i + 3] = std::byte{64};
  }
  const auto image = telar::decodeImage(encoded(frame, Format::kJpeg, 8, 95), {}, {});
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) ASSERT_NEAR(image.pixels[i], 200 * 64 / 255, 1);
}

TEST(Encode, JpegHoldsDensityAndProfile) {
  useBuiltLibrary();
  auto options = optionsOf(Format::kJpeg);
  options.ppi = 300;
  options.icc = true;
  const File file = telar::encode(frame8(16, 16, true), options, {});
  EXPECT_EQ(at(file, 13), 1);  // JFIF: unit inch, then the two densities
  EXPECT_EQ(at(file, 14) << 8 | at(file, 15), 300);
  const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  EXPECT_NE(text.find("ICC_PROFILE"), std::string::npos);
  EXPECT_NE(text.find("acsp"), std::string::npos);
}

TEST(Encode, RawIsTheFrame) {
  const auto bytes8 = frame8(9, 7);
  EXPECT_EQ(encoded(bytes8, Format::kRaw), bytes8.pixels);
  const auto floats = frame32(9, 7);
  EXPECT_EQ(encoded(floats, Format::kRaw, 32), floats.pixels);
}

TEST(Encode, ExrReadsBackAsItWas) {
  useBuiltLibrary();
  const auto frame = frame32(33, 21);
  std::vector<float> expected(33 * 21 * 4);
  std::memcpy(expected.data(), frame.pixels.data(), frame.pixels.size());
  for (const int bits : {16, 32}) {
    const File file = encoded(frame, Format::kExr, bits);
    const auto image = telar::readEnvironment(file, {}, {});
    ASSERT_EQ(image.pixels.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (i % 4 == 3) continue;
      ASSERT_NEAR(image.pixels[i], expected[i], std::abs(expected[i]) * 1e-3 + 1e-7) << bits;
    }
    const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
    EXPECT_NE(text.find(std::string("chromaticities\0chromaticities\0", 30)), std::string::npos);
  }
}

TEST(Encode, SameBytesEachTime) {
  useBuiltLibrary();
  for (const Format format : ALL) {
    for (const bool icc : {false, true}) {
      auto options = optionsOf(format);
      options.icc = icc;
      options.ppi = 150;
      const auto frame = frameFor(options, 61, 43);
      EXPECT_EQ(telar::encode(frame, options, {}), telar::encode(frame, options, {})) << int(format);
    }
  }
}

TEST(Encode, RefusesWhatDoesNotFit) {
  const auto encodeAs = [](telar::Frame frame, OutputOptions options) {
    return codeOf([&] { telar::encode(frame, options, {}); });
  };
  auto options = optionsOf(Format::kPng);
  EXPECT_EQ(encodeAs(frame32(4, 4), options), "X_OUTPUT");
  EXPECT_EQ(encodeAs({}, options), "X_OUTPUT");
  auto shortFrame = frame8(4, 4);
  shortFrame.pixels.pop_back();
  EXPECT_EQ(encodeAs(shortFrame, options), "X_OUTPUT");
  for (const auto& [format, bits] : {std::pair(Format::kPng, 32), {Format::kJpeg, 16}, {Format::kWebp, 16}}) {
    options = optionsOf(format);
    options.bitDepth = bits;
    EXPECT_EQ(encodeAs(frame8(4, 4), options), "X_OUTPUT") << bits;
  }
  for (const int quality : {0, 101}) {
    options = optionsOf(Format::kJpeg);
    options.quality = quality;
    EXPECT_EQ(encodeAs(frame8(4, 4), options), "X_OUTPUT");
  }
  for (const int effort : {-1, 10}) {
    options = optionsOf(Format::kPng);
    options.effort = effort;
    EXPECT_EQ(encodeAs(frame8(4, 4), options), "X_OUTPUT");
  }
}

/// Slopes with little noise, which more work makes smaller.
telar::Frame smoothFrame(std::uint32_t side) {
  telar::Frame frame = frame8(side, side);
  std::uint32_t noise = 1;
  for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
    const std::size_t x = i / 4 % side, y = i / 4 / side;
    noise = noise * 1664525 + 1013904223;
    frame.pixels[i] = i % 4 == 3 ? std::byte{255} : std::byte((x * (i % 4 + 1) + 2 * y) / 3 + (noise >> 31));
  }
  return frame;
}

TEST(Encode, EffortMakesFilesSmallerOfTheSamePixels) {
  useBuiltLibrary();
  const auto frame = smoothFrame(64);
  const auto sizes = [&](Format format, bool icc) {
    auto options = optionsOf(format);
    options.quality = 100;
    options.icc = icc;
    std::vector<std::size_t> out;
    for (const int effort : {0, 1, 4, 9}) {
      options.effort = effort;
      const File file = telar::encode(frame, options, {});
      if (format != Format::kTiff) expectSamePixels(frame, file);
      out.push_back(file.size());
    }
    return out;
  };
  for (const auto& [format, icc] :
       {std::pair(Format::kPng, false), {Format::kPng, true}, {Format::kWebp, false}, {Format::kTiff, false}}) {
    const auto all = sizes(format, icc);
    EXPECT_LT(std::min(all[2], all[3]), all[1]) << int(format) << " icc " << icc;
    EXPECT_LT(all[1], all[0]) << int(format) << " icc " << icc;
  }
}

TEST(Encode, EffortZeroIsNotCompressed) {
  useBuiltLibrary();
  const auto sizes = [](Format format, const telar::Frame& frame) {
    auto options = optionsOf(format);
    std::array<std::size_t, 2> out{};
    for (int effort = 0; effort < 2; ++effort) {
      options.effort = effort;
      out[static_cast<std::size_t>(effort)] = telar::encode(frame, options, {}).size();
    }
    return out;
  };
  for (const Format format : {Format::kPng, Format::kTiff}) {
    const auto [none, some] = sizes(format, smoothFrame(128));
    EXPECT_GT(none, std::size_t{128 * 128 * 4}) << int(format);
    EXPECT_LT(some, std::size_t{128 * 128 * 4}) << int(format);
  }
  telar::Frame black{64, 64, telar::PixelType::kRgbaF32, File(64 * 64 * 16)};
  const auto [none, some] = sizes(Format::kExr, black);
  EXPECT_GT(none, std::size_t{64 * 64 * 8});
  EXPECT_LT(some, std::size_t{64 * 64 * 8});
}

TEST(Encode, EffortOfJpegAndOfLossyWebp) {
  const auto frame = smoothFrame(128);
  const auto fileOf = [&](Format format, int effort) {
    auto options = optionsOf(format);
    options.effort = effort;
    return telar::encode(frame, options, {});
  };
  // Frame header: c0 baseline, c2 progressive.
  const auto has = [](const File& file, std::uint8_t marker) {
    for (std::size_t i = 0; i + 1 < file.size(); ++i) {
      if (at(file, i) == 0xff && at(file, i + 1) == marker) return true;
    }
    return false;
  };
  const File plain = fileOf(Format::kJpeg, 0), usual = fileOf(Format::kJpeg, 1), most = fileOf(Format::kJpeg, 9);
  EXPECT_LT(usual.size(), plain.size()) << "tables of its own";
  EXPECT_TRUE(has(usual, 0xc0) && !has(usual, 0xc2));
  EXPECT_TRUE(has(most, 0xc2));
  const auto pixels = [](const File& file) { return telar::decodeImage(file, {}, {}).pixels; };
  EXPECT_TRUE(pixels(plain) == pixels(usual) && pixels(usual) == pixels(most));
  EXPECT_LT(fileOf(Format::kWebp, 9).size(), fileOf(Format::kWebp, 0).size());
}

/// libwebp takes long at its highest effort, and asks at each row of blocks whether to go on. What it keeps exactly (alpha, all of a picture without loss) it does in one step.
TEST(Encode, StopsInsideALibraryWhenItsTimeIsUp) {
  OutputOptions options = optionsOf(Format::kWebp);
  options.effort = 9;
  options.quality = 80;
  telar::Frame frame = frameFor(options, 768, 768);
  std::uint32_t random = 1;
  for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
    random = random * 1664525u + 1013904223u;
    frame.pixels[i] = std::byte(i % 4 == 3 ? 255 : random >> 24);
  }
  const auto timeOf = [&](const telar::CancelToken& cancel, const char* code) {
    const telar::CancelToken::Work work(cancel);
    const std::clock_t start = std::clock();
    EXPECT_EQ(codeOf([&] { telar::encode(frame, options, cancel); }), code);
    return std::clock() - start;  // processor time
  };
  const std::clock_t whole = timeOf({}, "");
  EXPECT_LT(timeOf(telar::CancelToken(std::chrono::milliseconds(10)), "X_TIMEOUT"), whole / 2);
}

TEST(Encode, StopsWhenCancelled) {
  useBuiltLibrary();
  telar::CancelToken cancel;
  cancel.cancel();
  for (const Format format : ALL) {
    const auto options = optionsOf(format);
    const auto frame = frameFor(options, 8, 8);
    EXPECT_EQ(codeOf([&] { telar::encode(frame, options, cancel); }), "X_CANCELLED");
  }
}
