#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/mip_levels.h"
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
};

/// Uploads images, and keeps textures of 8-bit texels that no model needs any more for the next ones of their size. A
/// GL that draws by the CPU clears the memory of a new texture, page by page: as much work as to fill it.
class TextureStore {
 public:
  explicit TextureStore(const gl::Context& context) : context_(context), mips_(context) {}

  /// A texture of an image and its mip levels: SRGB8_ALPHA8 or RGBA8, RGBA16F, RGBA32F, or blocks as the file has them.
  /// Levels that the file lacks are generated, or made as MissingLevels says. It stays bound.
  /// @throws Error{E_IMAGE_FORMAT} where this GL does not read such blocks, as a browser on the same GPU does not
  StoredTexture upload(const Image8& image, bool srgb);
  /// Takes a texture back. No more than MOST_KEPT_BYTES stay, the newest ones.
  void keep(StoredTexture&& unused) noexcept;
  int keptCount() const { return static_cast<int>(kept_.size()); }

  static constexpr std::size_t MOST_KEPT_BYTES = std::size_t{128} << 20;

 private:
  /// One that was kept, with its old texels, or a new one. Bound.
  StoredTexture take(const TextureStorage& storage);
  StoredTexture uploadTexels(const Image8& image, bool srgb);
  StoredTexture uploadBlocks(const Image8& image, bool srgb);
  void dropOldest();

  const gl::Context& context_;
  MipMaker mips_;
  std::deque<StoredTexture> kept_;  ///< the oldest first
  std::size_t keptBytes_ = 0;
};

}  // namespace telar::pass
