#pragma once
#include <vector>

#include "asset/resources.h"

namespace telar::asset {

struct LoadedImages {
  std::vector<Image8> images;  ///< as many as the document has; width 0 where not used, or missing
  std::vector<bool> missing;   ///< used, and not readable
};

/// Decodes the images that are used, each distinct one once.
class ImageLoader {
 public:
  ImageLoader(const Document& document, const Resources& resources, const Limits& limits, const CancelToken& cancel,
              Warnings& warnings)
      : document_(document), resources_(resources), limits_(limits), cancel_(cancel), warnings_(warnings) {}

  /// Index of the first image that has the same source as this one.
  int canonical(int image) const;

  /// @param used by image index, canonical ones only
  /// @param tolerant an image that is not there, denied or damaged is missing, with W_TEXTURE. Over a limit it is an
  /// error.
  /// @throws Error{E_IMAGE_*, L_IMAGE_*, E_URI_*, X_CANCELLED} with the image's pointer. What is wrong with an unused
  ///         image inside the file is only a warning (W_IMAGE); unused external files are not decoded.
  LoadedImages load(const std::vector<bool>& used, bool tolerant) const;

 private:
  Image8 decode(std::size_t image, double& bytesSoFar) const;
  void probeUnused(std::size_t image) const;

  const Document& document_;
  const Resources& resources_;
  const Limits& limits_;
  const CancelToken& cancel_;
  Warnings& warnings_;
};

}  // namespace telar::asset
