#include "asset/images.h"

#include "asset/pointer.h"
#include "telar/codec.h"

namespace telar::asset {

int ImageLoader::canonical(int image) const {
  const ImageSource& wanted = document_.images[static_cast<std::size_t>(image)];
  for (int i = 0; i < image; ++i) {
    const ImageSource& other = document_.images[static_cast<std::size_t>(i)];
    if (other.bufferView == wanted.bufferView && other.uri == wanted.uri) return i;
  }
  return image;
}

LoadedImages ImageLoader::load(const std::vector<bool>& used, bool tolerant) const {
  LoadedImages out{std::vector<Image8>(document_.images.size()), std::vector<bool>(document_.images.size(), false)};
  double bytes = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    cancel_.check();
    if (used[i]) {
      try {
        out.images[i] = decode(i, bytes);
      } catch (const Error& error) {
        // A limit, a lack of memory and a resolver that failed are no property of the image.
        if (!tolerant || !error.code.starts_with("E_")) throw;
        out.missing[i] = true;
        warnings_.add("W_TEXTURE", "a texture is not drawn: " + std::string(error.what()) + " [" + error.code + "]",
                      error.pointer.value_or(pointer("images", i)));
      }
    } else if (canonical(static_cast<int>(i)) == static_cast<int>(i)) {
      probeUnused(i);
    }
  }
  return out;
}

Image8 ImageLoader::decode(std::size_t image, double& bytesSoFar) const {
  const ImageSource& source = document_.images[image];
  const std::string where = pointer("images", image);
  std::vector<std::byte> owned;
  std::span<const std::byte> file;
  if (source.uri) {
    owned = resources_.fetch(*source.uri, where + "/uri");
    file = owned;
  } else {
    file = resources_.view(source.bufferView);
  }
  try {
    const ImageHeader header = readImageHeader(file, limits_);
    bytesSoFar += static_cast<double>(header.texelBytes) * header.width * header.height;
    checkSum("L_IMAGE_BYTES", static_cast<double>(limits_.imageBytes), bytesSoFar);
    // A URI need not give a type; an image in a buffer view must, and the right one.
    const bool embedded = source.bufferView >= 0;
    if (source.mimeType != header.mimeType && (embedded || !source.mimeType.empty())) {
      warnings_.add("W_IMAGE_MIME",
                    "the image is " + header.mimeType + ", its mimeType says " + telar::quoted(source.mimeType),
                    where + "/mimeType");
    }
    return decodeImage(file, limits_, cancel_);
  } catch (Error& error) {
    if (!error.pointer) error.at(where);
    throw;
  }
}

void ImageLoader::probeUnused(std::size_t image) const {
  const ImageSource& source = document_.images[image];
  if (source.bufferView < 0) return;
  try {
    readImageHeader(resources_.view(source.bufferView), limits_);
  } catch (const Error& error) {
    warnings_.add("W_IMAGE", std::string("an image that no material uses is not readable: ") + error.code,
                  pointer("images", image));
  }
}

}  // namespace telar::asset
