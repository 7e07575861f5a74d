#pragma once
#include <string>
#include <vector>

#include "image/bytes.h"
#include "telar/cancel.h"
#include "telar/codec.h"

/// What OpenImageIO does for us, through libtelar_oiio.so. Each call loads it unless it is loaded; it is looked for in
/// the environment variable TELAR_LIBRARY_DIR when that is set, else beside the file that holds this code.
/// All throw Error{X_LIBRARY_MISSING, X_CANCELLED} and std::bad_alloc.
namespace telar::image {

/// PNG with ICC profile, TIFF, EXR. @throws Error{X_OUTPUT}
std::vector<std::byte> encodeWithOiio(const Frame& frame, const OutputOptions& options, const CancelToken& cancel);

/// A channel of an EXR file.
struct Channel {
  std::string name;
  int bitDepth = 32;  ///< 16 or 32, float
};
/// EXR. @param pixels  as many floats a pixel as there are channels    @param effort  0 to 9    @throws Error{X_OUTPUT}
std::vector<std::byte> encodeChannels(std::uint32_t width, std::uint32_t height, const std::vector<float>& pixels,
                                      const std::vector<Channel>& channels, int effort, const CancelToken& cancel);

/// Bytes of an sRGB ICC profile, the same in every call.
std::vector<std::byte> srgbProfile();

/// R, G and B of an .exr file, whose size the caller took from the header and allowed. A is left 0.
/// @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT}
ImageF readExr(Bytes file, std::uint32_t width, std::uint32_t height, const CancelToken& cancel);

}  // namespace telar::image
