#include "pass/texture/texture_store.h"

#include <GLES2/gl2ext.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

namespace telar::pass {
namespace {

/// How texels are stored and, but for blocks, uploaded.
struct TexelFormat {
  GLenum stored, component;
};

TexelFormat formatOf(TexelType type, bool srgb) {
  switch (type) {
    case TexelType::kHalf:
      return {GL_RGBA16F, GL_HALF_FLOAT};
    case TexelType::kFloat:
      return {GL_RGBA32F, GL_FLOAT};
    default:
      return {static_cast<GLenum>(srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8), GL_UNSIGNED_BYTE};
  }
}

/// The formats that three.js 0.187 asks WebGL for (renderers/webgl/WebGLUtils.js).
GLenum formatOf(BlockFormat blocks, bool srgb) {
  const auto either = [&](GLenum linear, GLenum colour) { return srgb ? colour : linear; };
  switch (blocks) {
    case BlockFormat::kBc1Rgb:
      return either(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_SRGB_S3TC_DXT1_EXT);
    case BlockFormat::kBc1Rgba:
      return either(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT);
    case BlockFormat::kBc3:
      return either(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT);
    case BlockFormat::kBc4:
      return GL_COMPRESSED_RED_RGTC1_EXT;
    case BlockFormat::kBc4Signed:
      return GL_COMPRESSED_SIGNED_RED_RGTC1_EXT;
    case BlockFormat::kBc5:
      return GL_COMPRESSED_RED_GREEN_RGTC2_EXT;
    case BlockFormat::kBc5Signed:
      return GL_COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT;
    case BlockFormat::kBc7:
      return either(GL_COMPRESSED_RGBA_BPTC_UNORM_EXT, GL_COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT);
    case BlockFormat::kEtc2Rgb:
      return either(GL_COMPRESSED_RGB8_ETC2, GL_COMPRESSED_SRGB8_ETC2);
    case BlockFormat::kEtc2Rgba:
      return either(GL_COMPRESSED_RGBA8_ETC2_EAC, GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC);
    case BlockFormat::kEacR:
      return GL_COMPRESSED_R11_EAC;
    case BlockFormat::kEacRSigned:
      return GL_COMPRESSED_SIGNED_R11_EAC;
    case BlockFormat::kEacRg:
      return GL_COMPRESSED_RG11_EAC;
    case BlockFormat::kEacRgSigned:
      return GL_COMPRESSED_SIGNED_RG11_EAC;
    case BlockFormat::kAstc4x4:
      return either(GL_COMPRESSED_RGBA_ASTC_4x4_KHR, GL_COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR);
    default:
      return either(GL_COMPRESSED_RGBA_ASTC_6x6_KHR, GL_COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR);
  }
}

GLsizei levelCount(const Image8& image) {
  if (image.ownLevels && image.missingLevels == MissingLevels::kNone) {
    return static_cast<GLsizei>(1 + image.smallerLevels.size());
  }
  return static_cast<GLsizei>(std::bit_width(std::max(image.width, image.height)));
}

GLsizei sideOf(std::uint32_t side, GLint level) { return std::max(1, static_cast<GLsizei>(side >> level)); }

/// Texels of 0, and alpha as the missing levels have it.
std::vector<std::uint8_t> emptyLevel(const Image8& image, GLint level) {
  const float one = 1;
  const std::uint16_t half = 0x3c00;
  std::uint8_t texel[16] = {};
  if (image.missingLevels == MissingLevels::kBlack) {
    if (image.type == TexelType::kByte) texel[3] = 255;
    if (image.type == TexelType::kHalf) std::memcpy(texel + 6, &half, sizeof half);
    if (image.type == TexelType::kFloat) std::memcpy(texel + 12, &one, sizeof one);
  }
  const std::size_t bytes = texelBytes(image.type);
  std::vector<std::uint8_t> out(static_cast<std::size_t>(sideOf(image.width, level)) *
                                static_cast<std::size_t>(sideOf(image.height, level)) * bytes);
  for (std::size_t at = 0; at < out.size(); at += bytes) std::copy_n(texel, bytes, &out[at]);
  return out;
}

/// With all its levels, which take a third of the first.
std::size_t bytesOf(const TextureStorage& storage) {
  return static_cast<std::size_t>(storage.width) * static_cast<std::size_t>(storage.height) * 16 / 3;
}

}  // namespace

int levelsBeyond(const Image8& image, int size) {
  if (size <= 0) return 0;
  int level = 0;
  while (sideOf(std::max(image.width, image.height), level) > size) ++level;
  return level;
}

void TextureStore::readFrom(StoredTexture& stored, int imageLevel) const {
  const int base = std::clamp(imageLevel - stored.firstLevel, 0, stored.storage.levels - 1);
  if (base == stored.baseLevel) return;
  stored.baseLevel = base;
  context_.gl().BindTexture(GL_TEXTURE_2D, stored.texture.get());
  context_.gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
}

StoredTexture TextureStore::take(const TextureStorage& storage) {
  const gl::Functions& gl = context_.gl();
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const StoredTexture& kept) { return kept.storage == storage; });
  if (found != kept_.end()) {
    StoredTexture taken = std::move(*found);
    kept_.erase(found);
    keptBytes_ -= bytesOf(storage);
    gl.BindTexture(GL_TEXTURE_2D, taken.texture.get());
    readFrom(taken, taken.firstLevel);
    return taken;
  }
  // Beyond what stays for models in turn, memory grows by new textures only as far as it would without those that are
  // kept.
  const std::size_t before = keptBytes_;
  while (keptBytes_ > STAYING_BYTES && before - keptBytes_ < bytesOf(storage)) dropOldest();
  StoredTexture made{gl::Texture(gl), storage};
  gl.BindTexture(GL_TEXTURE_2D, made.texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, storage.levels, storage.format, storage.width, storage.height);
  return made;
}

void TextureStore::keep(StoredTexture&& unused) noexcept {
  const TextureStorage storage = unused.storage;
  if (storage.format != GL_RGBA8 && storage.format != GL_SRGB8_ALPHA8) return;
  const std::size_t bytes = bytesOf(storage);
  if (bytes > MOST_KEPT_BYTES) return;
  while (keptBytes_ + bytes > MOST_KEPT_BYTES) dropOldest();
  try {
    kept_.push_back(std::move(unused));
    keptBytes_ += bytes;
  } catch (const std::bad_alloc&) {  // It is deleted, as if there were no store.
  }
}

void TextureStore::dropOldest() {
  keptBytes_ -= bytesOf(kept_.front().storage);
  kept_.pop_front();
}

StoredTexture TextureStore::uploadTexels(const Image8& image, bool srgb, int unread) {
  const gl::Functions& gl = context_.gl();
  const TexelFormat format = formatOf(image.type, srgb);
  const GLsizei levels = levelCount(image);
  const bool mayLeave = !image.ownLevels && image.type == TexelType::kByte;
  const int first = mayLeave && unread > 0 && mips_.byCpu(image.width, image.height, srgb)
                        ? std::min(unread, static_cast<int>(std::bit_width(std::min(image.width, image.height))) - 1)
                        : 0;
  StoredTexture stored = take({format.stored, levels - first, sideOf(image.width, first), sideOf(image.height, first)});
  stored.firstLevel = first;
  const auto put = [&](GLint level, const auto& pixels) { putLevel(image, level, pixels.data()); };
  if (first == 0) put(0, image.pixels);
  if (mayLeave) {
    mips_.make(image.pixels.data(), image.width, image.height, srgb, first);
  } else if (!image.ownLevels) {
    gl.GenerateMipmap(GL_TEXTURE_2D);
  } else {
    GLint level = 1;
    for (const auto& pixels : image.smallerLevels) put(level++, pixels);
    for (; level < levels; ++level) put(level, emptyLevel(image, level));
  }
  return stored;
}

void TextureStore::putLevel(const Image8& image, GLint level, const void* texels) const {
  context_.gl().PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  context_.gl().TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, sideOf(image.width, level), sideOf(image.height, level),
                              GL_RGBA, formatOf(image.type, false).component, texels);
}

StoredTexture TextureStore::uploadBlocks(const Image8& image, bool srgb) {
  const gl::Functions& gl = context_.gl();
  const GLenum format = formatOf(image.blocks, srgb);
  context_.check("textures");
  StoredTexture stored{gl::Texture(gl), {format, levelCount(image), sideOf(image.width, 0), sideOf(image.height, 0)}};
  gl.BindTexture(GL_TEXTURE_2D, stored.texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, stored.storage.levels, format, stored.storage.width, stored.storage.height);
  try {
    context_.check("compressed textures");
  } catch (const Error& error) {
    if (error.code != "X_GL") throw;
    throw Error("E_IMAGE_FORMAT", "the image is " + image.format +
                                      ", blocks that this machine's GL does not read; use a texture in PNG, or KTX2 in "
                                      "ETC1S or UASTC");
  }
  GLint level = 0;
  const auto put = [&](const auto& bytes) {
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, sideOf(image.width, level), sideOf(image.height, level),
                               format, static_cast<GLsizei>(bytes.size()), bytes.data());
    ++level;
  };
  put(image.pixels);
  for (const auto& bytes : image.smallerLevels) put(bytes);
  return stored;
}

StoredTexture TextureStore::uploadLargest(const Image8& image, bool srgb) {
  if (image.type == TexelType::kBlocks || image.ownLevels) return upload(image, srgb);
  StoredTexture stored = take({formatOf(image.type, srgb).stored, 1, sideOf(image.width, 0), sideOf(image.height, 0)});
  putLevel(image, 0, image.pixels.data());
  context_.check("texture upload");
  return stored;
}

StoredTexture TextureStore::upload(const Image8& image, bool srgb, int unread) {
  StoredTexture stored =
      image.type == TexelType::kBlocks ? uploadBlocks(image, srgb) : uploadTexels(image, srgb, unread);
  context_.check("texture upload");
  return stored;
}

}  // namespace telar::pass
