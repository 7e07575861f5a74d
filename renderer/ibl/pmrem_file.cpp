#include "ibl/pmrem_file.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>

#include "core/sha256.h"

namespace telar::ibl {
namespace {

constexpr char MAGIC[4] = {'T', 'P', 'M', 'R'};
constexpr std::uint32_t VERSION = 2;  // raise when the prefilter or this layout changes
constexpr int FACE_SIZE_MAX = 4096;

struct Header {
  char magic[4];
  std::uint32_t version;
  std::uint32_t faceSize;
  std::uint32_t levels;
  char key[64];  ///< zeros behind a shorter one
  char sha256[64];
};

/// Of the header as it is with zeros for the digest, and of the body.
std::string digestOf(Header header, std::span<const std::byte> body) {
  std::memset(header.sha256, 0, sizeof header.sha256);
  Sha256 digest;
  digest.add(std::as_bytes(std::span(&header, 1)));
  digest.add(body);
  return digest.hex();
}

std::array<char, sizeof Header::key> keyField(std::string_view key) {
  std::array<char, sizeof Header::key> out{};
  std::copy_n(key.begin(), std::min(key.size(), out.size()), out.begin());
  return out;
}

std::size_t texelCount(int faceSize, int levels) {
  std::size_t count = 0;
  for (int level = 0; level < levels; ++level) {
    const std::size_t size = static_cast<std::size_t>(faceSize >> level);
    count += 6 * size * size;
  }
  return count;
}

/// Calls visit(faceTarget, level, size) in file order.
template <class Visit>
void eachFace(int faceSize, int levels, Visit visit) {
  for (int level = 0; level < levels; ++level) {
    for (GLenum face = 0; face < 6; ++face) visit(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, faceSize >> level);
  }
}

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

std::vector<std::uint16_t> readBack(const gl::Functions& gl, const CubeMap& cube) {
  std::vector<std::uint16_t> rgb;
  rgb.reserve(texelCount(cube.faceSize, cube.levels) * 3);
  const gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  eachFace(cube.faceSize, cube.levels, [&](GLenum face, int level, int size) {
    std::vector<std::uint16_t> rgba(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, cube.texture.get(), level);
    gl.ReadPixels(0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, rgba.data());
    for (std::size_t i = 0; i < rgba.size(); i += 4) rgb.insert(rgb.end(), &rgba[i], &rgba[i + 3]);
  });
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return rgb;
}

}  // namespace

std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube, std::string_view key) {
  const std::vector<std::uint16_t> halfs = readBack(context.gl(), cube);
  context.check("environment readback");
  // Neighbouring texels of one channel are alike: differences, low bytes apart from high bytes, pack to about a third.
  const std::size_t count = halfs.size();
  std::vector<std::uint8_t> planes(count * 2);
  for (std::size_t i = 0; i < count; ++i) {
    const auto difference = static_cast<std::uint16_t>(halfs[i] - (i >= 3 ? halfs[i - 3] : 0));
    planes[i] = static_cast<std::uint8_t>(difference >> 8);
    planes[count + i] = static_cast<std::uint8_t>(difference);
  }
  const Compressor compressor(libdeflate_alloc_compressor(9), &libdeflate_free_compressor);
  std::vector<std::byte> packed(sizeof(Header) + libdeflate_deflate_compress_bound(compressor.get(), planes.size()));
  const std::size_t size = libdeflate_deflate_compress(compressor.get(), planes.data(), planes.size(),
                                                       &packed[sizeof(Header)], packed.size() - sizeof(Header));
  packed.resize(sizeof(Header) + size);
  Header header{};
  std::memcpy(header.magic, MAGIC, sizeof MAGIC);
  header.version = VERSION;
  header.faceSize = static_cast<std::uint32_t>(cube.faceSize);
  header.levels = static_cast<std::uint32_t>(cube.levels);
  std::memcpy(header.key, keyField(key).data(), sizeof header.key);
  std::memcpy(header.sha256, digestOf(header, std::span(packed).subspan(sizeof(Header))).data(), sizeof header.sha256);
  std::memcpy(packed.data(), &header, sizeof header);
  return packed;
}

std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file, std::string_view key) {
  Header header;
  if (file.size() <= sizeof header) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof header);
  const auto body = file.subspan(sizeof header);
  if (std::memcmp(header.magic, MAGIC, sizeof MAGIC) != 0 || header.version != VERSION ||
      header.faceSize > FACE_SIZE_MAX || !std::has_single_bit(header.faceSize) || header.levels < 1 ||
      header.levels > static_cast<unsigned>(std::bit_width(header.faceSize)) ||
      std::memcmp(header.key, keyField(key).data(), sizeof header.key) != 0 ||
      std::memcmp(header.sha256, digestOf(header, body).data(), sizeof header.sha256) != 0) {
    return std::nullopt;
  }
  const int faceSize = static_cast<int>(header.faceSize), levels = static_cast<int>(header.levels);
  const std::size_t count = texelCount(faceSize, levels) * 3;
  std::vector<std::uint8_t> planes(count * 2);
  const Decompressor decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (libdeflate_deflate_decompress(decompressor.get(), body.data(), body.size(), planes.data(), planes.size(),
                                    nullptr) != LIBDEFLATE_SUCCESS) {
    return std::nullopt;
  }
  constexpr std::uint16_t HALF_ONE = 0x3c00;
  std::vector<std::uint16_t> rgba(count / 3 * 4, HALF_ONE);
  std::uint16_t previous[3] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t channel = i % 3;
    previous[channel] = static_cast<std::uint16_t>(previous[channel] + (planes[i] << 8 | planes[count + i]));
    rgba[i / 3 * 4 + channel] = previous[channel];
  }
  const gl::Functions& gl = context.gl();
  CubeMap cube = createCube(gl, faceSize, levels);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  std::size_t offset = 0;
  eachFace(faceSize, levels, [&](GLenum face, int level, int size) {
    gl.TexSubImage2D(face, level, 0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, &rgba[offset]);
    offset += static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4;
  });
  context.check("environment upload");
  return cube;
}

}  // namespace telar::ibl
