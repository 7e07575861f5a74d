#include <string>

#include "image/encoders.h"
#include "image/oiio_bridge.h"

namespace telar {
namespace {

using Format = OutputOptions::Format;

[[noreturn]] void refuse(const std::string& what) { throw Error("X_OUTPUT", what); }

void checkOptions(const OutputOptions& options) {
  const std::string name(namesOf(options.format)[static_cast<std::size_t>(options.format)]);
  if (!shot::takesBitDepth(options.format, options.bitDepth)) {
    refuse(name + " does not take " + std::to_string(options.bitDepth) + " bits a channel");
  }
  const bool lossy = options.format == Format::kJpeg || options.format == Format::kWebp;
  if (options.effort < 0 || options.effort > 9) refuse(name + " takes an effort from 0 to 9");
  if (lossy && (options.quality < 1 || options.quality > 100)) refuse(name + " takes a quality from 1 to 100");
}

void checkFrame(const Frame& frame, const OutputOptions& options) {
  if (frame.type != framePixelType(options)) refuse("the frame's pixel type does not fit the output format");
  const std::size_t pixelBytes = frame.type == PixelType::kRgba8 ? 4 : 16;
  const std::size_t bytes = std::size_t{frame.width} * frame.height * pixelBytes;
  if (!bytes || frame.pixels.size() != bytes) refuse("the frame's pixels do not fit its size");
}

}  // namespace

std::vector<std::byte> encode(const Frame& frame, const OutputOptions& options, const CancelToken& cancel) {
  cancel.check();
  checkOptions(options);
  checkFrame(frame, options);
  switch (options.format) {
    case Format::kPng:
      return options.icc ? image::encodeWithOiio(frame, options, cancel) : image::encodePng(frame, options, cancel);
    case Format::kJpeg: {
      const auto profile = options.icc ? image::srgbProfile() : std::vector<std::byte>();
      return image::encodeJpeg(frame, options, profile, cancel);
    }
    case Format::kWebp:
      return image::encodeWebp(frame, options, cancel);
    case Format::kRaw:
      return frame.pixels;
    default:
      return image::encodeWithOiio(frame, options, cancel);
  }
}

}  // namespace telar
