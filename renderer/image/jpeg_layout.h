#pragma once
#include "image/bytes.h"

namespace telar::image {

/// What the markers of a JPEG file say, read before libjpeg sees the file.
struct JpegLayout {
  std::uint32_t width = 0, height = 0;
  int precision = 0;  ///< bits per sample
  int components = 0;
  std::uint8_t frame = 0;   ///< start-of-frame marker, 0xc0 baseline .. 0xcf
  int orientation = 1;      ///< EXIF, 1..8
  std::uint64_t scans = 0;  ///< start-of-scan markers
};

/// @param wholeFile false: stop at the first scan, behind which nothing but `scans` changes.
/// @throws Error{E_IMAGE_CORRUPT} when there is no frame header or a segment ends behind the file.
JpegLayout readJpegLayout(Bytes file, bool wholeFile);

}  // namespace telar::image
