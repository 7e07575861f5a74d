#pragma once
#include "image/bytes.h"
#include "telar/image.h"

/// EXIF orientation. Chromium applies it to JPEG and PNG textures (not to WebP), so telar does.
namespace telar::image {

/// @param exif a TIFF structure, "II" or "MM" first (without the "Exif\0\0" of JPEG).
/// @return 1..8 as in the EXIF standard; 1 = upright, also when the tag is missing or damaged.
int readOrientation(Bytes exif);

/// True when columns become rows.
inline bool swapsSides(int orientation) { return orientation >= 5; }

/// Turns the image as stored into the upright one.
Image8 upright(Image8 stored, int orientation);

}  // namespace telar::image
