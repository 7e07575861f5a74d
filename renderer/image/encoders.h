#pragma once
#include "image/bytes.h"
#include "telar/cancel.h"
#include "telar/codec.h"

/// One encoder a format; the frame is RGBA8. All are deterministic.
namespace telar::image {

/// Colour type 6 with an sRGB chunk; 16 bit repeats each byte (v * 257).
std::vector<std::byte> encodePng(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);
/// Leaves alpha out: the frame is opaque. Full-resolution chroma from quality 90 on.
/// @param profile ICC profile, empty = none
std::vector<std::byte> encodeJpeg(const Frame& frame, const OutputOptions& options, std::span<const std::byte> profile,
                                  const CancelToken& cancel);
/// Quality 100 is lossless. Alpha is exact at every quality; where alpha is 0 only quality 100 keeps the colour.
std::vector<std::byte> encodeWebp(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);

}  // namespace telar::image
