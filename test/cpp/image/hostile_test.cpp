#include "cpu_clock.h"
#include "image/sample_files.h"

using Format = telar::OutputOptions::Format;
using namespace sample;

namespace {

std::string decodeCode(const File& file) {
  return codeOf([&] { telar::decodeImage(file, {}, {}); });
}

std::string environmentCode(const File& file) {
  return codeOf([&] { telar::readEnvironment(file, {}, {}); });
}

bool isOneOf(const std::string& code, std::initializer_list<const char*> allowed) {
  for (const char* one : allowed) {
    if (code == one) return true;
  }
  return false;
}

/// Every image format, small, valid.
std::vector<File> images() {
  const auto frame = frame8(40, 30);
  return {encoded(frame, Format::kPng), encoded(frame, Format::kPng, 16), encoded(frame, Format::kJpeg),
          encoded(frame, Format::kWebp), encoded(frame, Format::kWebp, 8, 100)};
}

/// Seconds of CPU.
double secondsOf(const std::function<void()>& call) {
  const auto start = telar::test::CpuClock::now();
  call();
  return (telar::test::CpuClock::now() - start).count();
}

/// A grey baseline JPEG that ends behind its frame header.
File greyJpegHeader(int side) {
  const std::string size = {char(side >> 8), char(side), char(side >> 8), char(side)};
  return concat(
      {bytes(std::string("\xff\xd8\xff\xc0\x00\x0b\x08", 7)), bytes(size), bytes(std::string("\x01\x01\x11\x00", 4))});
}

/// A progressive JPEG header for a grey image with `scans` empty scans.
File progressive(int scans) {
  File file = bytes(std::string("\xff\xd8\xff\xc2\x00\x0b\x08\x00\x40\x00\x40\x01\x01\x11\x00", 15));
  const File scan = bytes(std::string("\xff\xda\x00\x08\x01\x01\x00\x00\x00\x00", 10));
  for (int i = 0; i < scans; ++i) file.insert(file.end(), scan.begin(), scan.end());
  return concat({file, bytes("\xff\xd9")});
}

}  // namespace

TEST(Hostile, ForeignFormatsAreRefusedByName) {
  for (const char* text : {"", "G", "GIF89a", "BM", "II*", "qoif", "\x89PNG\r\n\x1a", "\xff\xd8", "RIFF....WAVE",
                           "<svg xmlns='http://www.w3.org/2000/svg'/>"}) {
    EXPECT_EQ(decodeCode(bytes(text)), "E_IMAGE_FORMAT") << text;
  }
}

TEST(Hostile, EveryPrefixIsRefused) {
  for (const File& file : images()) {
    for (std::size_t n = 0; n < file.size(); ++n) {
      ASSERT_TRUE(isOneOf(decodeCode(cut(file, n)), {"E_IMAGE_CORRUPT", "E_IMAGE_FORMAT"}))
          << n << " of " << file.size();
    }
    EXPECT_EQ(decodeCode(file), "");
  }
}

TEST(Hostile, EveryFlippedByteGivesPixelsOrATypedError) {
  for (const File& whole : images()) {
    for (std::size_t i = 0; i < whole.size(); i += 3) {
      File file = whole;
      file[i] ^= std::byte(1 + i % 255);
      const std::string code = decodeCode(file);
      ASSERT_TRUE(code.empty() || isOneOf(code, {"E_IMAGE_CORRUPT", "E_IMAGE_FORMAT", "L_IMAGE_DIMENSION",
                                                 "L_IMAGE_PIXELS", "L_IMAGE_BYTES", "L_IMAGE_SCANS"}))
          << code << " at " << i;
    }
  }
}

TEST(Hostile, PngDamageIsFound) {
  const File file = encoded(frame8(40, 30), Format::kPng);
  File badCrc = file;
  badCrc[file.size() - 20] ^= std::byte{1};
  EXPECT_EQ(decodeCode(badCrc), "E_IMAGE_CORRUPT");
  const File noPalette = concat({pngHeader(4, 4, 8, 3), pngChunk("IDAT", bytes("x")), pngChunk("IEND", {})});
  EXPECT_EQ(decodeCode(noPalette), "E_IMAGE_CORRUPT");
  EXPECT_EQ(decodeCode(concat({pngHeader(4, 4, 8, 2), pngChunk("IEND", {})})), "E_IMAGE_CORRUPT");
  EXPECT_EQ(decodeCode(concat({pngHeader(4, 4, 3, 2), pngChunk("IDAT", {}), pngChunk("IEND", {})})), "E_IMAGE_CORRUPT");
  EXPECT_EQ(decodeCode(pngHeader(0, 4, 8, 2)), "E_IMAGE_CORRUPT");
}

TEST(Hostile, BombsAreRefusedAtOnce) {
  const double seconds = secondsOf([] {
    EXPECT_EQ(decodeCode(pngHeader(0x7fffffff, 0x7fffffff, 8, 6)), "L_IMAGE_DIMENSION");
    EXPECT_EQ(decodeCode(pngHeader(8192, 8192, 16, 6)), "E_IMAGE_CORRUPT");  // 512 MiB from 33 bytes
    EXPECT_EQ(decodeCode(greyJpegHeader(0xffdc)), "L_IMAGE_DIMENSION");
    EXPECT_EQ(decodeCode(greyJpegHeader(0x2000)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(decodeCode(progressive(65)), "L_IMAGE_SCANS");
    EXPECT_EQ(decodeCode(progressive(4000)), "L_IMAGE_SCANS");
  });
  EXPECT_LT(seconds, 0.25);
}

TEST(Hostile, UnusualJpegIsRefused) {
  for (const char frame : {'\xc3', '\xc5', '\xc9', '\xca', '\xcf'}) {
    File file = encoded(frame8(16, 16), Format::kJpeg);
    for (std::size_t i = 0; i + 1 < file.size(); ++i) {
      if (at(file, i) == 0xff && at(file, i + 1) == 0xc0) file[i + 1] = std::byte(frame);
    }
    EXPECT_EQ(decodeCode(file), "E_IMAGE_FORMAT");
  }
}

TEST(Hostile, AnimatedWebpIsRefused) {
  const File chunk = bytes(std::string("VP8X\x0a\0\0\0\x02\0\0\0\x03\0\0\x03\0\0", 18));
  const File body = concat({bytes("WEBP"), chunk, bytes(std::string("ANIM\x06\0\0\0\0\0\0\0\0\0", 14))});
  const std::string size = {char(body.size()), 0, 0, 0};
  EXPECT_EQ(decodeCode(concat({bytes("RIFF"), bytes(size), body})), "E_IMAGE_FORMAT");
}

TEST(Hostile, EnvironmentHeadersAreChecked) {
  for (const char* text : {"", "#", "GIF89a", "\x89PNG\r\n\x1a\n", "\x76\x2f\x31"}) {
    EXPECT_EQ(environmentCode(bytes(text)), "E_ENVIRONMENT_FORMAT") << text;
  }
  EXPECT_EQ(environmentCode(bytes("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234")), "E_ENVIRONMENT_FORMAT");
  for (const char* size : {"", "-Y 1", "-Y 1 +X", "-Y 0 +X 1", "+Y 1 +X 1", "-Y 1 +X 1 ", "-Y -1 +X 1",
                           "-Y 99999999999 +X 1", "+X 1 -Y 1"}) {
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + std::string(size) + "\n\1\1\1\1";
    EXPECT_EQ(environmentCode(bytes(head)), "E_ENVIRONMENT_CORRUPT") << size;
  }
}

TEST(Hostile, EveryEnvironmentPrefixIsRefused) {
  useBuiltLibrary();
  const std::vector<std::uint8_t> body(16 * 4 * 4, 130);
  const File hdr = flatHdr(16, 4, body);
  const File exr = encoded(frame32(16, 4), Format::kExr, 16);
  for (const File& file : {hdr, exr}) {
    for (std::size_t n = 0; n < file.size(); ++n) {
      const std::string code = environmentCode(cut(file, n));
      ASSERT_TRUE(isOneOf(code, {"E_ENVIRONMENT_CORRUPT", "E_ENVIRONMENT_FORMAT"}))
          << n << " of " << file.size() << code;
    }
    EXPECT_EQ(environmentCode(file), "");
  }
}

TEST(Hostile, FlippedEnvironmentBytesGiveFiniteTexelsOrATypedError) {
  useBuiltLibrary();
  const File hdr = flatHdr(16, 4, std::vector<std::uint8_t>(16 * 4 * 4, 2));  // reads as a bad run-length header
  const File exr = encoded(frame32(16, 4), Format::kExr, 32);
  for (const File& whole : {hdr, exr}) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      File file = whole;
      file[i] ^= std::byte(1 + i * 7 % 255);
      try {
        for (const float v : telar::readEnvironment(file, {}, {}).pixels) ASSERT_TRUE(v >= 0 && v <= 65504);
      } catch (const telar::Error& error) {
        ASSERT_TRUE(isOneOf(error.code, {"E_ENVIRONMENT_CORRUPT", "E_ENVIRONMENT_FORMAT", "L_ENVIRONMENT_PIXELS"}))
            << error.code << " at " << i;
      }
    }
  }
}
