#include "image/decoders.h"

namespace telar {
namespace {

using image::Bytes;
using image::hasAt;

enum class FileFormat { kPng, kJpeg, kWebp };

FileFormat sniff(Bytes file) {
  if (hasAt(file, 0, "\x89PNG\r\n\x1a\n")) return FileFormat::kPng;
  if (hasAt(file, 0, "\xff\xd8\xff")) return FileFormat::kJpeg;
  if (hasAt(file, 0, "RIFF") && hasAt(file, 8, "WEBP")) return FileFormat::kWebp;
  throw Error("E_IMAGE_FORMAT", file.empty() ? "the image is empty; export it as PNG, JPEG or WebP"
                                             : "the image is not a PNG, JPEG or WebP file; convert it to one of these");
}

ImageHeader readHeader(FileFormat format, Bytes file) {
  switch (format) {
    case FileFormat::kPng:
      return image::readPngHeader(file);
    case FileFormat::kJpeg:
      return image::readJpegHeader(file);
    default:
      return image::readWebpHeader(file);
  }
}

void checkImageLimits(const ImageHeader& header, const Limits& limits) {
  checkLimit("L_IMAGE_DIMENSION", double(limits.imageDimension), std::max(header.width, header.height));
  const double pixels = double(header.width) * header.height;
  checkLimit("L_IMAGE_PIXELS", double(limits.imagePixels), pixels);
  checkLimit("L_IMAGE_BYTES", double(limits.imageBytes), pixels * 4);
}

}  // namespace

namespace image {

Error corrupt(std::string_view format, std::string_view what) {
  return Error("E_IMAGE_CORRUPT", std::string(format) + " image: " + std::string(what) + "; export the image again");
}

Image8 blank(const ImageHeader& header) {
  return {header.width, header.height, std::vector<std::uint8_t>(std::size_t{header.width} * header.height * 4)};
}

}  // namespace image

ImageHeader readImageHeader(std::span<const std::byte> file, const Limits& limits) {
  const ImageHeader header = readHeader(sniff(file), file);
  checkImageLimits(header, limits);
  return header;
}

Image8 decodeImage(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel) {
  cancel.check();
  const FileFormat format = sniff(file);
  checkImageLimits(readHeader(format, file), limits);
  switch (format) {
    case FileFormat::kPng:
      return image::decodePng(file, cancel);
    case FileFormat::kJpeg:
      return image::decodeJpeg(file, limits, cancel);
    default:
      return image::decodeWebp(file, cancel);
  }
}

}  // namespace telar
