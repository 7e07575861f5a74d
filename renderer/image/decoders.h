#pragma once
#include "image/bytes.h"
#include "telar/cancel.h"
#include "telar/codec.h"

/// One decoder a format. Each read*Header() throws E_IMAGE_CORRUPT and allocates nothing; each decode*() expects a file
/// whose header passed checkImageLimits().
namespace telar::image {

ImageHeader readPngHeader(Bytes file);
ImageHeader readJpegHeader(Bytes file);
ImageHeader readWebpHeader(Bytes file);

Image8 decodePng(Bytes file, const CancelToken& cancel);
Image8 decodeJpeg(Bytes file, const Limits& limits, const CancelToken& cancel);
Image8 decodeWebp(Bytes file, const CancelToken& cancel);

/// E_IMAGE_CORRUPT: "PNG image: <what>; export it again".
[[nodiscard]] Error corrupt(std::string_view format, std::string_view what);

/// An image of zeros, so that no byte is left to chance whatever a decoder leaves out.
Image8 blank(const ImageHeader& header);

}  // namespace telar::image
