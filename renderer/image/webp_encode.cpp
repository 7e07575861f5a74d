#include <webp/encode.h>

#include <new>
#include <string>

#include "image/effort.h"
#include "image/encoders.h"

namespace telar::image {
namespace {

constexpr int LOSSLESS_QUALITY = 100;

/// Owns what libwebp allocates.
class Picture {
 public:
  Picture() {
    if (!WebPPictureInit(&picture))
      throw Error("X_LIBRARY_MISSING", "libwebp is of another version; build telar again");
    WebPMemoryWriterInit(&memory);
  }
  ~Picture() {
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&memory);
  }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  WebPPicture picture;
  WebPMemoryWriter memory;
};

WebPConfig configure(const OutputOptions& options) {
  WebPConfig config;
  bool ok = WebPConfigInit(&config);
  if (options.quality >= LOSSLESS_QUALITY) {
    ok = ok && WebPConfigLosslessPreset(&config, levelsOf(options.effort).webpLossless);
    config.exact = 1;
  } else {
    config.quality = float(options.quality);
    config.method = levelsOf(options.effort).webpMethod;
    config.alpha_quality = options.alphaQuality;
  }
  if (!ok || !WebPValidateConfig(&config)) throw Error("X_OUTPUT", "libwebp refuses the quality; give 1 to 100");
  return config;
}

}  // namespace

std::vector<std::byte> encodeWebp(const Frame& frame, const OutputOptions& options, const CancelToken& cancel) {
  const WebPConfig config = configure(options);
  Picture out;
  out.picture.use_argb = config.lossless;
  out.picture.width = int(frame.width);
  out.picture.height = int(frame.height);
  out.picture.writer = WebPMemoryWrite;
  out.picture.custom_ptr = &out.memory;
  out.picture.user_data = const_cast<CancelToken*>(&cancel);
  out.picture.progress_hook = [](int, const WebPPicture* picture) {
    return int(!static_cast<const CancelToken*>(picture->user_data)->isOver());
  };
  const bool done = WebPPictureImportRGBA(&out.picture, image::data(frame.pixels), int(frame.width * 4)) &&
                    WebPEncode(&config, &out.picture);
  cancel.check();
  const WebPEncodingError error = out.picture.error_code;
  if (!done && (error == VP8_ENC_ERROR_OUT_OF_MEMORY || error == VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY)) {
    throw std::bad_alloc();
  }
  if (!done) throw Error("X_OUTPUT", "writing the WebP image failed with libwebp's error " + std::to_string(error));
  const auto* begin = reinterpret_cast<const std::byte*>(out.memory.mem);
  return {begin, begin + out.memory.size};
}

}  // namespace telar::image
