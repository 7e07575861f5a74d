#include "telar/codec.h"

namespace telar {

PixelType framePixelType(const OutputOptions& options) {
  const bool floats = options.format == OutputOptions::Format::kExr ||
                      (options.format == OutputOptions::Format::kRaw && options.bitDepth == 32);
  return floats ? PixelType::kRgbaF32 : PixelType::kRgba8;
}

}  // namespace telar
