#include "ibl/pmrem_file.h"

#include <fcntl.h>
#include <libdeflate.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <thread>

#include "core/sha256.h"

namespace telar::ibl {
namespace {

constexpr char MAGIC[4] = {'T', 'P', 'M', 'R'};
constexpr std::uint32_t VERSION = 1;  // raise when the prefilter changes
constexpr int FACE_SIZE_MAX = 4096;

struct Header {
  char magic[4];
  std::uint32_t version;
  std::uint32_t faceSize;
  std::uint32_t levels;
  char sha256[64];
};

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

std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube) {
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
  std::memcpy(header.sha256, sha256Hex(std::span(packed).subspan(sizeof(Header))).data(), sizeof header.sha256);
  std::memcpy(packed.data(), &header, sizeof header);
  return packed;
}

std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file) {
  Header header;
  if (file.size() <= sizeof header) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof header);
  const auto body = file.subspan(sizeof header);
  if (std::memcmp(header.magic, MAGIC, sizeof MAGIC) != 0 || header.version != VERSION ||
      header.faceSize > FACE_SIZE_MAX || !std::has_single_bit(header.faceSize) || header.levels < 1 ||
      header.levels > static_cast<unsigned>(std::bit_width(header.faceSize)) ||
      std::memcmp(header.sha256, sha256Hex(body).data(), sizeof header.sha256) != 0) {
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

bool writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::error_code failure;
  std::filesystem::create_directories(path.parent_path(), failure);
  // One name a process and thread; a left-over of a process that died is written over.
  const std::string temporary = path.string() + "." + std::to_string(getpid()) + "-" +
                                std::to_string(std::hash<std::thread::id>()(std::this_thread::get_id()));
  constexpr mode_t MODE = 0666;  // less the process's umask
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, MODE);
  if (file < 0) return false;
  bool ok = true;
  for (std::size_t done = 0; ok && done < bytes.size();) {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    ok = written > 0;
    if (ok) done += static_cast<std::size_t>(written);
  }
  ok = close(file) == 0 && ok && rename(temporary.c_str(), path.c_str()) == 0;
  if (!ok) unlink(temporary.c_str());
  return ok;
}

}  // namespace telar::ibl
