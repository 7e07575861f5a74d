#pragma once
#include <memory>
#include <vector>

#include "asset/geometry/geometry.h"
#include "telar/codec.h"
#include "telar/pending_images.h"

namespace telar::asset {

struct LoadedImages {
  /// As many as the document has; width 0 where not used, or missing.
  std::shared_ptr<std::vector<Image8>> images;
  std::shared_ptr<PendingImages> pending;  ///< null = all are decoded
  std::vector<bool> missing;               ///< used, and not readable
  /// For each image the first used one with the same bytes, that one itself included; of the others there is nothing.
  std::vector<std::size_t> first;
};

/// How materials read an image, one that is read both ways is uploaded twice; and how textures have it.
struct ImageUse {
  bool color = false, data = false;
  bool byBasisu = false, otherwise = false;  ///< by KHR_texture_basisu, or not
  unsigned ways() const { return unsigned{color} + unsigned{data}; }
  void add(ImageUse other) { color |= other.color, data |= other.data; }
};

/// Decodes the images that are used, those of the same source or the same bytes once.
class ImageLoader {
 public:
  explicit ImageLoader(const GeometryReader::Sources& sources) : from_(sources) {}

  /// Index of the first image that has the same source as this one.
  int canonical(int image) const;

  /// Where the sources are tolerant, an image that is not there, denied or damaged is missing, with W_TEXTURE.
  /// @param uses by image index, canonical ones only
  /// @throws Error{E_IMAGE_*, L_IMAGE_*, L_MEMORY_BYTES, E_URI_*, X_CANCELLED} with the image's pointer. What is wrong
  ///         with an unused image inside the file is only a warning (W_IMAGE); unused external files are not decoded.
  LoadedImages load(std::vector<ImageUse> uses) const;

 private:
  struct File {
    std::vector<std::byte> owned;  ///< empty where the image is in a buffer view
    std::span<const std::byte> bytes;
    ImageHeader header;
  };
  File open(std::size_t image, ImageUse use) const;
  std::vector<std::size_t> firstOfSameBytes(const std::vector<File>& files) const;
  bool mayWait(const std::vector<File>& files) const;
  std::shared_ptr<const void> ownerOf(File& file) const;
  void charge(std::size_t image, const ImageHeader& header, ImageUse use, double& bytesSoFar) const;
  /// Errors of `read` get the image's pointer, unless they have one.
  template <class Read>
  static auto at(std::size_t image, const Read& read);
  template <class Step>
  void tolerating(std::size_t image, std::vector<bool>& missing, const Step& step) const;
  void probeUnused(std::size_t image) const;

  const GeometryReader::Sources& from_;
};

}  // namespace telar::asset
