#include "ibl/pmrem_file.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "ibl/half_file.h"

namespace telar::ibl {
namespace {

constexpr char CUBE_MAGIC[4] = {'T', 'P', 'M', 'R'};
constexpr char ATLAS_MAGIC[4] = {'T', 'P', 'M', 'A'};
constexpr std::uint32_t CUBE_VERSION = 2;  // raise when the prefilter or this layout changes
constexpr std::uint32_t ATLAS_VERSION = 1;
constexpr int FACE_SIZE_MAX = 4096;

HalfFileHead headWith(const char (&magic)[4], std::uint32_t version, int faceSize, int levels) {
  HalfFileHead head{{}, version, static_cast<std::uint32_t>(faceSize), static_cast<std::uint32_t>(levels)};
  std::copy(std::begin(magic), std::end(magic), head.magic);
  return head;
}

/// The head of a file of this kind and key, with a face size that can be.
std::optional<HalfFileHead> knownHead(std::span<const std::byte> file, std::string_view key, const char (&magic)[4],
                                      std::uint32_t version) {
  const auto head = headOf(file, key);
  if (!head || !std::equal(std::begin(magic), std::end(magic), head->magic) || head->version != version ||
      head->faceSize > FACE_SIZE_MAX || !std::has_single_bit(head->faceSize)) {
    return std::nullopt;
  }
  return head;
}

std::size_t texelCount(int faceSize, int levels) {
  std::size_t count = 0;
  for (int level = 0; level < levels; ++level) {
    const std::size_t size = static_cast<std::size_t>(faceSize >> level);
    count += 6 * size * size;
  }
  return count;
}

std::size_t texelCount(const Atlas& atlas) {
  return static_cast<std::size_t>(atlas.width()) * static_cast<std::size_t>(atlas.height());
}

/// Calls visit(faceTarget, level, size) in file order.
template <class Visit>
void eachFace(int faceSize, int levels, Visit visit) {
  for (int level = 0; level < levels; ++level) {
    for (GLenum face = 0; face < 6; ++face) visit(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, faceSize >> level);
  }
}

}  // namespace

std::vector<std::byte> packPmrem(const gl::Context& context, const CubeMap& cube, std::string_view key) {
  const gl::Functions& gl = context.gl();
  std::vector<std::uint16_t> rgba(texelCount(cube.faceSize, cube.levels) * 4);
  const gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  std::size_t offset = 0;
  eachFace(cube.faceSize, cube.levels, [&](GLenum face, int level, int size) {
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face, cube.texture.get(), level);
    gl.ReadPixels(0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, &rgba[offset]);
    offset += static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4;
  });
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  context.check("environment readback");
  return packHalfs(headWith(CUBE_MAGIC, CUBE_VERSION, cube.faceSize, cube.levels), key, rgba);
}

std::vector<std::byte> packPmrem(const gl::Context& context, const Atlas& atlas, std::string_view key) {
  return packHalfs(headWith(ATLAS_MAGIC, ATLAS_VERSION, atlas.faceSize, atlas.levels()), key,
                   readAtlas(context, atlas));
}

std::optional<CubeMap> unpackPmrem(const gl::Context& context, std::span<const std::byte> file, std::string_view key) {
  const auto head = knownHead(file, key, CUBE_MAGIC, CUBE_VERSION);
  if (!head || head->levels < 1 || head->levels > static_cast<unsigned>(std::bit_width(head->faceSize)))
    return std::nullopt;
  const int faceSize = static_cast<int>(head->faceSize), levels = static_cast<int>(head->levels);
  auto texels = HalfReader::open(file, texelCount(faceSize, levels));
  if (!texels) return std::nullopt;
  const gl::Functions& gl = context.gl();
  CubeMap cube = createCube(gl, faceSize, levels);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  std::vector<std::uint16_t> rgba(std::size_t{4} * head->faceSize * head->faceSize);
  eachFace(faceSize, levels, [&](GLenum face, int level, int size) {
    texels->read(std::span(rgba).first(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4));
    gl.TexSubImage2D(face, level, 0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, rgba.data());
  });
  context.check("environment upload");
  return cube;
}

std::optional<Atlas> unpackAtlas(const gl::Context& context, std::span<const std::byte> file, std::string_view key) {
  const auto head = knownHead(file, key, ATLAS_MAGIC, ATLAS_VERSION);
  if (!head) return std::nullopt;
  Atlas atlas = createAtlas(context, static_cast<int>(head->faceSize));
  const std::size_t count = texelCount(atlas);
  auto texels = HalfReader::open(file, count);
  if (!texels) return std::nullopt;
  std::vector<std::uint16_t> rgba(count * 4);
  texels->read(rgba);
  const gl::Functions& gl = context.gl();
  gl.BindTexture(GL_TEXTURE_2D, atlas.texture.get());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, atlas.width(), atlas.height(), GL_RGBA, GL_HALF_FLOAT, rgba.data());
  context.check("environment upload");
  return atlas;
}

}  // namespace telar::ibl
