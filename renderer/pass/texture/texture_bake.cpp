#include "pass/texture/texture_bake.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

#include "gl/incomplete.h"
#include "gl/nearest_texture.h"
#include "shader/library.h"

namespace telar::pass {
namespace {

constexpr GLenum FRAMEBUFFER_SRGB = 0x8DB9;  // desktop GL only: OpenGL ES always encodes for sRGB targets

/// A quarter of the side: it only shares out what the map of relief has, which is little from near.
constexpr int YARN_RELIEF_FIRST = 2;

glm::ivec2 sizeAt(const glm::ivec2& size, int level) { return glm::max(size >> level, 1); }

/// State of the passes that fill textures, while it lives.
class Drawing {
 public:
  explicit Drawing(const gl::Context& context)
      : context_(context), framebuffer_(context.gl()), noVertices_(context.gl()) {
    const gl::Functions& gl = context_.gl();
    for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(capability);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.BindVertexArray(noVertices_.get());
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindSampler(0, 0);
    if (context_.capabilities().desktop) gl.Enable(FRAMEBUFFER_SRGB);
  }
  ~Drawing() {
    const gl::Functions& gl = context_.gl();
    if (context_.capabilities().desktop) gl.Disable(FRAMEBUFFER_SRGB);
    gl.BindVertexArray(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void draw(GLuint source, const gl::Texture& target, int level, const glm::ivec2& size, gl::DrawCost& cost) const {
    const gl::Functions& gl = context_.gl();
    gl.BindTexture(GL_TEXTURE_2D, source);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.get(), level);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      gl::failIncomplete(gl, "the textures of the shading \"fabric\"");
    gl.Viewport(0, 0, size.x, size.y);
    const gl::Pacer::Rectangle texels{0, 0, size.x, size.y};
    context_.pacer().draw(cost, texels.area(), texels, [&gl] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  }

 private:
  const gl::Context& context_;
  gl::Framebuffer framebuffer_;
  gl::VertexArray noVertices_;
};

}  // namespace

struct TextureBaker::Kind {
  const char* moments;  ///< shader that averages from one level to the next
  const char* level;    ///< shader that makes a level's texels of them
  GLenum format;
  int first =
      0;  ///< level of the source that is level 0 of what is made: what is only seen from far needs no finer ones
};

/// Textures that are read beside the source, and what of them counts.
struct TextureBaker::Beside {
  BakeSource map;
  float cutoff = 0;
  BakeSource yarns;

  bool fits(const glm::ivec2& size) const {
    return map.texture != 0 && map.size == size && (yarns.texture == 0 || yarns.size == size);
  }
};

const gl::Program& TextureBaker::program(const char* file, const shader::Defines& features) {
  const auto key = std::make_pair(std::string(file), features);
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Program made(context_, file, shader::assemble("texture/level.vert", {}), shader::assemble(file, features));
  return programs_.emplace(key, std::move(made)).first->second;
}

namespace {

std::size_t bytesOf(const std::pair<int, int>& size) {
  return sizeof(glm::vec4) * static_cast<std::size_t>(size.first) * static_cast<std::size_t>(size.second);
}

/// Moves textures from one list to the other as far as they are at most so many bytes there.
void moveSome(std::map<std::pair<int, int>, gl::Texture>& from, std::map<std::pair<int, int>, gl::Texture>& to,
              std::size_t most) {
  std::size_t bytes = 0;
  for (const auto& [size, texture] : to) bytes += bytesOf(size);
  for (auto at = from.begin(); at != from.end();) {
    const auto next = std::next(at);
    if (bytes + bytesOf(at->first) <= most) {
      bytes += bytesOf(at->first);
      to.insert(from.extract(at));
    }
    at = next;
  }
}

}  // namespace

gl::Texture TextureBaker::bake(const Kind& kind, const BakeSource& source, const Beside& beside,
                               const CancelToken& cancel) {
  const gl::Functions& gl = context_.gl();
  const auto levels = static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(source.size.x, source.size.y))));
  const int first = std::min(kind.first, levels - 1);
  const glm::ivec2 largest = sizeAt(source.size, first);
  gl::Texture out = gl::nearestTexture(gl, kind.format, largest.x, largest.y, levels - first);
  const Drawing drawing(context_);
  for (const auto& [unit, texture] : {std::pair{1u, beside.map.texture}, std::pair{2u, beside.yarns.texture}}) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindSampler(unit, 0);
    gl.BindTexture(GL_TEXTURE_2D, texture);
  }
  gl.ActiveTexture(GL_TEXTURE0);
  const auto use = [&](const char* file, bool fromImage, bool halves) -> const gl::Program& {
    const gl::Program& used = program(file, {{"FROM_IMAGE", fromImage},
                                             {"HALVES", halves},
                                             {"BESIDE", beside.map.texture != 0},
                                             {"BESIDE_FITS", beside.fits(source.size)},
                                             {"YARNS", beside.yarns.texture != 0}});
    used.use();
    used.set("sourceMap", 0);
    used.set("besideMap", 1);
    used.set("yarnMap", 2);
    used.set("cutoff", beside.cutoff);
    return used;
  };
  // A variance is a small difference of large sums, which needs the precision.
  const GLenum format = context_.capabilities().colorBufferFloat ? GL_RGBA32F : GL_RGBA16F;
  // Where something throws, none stay: the storage of one may be what is wrong.
  auto kept = std::exchange(moments_, {});
  decltype(kept) used;
  const auto moments = [&](const glm::ivec2& size) -> const gl::Texture& {
    // Levels of one texture differ in size.
    auto known = kept.extract({size.x, size.y});
    if (!known.empty()) return used.insert(std::move(known)).position->second;
    return used.emplace(std::pair(size.x, size.y), gl::nearestTexture(gl, format, size.x, size.y)).first->second;
  };
  GLuint before = source.texture;
  for (int level = 0; level < levels; ++level) {
    cancel.check();
    const glm::ivec2 size = sizeAt(source.size, level);
    if (level > 0) {
      const glm::ivec2 larger = sizeAt(source.size, level - 1);
      const gl::Texture& averaged = moments(size);
      const gl::Program& average = use(kind.moments, level == 1, larger == 2 * size);
      average.set("sourceSize", glm::vec2(larger));
      average.set("targetSize", glm::vec2(size));
      drawing.draw(before, averaged, 0, size, cost_);
      before = averaged.get();
    }
    if (level < first) continue;
    use(kind.level, level == 0, false);
    drawing.draw(before, out, level - first, size, cost_);
  }
  context_.check("texture bake");
  moveSome(used, moments_, MOST_KEPT_BYTES);
  moveSome(kept, moments_, MOST_KEPT_BYTES);
  return out;
}

gl::Texture TextureBaker::normalVariance(const BakeSource& source, const BakeSource& cover, float cutoff, int unread,
                                         const CancelToken& cancel) {
  return bake({"texture/relief_moments.frag", "texture/relief_level.frag", GL_RGBA16F, unread}, source, {cover, cutoff},
              cancel);
}

glm::vec2 TextureBaker::reliefAxis(const BakeSource& source, const CancelToken& cancel) {
  cancel.check();
  const gl::Functions& gl = context_.gl();
  const gl::Texture out = gl::nearestTexture(gl, GL_RGBA8, 1, 1);
  const Drawing drawing(context_);
  const gl::Program& used = program("texture/relief_axis.frag", {{"BESIDE", 0}});
  used.use();
  used.set("sourceMap", 0);
  drawing.draw(source.texture, out, 0, glm::ivec2(1), axisCost_);
  std::array<std::uint8_t, 4> texel{};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  context_.check("relief axis");
  return (glm::vec2(256 * texel[0] + texel[1], 256 * texel[2] + texel[3]) - 32768.0f) / 32767.0f;
}

gl::Texture TextureBaker::normalFacets(const BakeSource& source, const CancelToken& cancel) {
  return bake({"texture/facets_moments.frag", "texture/facets_level.frag", GL_RGBA16F}, source, {}, cancel);
}

gl::Texture TextureBaker::yarnRelief(const BakeSource& source, const BakeSource& yarns, const CancelToken& cancel) {
  return bake({"texture/yarns_moments.frag", "texture/yarns_level.frag", GL_RGBA16F, YARN_RELIEF_FIRST}, source,
              {.map = yarns}, cancel);
}

gl::Texture TextureBaker::coverage(const BakeSource& source, bool srgb, float cutoff, const CancelToken& cancel) {
  return bake({"texture/coverage_moments.frag", "texture/coverage_level.frag",
               srgb ? GLenum{GL_SRGB8_ALPHA8} : GLenum{GL_RGBA8}},
              source, {.cutoff = cutoff}, cancel);
}

gl::Texture TextureBaker::metal(const BakeSource& source, bool srgb, const BakeSource& metallic,
                                const BakeSource& yarns, int unread, const CancelToken& cancel) {
  return bake({"texture/metal_moments.frag", "texture/metal_level.frag",
               srgb ? GLenum{GL_SRGB8_ALPHA8} : GLenum{GL_RGBA8}, unread},
              source, {.map = metallic, .yarns = yarns}, cancel);
}

}  // namespace telar::pass
