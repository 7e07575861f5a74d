#include <webp/decode.h>

#include <algorithm>
#include <memory>
#include <new>

#include "image/decoders.h"

namespace telar::image {
namespace {

constexpr std::size_t STEP_BYTES = 64 << 10;  // between two looks at the cancel token

WebPBitstreamFeatures readFeatures(Bytes file) {
  // The RIFF length must lie inside the file: a shorter file was cut.
  if (file.size() < 12 || std::uint64_t{le32(data(file) + 4)} + 8 > file.size()) {
    throw corrupt("WebP", "the file ends too early").atOffset(file.size());
  }
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data(file), file.size(), &features) != VP8_STATUS_OK) {
    throw corrupt("WebP", "the header is damaged");
  }
  if (features.has_animation) {
    throw Error("E_IMAGE_FORMAT", "the WebP image is an animation; export one frame as PNG, JPEG or WebP");
  }
  return features;
}

}  // namespace

ImageHeader readWebpHeader(Bytes file) {
  const WebPBitstreamFeatures features = readFeatures(file);
  return {std::uint32_t(features.width), std::uint32_t(features.height), "image/webp"};
}

Image8 decodeWebp(Bytes file, const CancelToken& cancel) {
  Image8 image = blank(readWebpHeader(file));
  const int rowBytes = int(image.width * 4);
  const std::unique_ptr<WebPIDecoder, decltype(&WebPIDelete)> decoder(
      WebPINewRGB(MODE_RGBA, image.pixels.data(), image.pixels.size(), rowBytes), WebPIDelete);
  if (!decoder) throw std::bad_alloc();

  VP8StatusCode status = VP8_STATUS_SUSPENDED;
  for (std::size_t end = 0; status == VP8_STATUS_SUSPENDED && end < file.size();) {
    cancel.check();
    end = std::min(file.size(), end + STEP_BYTES);
    status = WebPIUpdate(decoder.get(), data(file), end);  // sees all bytes up to `end` again, copies none
  }
  if (status == VP8_STATUS_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != VP8_STATUS_OK) throw corrupt("WebP", "the data is damaged or cut");
  return image;
}

}  // namespace telar::image
