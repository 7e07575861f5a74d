#include "image/orientation.h"

#include <utility>

namespace telar::image {
namespace {

constexpr std::uint32_t TAG_ORIENTATION = 0x0112, TYPE_SHORT = 3;
constexpr std::size_t ENTRY_BYTES = 12;

struct TiffReader {
  Bytes bytes;
  bool bigEndian;

  bool has(std::size_t offset, std::size_t length) const {
    return offset <= bytes.size() && length <= bytes.size() - offset;
  }
  std::uint32_t u16(std::size_t offset) const {
    const std::uint8_t* p = data(bytes) + offset;
    return bigEndian ? be16(p) : std::uint32_t{p[1]} << 8 | p[0];
  }
  std::uint32_t u32(std::size_t offset) const {
    return bigEndian ? be32(data(bytes) + offset) : le32(data(bytes) + offset);
  }
};

}  // namespace

int readOrientation(Bytes exif) {
  const bool bigEndian = hasAt(exif, 0, std::string_view("MM\0*", 4));
  if (!bigEndian && !hasAt(exif, 0, std::string_view("II*\0", 4))) return 1;
  const TiffReader tiff{exif, bigEndian};
  if (!tiff.has(4, 4)) return 1;
  const std::size_t directory = tiff.u32(4);
  if (!tiff.has(directory, 2)) return 1;
  const std::uint32_t entries = tiff.u16(directory);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * ENTRY_BYTES;
    if (!tiff.has(entry, ENTRY_BYTES)) return 1;
    if (tiff.u16(entry) != TAG_ORIENTATION || tiff.u16(entry + 2) != TYPE_SHORT || tiff.u32(entry + 4) != 1) continue;
    const std::uint32_t value = tiff.u16(entry + 8);
    if (value >= 1 && value <= 8) return int(value);
  }
  return 1;
}

Image8 upright(Image8 stored, int orientation) {
  if (orientation == 1) return stored;
  const std::size_t w = stored.width, h = stored.height;
  Image8 image{stored.width, stored.height, ZeroedBytes(stored.pixels.size())};
  if (swapsSides(orientation)) std::swap(image.width, image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < image.width; ++x) {
      // Where upright (x, y) lies in the stored image; the cases are those of the EXIF standard.
      std::size_t sx = x, sy = y;
      switch (orientation) {
        case 2:
          sx = w - 1 - x;
          break;
        case 3:
          sx = w - 1 - x, sy = h - 1 - y;
          break;
        case 4:
          sy = h - 1 - y;
          break;
        case 5:
          sx = y, sy = x;
          break;
        case 6:
          sx = y, sy = h - 1 - x;
          break;
        case 7:
          sx = w - 1 - y, sy = h - 1 - x;
          break;
        default:
          sx = w - 1 - y, sy = x;
          break;
      }
      std::memcpy(image.pixels.data() + (y * image.width + x) * 4, stored.pixels.data() + (sy * w + sx) * 4, 4);
    }
  }
  return image;
}

}  // namespace telar::image
