#include "ktx2/decode.h"

#include "image/decoders.h"

namespace telar {
namespace {

using image::Bytes;
using image::hasAt;

enum class FileFormat { kPng, kJpeg, kWebp, kKtx2 };

FileFormat sniff(Bytes file) {
  if (hasAt(file, 0, "\x89PNG\r\n\x1a\n")) return FileFormat::kPng;
  if (hasAt(file, 0, "\xff\xd8\xff")) return FileFormat::kJpeg;
  if (hasAt(file, 0, "RIFF") && hasAt(file, 8, "WEBP")) return FileFormat::kWebp;
  if (ktx2::isKtx2(file)) return FileFormat::kKtx2;
  throw Error("E_IMAGE_FORMAT", file.empty()
                                    ? "the image is empty; export it as PNG, JPEG, WebP or KTX2"
                                    : "the image is not a PNG, JPEG, WebP or KTX2 file; convert it to one of these");
}

ImageHeader readHeader(FileFormat format, Bytes file, const Limits& limits) {
  switch (format) {
    case FileFormat::kPng:
      return image::readPngHeader(file);
    case FileFormat::kJpeg:
      return image::readJpegHeader(file);
    case FileFormat::kWebp:
      return image::readWebpHeader(file);
    default:
      return ktx2::readHeader(file, limits);
  }
}

Image8 decode(FileFormat format, Bytes file, const Limits& limits, const CancelToken& cancel) {
  switch (format) {
    case FileFormat::kPng:
      return image::decodePng(file, cancel);
    case FileFormat::kJpeg:
      return image::decodeJpeg(file, limits, cancel);
    case FileFormat::kWebp:
      return image::decodeWebp(file, cancel);
    default:
      return ktx2::decode(file, limits, cancel);
  }
}

const char* nameOf(FileFormat format) {
  constexpr const char* NAMES[] = {"PNG", "JPEG", "WebP", "KTX2"};
  return NAMES[static_cast<std::size_t>(format)];
}

void checkImageLimits(const ImageHeader& header, const Limits& limits) {
  checkLimit("L_IMAGE_DIMENSION", double(limits.imageDimension), std::max(header.width, header.height));
  const double pixels = double(header.width) * header.height;
  checkLimit("L_IMAGE_PIXELS", double(limits.imagePixels), pixels);
  checkLimit("L_IMAGE_BYTES", double(limits.imageBytes), pixels * header.texelBytes);
}

}  // namespace

namespace image {

Error corrupt(std::string_view format, std::string_view what) {
  return Error("E_IMAGE_CORRUPT", std::string(format) + " image: " + std::string(what) + "; export the image again");
}

Image8 blank(const ImageHeader& header) {
  return {header.width, header.height, ZeroedBytes(std::size_t{header.width} * header.height * 4)};
}

}  // namespace image

ImageHeader readImageHeader(std::span<const std::byte> file, const Limits& limits) {
  const FileFormat format = sniff(file);
  ImageHeader header = readHeader(format, file, limits);
  header.format = nameOf(format);
  checkImageLimits(header, limits);
  return header;
}

Image8 decodeImage(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel) {
  cancel.check();
  const FileFormat format = sniff(file);
  checkImageLimits(readHeader(format, file, limits), limits);
  Image8 out = decode(format, file, limits, cancel);
  if (out.format.empty()) out.format = nameOf(format);
  return out;
}

}  // namespace telar
