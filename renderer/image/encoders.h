#pragma once
#include "image/bytes.h"
#include "telar/cancel.h"
#include "telar/codec.h"

/// One encoder a format; the frame is RGBA8. All are deterministic.
namespace telar::image {

/// Colour type 6 with an sRGB chunk; 16 bit repeats each byte (v * 257).
std::vector<std::byte> encodePng(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);
/// What rows of a PNG file are: whole numbers, the most significant byte first.
struct PngRows {
  std::uint32_t width, height;
  int bitDepth;  ///< 8 or 16
  int channels;  ///< 1 grey, 3 RGB, 4 RGBA
  bool srgb;     ///< says that they are sRGB-encoded
  double ppi;    ///< 0 = not written
  int effort;    ///< 0 to 9
};
std::vector<std::byte> encodePngRows(const PngRows& png, const std::vector<std::uint8_t>& rows,
                                     const CancelToken& cancel);
/// Over black, as a canvas writes it: glass of older releases leaves alpha in a frame with a background. Full-resolution chroma from quality 90 on.
/// @param profile ICC profile, empty = none
std::vector<std::byte> encodeJpeg(const Frame& frame, const OutputOptions& options, std::span<const std::byte> profile,
                                  const CancelToken& cancel);
/// Quality 100 is lossless. Alpha is exact at every quality; where alpha is 0 only quality 100 keeps the colour.
std::vector<std::byte> encodeWebp(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);

}  // namespace telar::image
