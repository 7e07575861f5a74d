#include "image/orientation.h"

#include "image/sample_files.h"

using namespace sample;
using telar::image::readOrientation;
using telar::image::upright;

namespace {

/// A TIFF header and one directory with one entry.
File exif(bool bigEndian, std::uint16_t tag, std::uint16_t type, std::uint16_t value) {
  const std::string big = {'M',
                           'M',
                           0,
                           '*',
                           0,
                           0,
                           0,
                           8,
                           0,
                           1,
                           char(tag >> 8),
                           char(tag),
                           char(type >> 8),
                           char(type),
                           0,
                           0,
                           0,
                           1,
                           char(value >> 8),
                           char(value),
                           0,
                           0};
  const std::string little = {'I',         'I',
                              '*',         0,
                              8,           0,
                              0,           0,
                              1,           0,
                              char(tag),   char(tag >> 8),
                              char(type),  char(type >> 8),
                              1,           0,
                              0,           0,
                              char(value), char(value >> 8),
                              0,           0};
  return bytes(bigEndian ? big : little);
}

/// 3 x 2 texels, each of which holds its number: 0 1 2 / 3 4 5.
telar::Image8 numbered() {
  telar::Image8 image{3, 2, {}};
  for (std::uint8_t i = 0; i < 6; ++i) image.pixels.insert(image.pixels.end(), 4, i);
  return image;
}

std::string drawn(const telar::Image8& image) {
  std::string text;
  for (std::uint32_t i = 0; i < image.width * image.height; ++i) {
    if (i && i % image.width == 0) text += '/';
    text += char('0' + image.pixels[i * 4]);
  }
  return text;
}

}  // namespace

TEST(Orientation, ReadsBothByteOrders) {
  for (std::uint16_t v = 1; v <= 8; ++v) {
    EXPECT_EQ(readOrientation(exif(true, 0x112, 3, v)), v);
    EXPECT_EQ(readOrientation(exif(false, 0x112, 3, v)), v);
  }
}

TEST(Orientation, IsUprightWhenTheTagIsMissingOrWrong) {
  EXPECT_EQ(readOrientation({}), 1);
  EXPECT_EQ(readOrientation(bytes("II*")), 1);
  EXPECT_EQ(readOrientation(exif(true, 0x112, 3, 0)), 1);
  EXPECT_EQ(readOrientation(exif(true, 0x112, 3, 9)), 1);
  EXPECT_EQ(readOrientation(exif(true, 0x112, 4, 6)), 1);
  EXPECT_EQ(readOrientation(exif(true, 0x113, 3, 6)), 1);
  const File whole = exif(false, 0x112, 3, 6);
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_EQ(readOrientation(cut(whole, n)), 1) << n;
  File far = whole;
  far[4] = far[5] = far[6] = far[7] = std::byte{0xff};
  EXPECT_EQ(readOrientation(far), 1);
}

// The eight cases of the EXIF standard: where row 0 and column 0 of the stored image lie in the upright one.
TEST(Orientation, TurnsEachCase) {
  const char* expected[] = {"012/345", "210/543", "543/210", "345/012", "03/14/25", "30/41/52", "52/41/30", "25/14/03"};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    EXPECT_EQ(drawn(upright(numbered(), orientation)), expected[orientation - 1]) << orientation;
  }
}

// A model is laid out by the header, before its images are decoded.
TEST(Orientation, OfJpegIsThatOfTheHeaderWhereverExifStands) {
  const File file = encoded(frame8(40, 24, true), telar::OutputOptions::Format::kJpeg);
  const auto marker = [&](int second) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(file.data());
    std::size_t i = 2;
    while (at[i] != 0xff || at[i + 1] != second) ++i;
    return i;
  };
  const File directory = exif(true, 0x112, 3, 6);
  for (const char fill : {'\0', '\xff'}) {
    const File segment =
        concat({bytes(std::string("\xff\xe1\0", 3) + char(8 + directory.size()) + std::string("Exif\0", 5) + fill),
                directory});
    for (const std::size_t place : {std::size_t{2}, marker(0xc0), marker(0xda)}) {
      const File turned = concat({cut(file, place), segment, File(file.begin() + long(place), file.end())});
      const telar::ImageHeader header = telar::readImageHeader(turned, {});
      const telar::Image8 image = telar::decodeImage(turned, {}, {});
      EXPECT_EQ(header.width, 24u) << place;
      EXPECT_EQ(header.height, 40u) << place;
      EXPECT_EQ(image.width, 24u) << place;
      EXPECT_EQ(image.height, 40u) << place;
    }
  }
}
