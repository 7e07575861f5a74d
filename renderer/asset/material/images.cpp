#include "asset/material/images.h"

#include "asset/check/pointer.h"
#include "telar/codec.h"

namespace telar::asset {
namespace {

/// Of the texels, and of the textures that they are uploaded to: all mip levels are a third as large as the first.
std::uint64_t bytesOf(const ImageHeader& header, ImageUse use) {
  const std::uint64_t texels = std::uint64_t{header.width} * header.height * header.texelBytes;
  return texels + use.ways() * (texels + texels / 3);
}

}  // namespace

int ImageLoader::canonical(int image) const {
  const ImageSource& wanted = from_.document.images[static_cast<std::size_t>(image)];
  for (int i = 0; i < image; ++i) {
    const ImageSource& other = from_.document.images[static_cast<std::size_t>(i)];
    if (other.bufferView == wanted.bufferView && other.uri == wanted.uri) return i;
  }
  return image;
}

template <class Read>
auto ImageLoader::at(std::size_t image, const Read& read) {
  try {
    return read();
  } catch (Error& error) {
    if (!error.pointer) error.at(pointer("images", image));
    throw;
  }
}

/// Runs a step of an image that is used; of one that is not readable, missing is true where that is allowed.
template <class Step>
void ImageLoader::tolerating(std::size_t image, std::vector<bool>& missing, const Step& step) const {
  try {
    step();
  } catch (const Error& error) {
    // A limit, a lack of memory and a resolver that failed are no property of the image.
    if (!from_.tolerant || !error.code.starts_with("E_")) throw;
    missing[image] = true;
    from_.warnings.add("W_TEXTURE", "a texture is not drawn: " + std::string(error.what()) + " [" + error.code + "]",
                       error.pointer.value_or(pointer("images", image)));
  }
}

/// All headers come first: what the images take together is refused before one of them is decoded.
LoadedImages ImageLoader::load(const std::vector<ImageUse>& uses) const {
  LoadedImages out{std::vector<Image8>(uses.size()), std::vector<bool>(uses.size(), false)};
  std::vector<File> files(uses.size());
  double bytes = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    from_.cancel.check();
    if (uses[i].ways() > 0) {
      tolerating(i, out.missing, [&] { files[i] = open(i, uses[i], bytes); });
    } else if (canonical(static_cast<int>(i)) == static_cast<int>(i)) {
      probeUnused(i);
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (uses[i].ways() == 0 || out.missing[i]) continue;
    tolerating(i, out.missing,
               [&] { out.images[i] = at(i, [&] { return decodeImage(files[i].bytes, from_.limits, from_.cancel); }); });
    files[i] = {};
  }
  return out;
}

ImageLoader::File ImageLoader::open(std::size_t image, ImageUse use, double& bytesSoFar) const {
  const ImageSource& source = from_.document.images[image];
  const std::string where = pointer("images", image);
  File out;
  if (source.uri) {
    out.owned = from_.resources.fetch(*source.uri, where + "/uri");
    out.bytes = out.owned;
  } else {
    out.bytes = from_.resources.view(source.bufferView);
  }
  const ImageHeader header = at(image, [&] { return readImageHeader(out.bytes, from_.limits); });
  bytesSoFar += static_cast<double>(header.texelBytes) * header.width * header.height;
  checkSum("L_IMAGE_BYTES", static_cast<double>(from_.limits.imageBytes), bytesSoFar, where);
  from_.memory.charge(bytesOf(header, use), where);
  // A URI need not give a type; an image in a buffer view must, and the right one.
  const bool embedded = source.bufferView >= 0;
  if (source.mimeType != header.mimeType && (embedded || !source.mimeType.empty())) {
    from_.warnings.add("W_IMAGE_MIME",
                       "the image is " + header.mimeType + ", its mimeType says " + telar::quoted(source.mimeType),
                       where + "/mimeType");
  }
  return out;
}

void ImageLoader::probeUnused(std::size_t image) const {
  const ImageSource& source = from_.document.images[image];
  if (source.bufferView < 0) return;
  try {
    readImageHeader(from_.resources.view(source.bufferView), from_.limits);
  } catch (const Error& error) {
    from_.warnings.add("W_IMAGE", std::string("an image that no material uses is not readable: ") + error.code,
                       pointer("images", image));
  }
}

}  // namespace telar::asset
