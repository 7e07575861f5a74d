#pragma once
#include <string>
#include <vector>

#include "oiio/plugin.h"

namespace telar::oiio {

/// What became of a TIFF: its bytes, or what libtiff says.
struct TiffFile {
  std::vector<std::uint8_t> bytes;
  std::string failure;
  bool cancelled = false;
};

/// Writes a TIFF by libtiff itself. OpenImageIO 2.4 would add the present time, so that no two files were alike, and a
/// directory of EXIF values, to which the header of a file that is written to memory then points: libtiff and sharp
/// find no picture in such a file. src: TIFF 6.0 (Adobe, 1992), sections 7, 14 and 18; 16 bit repeats each byte (v *
/// 257).
/// @throws std::bad_alloc
TiffFile writeTiff(const TelarOiioWrite& job);

}  // namespace telar::oiio
