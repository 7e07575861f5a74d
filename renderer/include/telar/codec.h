#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/half.h"
#include "telar/image.h"
#include "telar/limits.h"
#include "telar/shot/output.inc"

/// Image files in and out. PNG, JPEG, WebP and TIFF go through their own libraries; .exr and PNG with an ICC profile go
/// through OpenImageIO, which lives with libtiff in a library of our own (libtelar_oiio.so) that is loaded when first
/// needed. .hdr needs none.
namespace telar {

struct ImageHeader {
  std::uint32_t width = 0, height = 0;  ///< upright, as decodeImage() gives them
  std::string mimeType;                 ///< by magic bytes, not by name
  unsigned texelBytes = 4;              ///< of a decoded texel
  std::string format;                   ///< for people: "PNG"
};

/// Reads only the header. @throws Error{E_IMAGE_FORMAT, E_IMAGE_CORRUPT, L_IMAGE_*}
ImageHeader readImageHeader(std::span<const std::byte> file, const Limits& limits);

/// Decodes PNG, JPEG, WebP or KTX2 (by magic bytes) to RGBA, 8-bit but for some KTX2. KTX2 as ktx2/decode.h says; the
/// others exactly as Chromium hands them to WebGL with colorSpaceConversion "none" and premultiplyAlpha "none": 16-bit
/// PNG to its high byte, grey and palette expanded, embedded profiles ignored, EXIF orientation applied to JPEG and PNG
/// but not to WebP (measured; three.js loads so). Limits are checked on the header before a pixel is allocated; a
/// truncated or damaged file is an error.
Image8 decodeImage(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel);

/// Why .exr, TIFF and ICC profiles cannot be had here; empty where they can. Never throws.
std::string failureOfImageFiles();

/// The key `output` of a shot.
using OutputOptions = shot::Output;

/// Which frame encode() wants for these options.
PixelType framePixelType(const OutputOptions& options);

/// Encodes a frame; deterministic. JPEG has no alpha: the caller draws on an opaque background.
/// @throws Error{X_OUTPUT, X_LIBRARY_MISSING}
std::vector<std::byte> encode(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);

/// Bytes of the caller's environment file. @throws Error{E_ENVIRONMENT_MISSING, L_FILE_BYTES} that name the file alone:
/// where it lies on the server is nobody's business
std::vector<std::byte> readEnvironmentFile(const std::filesystem::path& file, const Limits& limits);
/// Bytes of the bundled studio. @throws Error{X_INSTALL}
std::vector<std::byte> readStudioFile(const std::filesystem::path& assetDirectory, const Limits& limits);

/// How bright the texels of an environment may be.
enum class EnvironmentRange {
  kHalf,  ///< up to 65504, the largest half: what three.js has of the file
  kFull,  ///< up to 1e20, so that a sun keeps its light; infinity is the largest half all the same
};

/// Reads an equirectangular .hdr or .exr (by magic bytes) to linear Rec.709. NaN becomes 0, values are clamped to
/// [0, the range's end]; those that a half can hold are halves. .hdr texels equal three.js HDRLoader's: mantissa / 255
/// * 2^(exponent - 128).
/// @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT, L_ENVIRONMENT_PIXELS, X_LIBRARY_MISSING}
ImageF readEnvironment(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                       EnvironmentRange range = EnvironmentRange::kHalf);

}  // namespace telar
