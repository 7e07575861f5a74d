#include "image/jpeg_layout.h"

#include "image/decoders.h"
#include "image/orientation.h"

namespace telar::image {
namespace {

constexpr std::uint8_t SOI = 0xd8, EOI = 0xd9, SOS = 0xda, APP1 = 0xe1, TEM = 0x01;

bool isRestart(std::uint8_t marker) { return marker >= 0xd0 && marker <= 0xd7; }

/// SOF0..SOF15 less DHT (c4), JPG (c8) and DAC (cc), which share the range.
bool isFrame(std::uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// Position of the next marker byte (behind its 0xff) at or after `position`; file.size() when there is none.
/// Passes over entropy-coded data: stuffed zeros and restart markers are no markers there.
std::size_t nextMarker(Bytes file, std::size_t position) {
  const std::uint8_t* p = data(file);
  while (position + 1 < file.size()) {
    const void* found = std::memchr(p + position, 0xff, file.size() - 1 - position);
    if (!found) break;
    position = std::size_t(static_cast<const std::uint8_t*>(found) - p) + 1;
    const std::uint8_t marker = p[position];
    if (marker != 0x00 && marker != 0xff && !isRestart(marker)) return position;
  }
  return file.size();
}

void readFrame(const std::uint8_t* segment, std::size_t length, std::uint8_t marker, JpegLayout& layout) {
  if (length < 8) throw corrupt("JPEG", "the frame header is too short");
  if (layout.frame) throw corrupt("JPEG", "it has two frame headers");
  layout.frame = marker;
  layout.precision = segment[2];
  layout.height = be16(segment + 3);
  layout.width = be16(segment + 5);
  layout.components = segment[7];
  if (!layout.width || !layout.height) throw corrupt("JPEG", "width or height is 0");
}

}  // namespace

JpegLayout readJpegLayout(Bytes file, bool wholeFile) {
  constexpr std::string_view EXIF("Exif\0", 5);
  constexpr std::size_t EXIF_BYTES = EXIF.size() + 1;  // and a byte to fill, of any value
  JpegLayout layout;
  bool hasExif = false;
  const std::uint8_t* p = data(file);
  std::size_t position = 0;
  while ((position = nextMarker(file, position)) < file.size()) {
    const std::uint8_t marker = p[position++];
    if (marker == EOI) break;
    if (marker == SOI || marker == TEM) continue;
    if (file.size() - position < 2) throw corrupt("JPEG", "the file ends too early").atOffset(file.size());
    const std::size_t length = be16(p + position);
    if (length < 2 || length > file.size() - position) {
      throw corrupt("JPEG", "a segment is longer than the file").atOffset(position);
    }
    if (isFrame(marker)) readFrame(p + position, length, marker, layout);
    // Browsers look for EXIF up to the first scan: it may stand behind the frame header.
    if (marker == APP1 && !hasExif && !layout.scans && length >= 2 + EXIF_BYTES && hasAt(file, position + 2, EXIF)) {
      hasExif = true;
      layout.orientation = readOrientation(file.subspan(position + 2 + EXIF_BYTES, length - 2 - EXIF_BYTES));
    }
    if (marker == SOS) ++layout.scans;
    if (layout.scans && !wholeFile) break;
    position += length;
  }
  if (!layout.frame) throw corrupt("JPEG", "it has no frame header");
  return layout;
}

}  // namespace telar::image
