#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/texture/mip_levels.h"
#include "telar/image.h"

namespace telar::pass {

/// How a 2D texture of images lies in memory; `levels` 0 = not said.
struct TextureStorage {
  GLenum format = 0;
  GLsizei levels = 0, width = 0, height = 0;

  auto operator<=>(const TextureStorage&) const = default;
};

struct StoredTexture {
  gl::Texture texture;
  TextureStorage storage;
  int firstLevel = 0;  ///< of the image, that is level 0 of the texture
  int baseLevel = 0;   ///< of the texture, the largest that is read
};

/// How many of an image's largest levels are larger than `size` texels on the longer side; 0 = no bound.
int levelsBeyond(const Image8& image, int size);

/// Uploads images, and keeps textures of 8-bit texels that no model needs any more for the next ones of their size. A
/// GL that draws by the CPU clears the memory of a new texture, page by page: as much work as to fill it.
class TextureStore {
 public:
  explicit TextureStore(const gl::Context& context) : context_(context), mips_(context) {}

  /// A texture of an image and its mip levels: SRGB8_ALPHA8 or RGBA8, RGBA16F, RGBA32F, or blocks as the file has them.
  /// Levels that the file lacks are generated, or made as MissingLevels says. It stays bound.
  /// @param unread  largest levels that nothing will read: they are left out where the others are made by this
  ///        processor. Sides that are powers of two are halved exactly by a GL, so that the others are read as before.
  /// @throws Error{E_IMAGE_FORMAT} where this GL does not read such blocks, as a browser on the same GPU does not
  StoredTexture upload(const Image8& image, bool srgb, int unread = 0);
  /// The same with level 0 alone, where the others would be generated: for what is made of it.
  StoredTexture uploadLargest(const Image8& image, bool srgb);
  /// Has levels from this one of the image on read, or from the smallest that there is. It stays bound where it
  /// changes.
  void readFrom(StoredTexture& stored, int imageLevel) const;
  /// Takes a texture back. No more than MOST_KEPT_BYTES stay, the newest ones.
  void keep(StoredTexture&& unused) noexcept;
  int keptCount() const { return static_cast<int>(kept_.size()); }

  static constexpr std::size_t MOST_KEPT_BYTES = std::size_t{128} << 20;
  /// So much stays when textures of other sizes are made.
  static constexpr std::size_t STAYING_BYTES = MOST_KEPT_BYTES / 2;

 private:
  /// One that was kept, with its old texels, or a new one. Bound.
  StoredTexture take(const TextureStorage& storage);
  StoredTexture uploadTexels(const Image8& image, bool srgb, int unread);
  void putLevel(const Image8& image, GLint level, const void* texels) const;
  StoredTexture uploadBlocks(const Image8& image, bool srgb);
  void dropOldest();

  const gl::Context& context_;
  MipMaker mips_;
  std::deque<StoredTexture> kept_;  ///< the oldest first
  std::size_t keptBytes_ = 0;
};

}  // namespace telar::pass
