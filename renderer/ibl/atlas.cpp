#include "ibl/atlas.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

#include "gl/clamped_sampling.h"
#include "gl/incomplete.h"

namespace telar::ibl {
namespace {

constexpr int MIP_MIN = 4;         // 16 px: smaller levels would blur too coarsely
constexpr int ROUGHER_LEVELS = 6;  // of the least size, beside the first one of it
constexpr int FACES = 6;

struct Axes {
  glm::dvec3 across, up, centre;
};

// In the order of the tiles: +x +y +z, then -x -y -z.
constexpr Axes AXES[FACES] = {
    {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},   {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
};

struct Vertex {
  glm::vec2 corner;     ///< clip space
  glm::vec2 place;      ///< on the face, which is [0, 1]^2
  glm::vec3 direction;  ///< the same, rounded once
};

/// Two triangles a face. A face reaches one texel beyond its edges, as the outermost texels' centres do half of.
std::vector<Vertex> tileVertices(int edge) {
  const double texel = 1.0 / (edge - 2), ends[2] = {-texel, 1 + texel};
  std::vector<Vertex> out;
  for (int face = 0; face < FACES; ++face) {
    const int row = face / 3;
    const double x = (face % 3) * 2.0 / 3 - 1, y = row - 1;
    for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
      const glm::dvec2 place(ends[i], ends[j]);
      const Axes& axes = AXES[face];
      const glm::dvec3 direction = axes.across * (place.x * 2 - 1) + axes.up * (place.y * 2 - 1) + axes.centre;
      out.push_back({glm::vec2(glm::dvec2(i ? x + 2.0 / 3 : x, y + j)), glm::vec2(place), glm::vec3(direction)});
    }
  }
  return out;
}

/// Where shaders/environment/atlas_tiles.vert looks for them.
enum Attribute : GLuint { CORNER, PLACE, DIRECTION };

}  // namespace

int Atlas::width() const { return 3 * std::max(faceSize, (1 << MIP_MIN) * (ROUGHER_LEVELS + 1)); }

int Atlas::maxMip() const { return std::countr_zero(static_cast<unsigned>(faceSize)); }

int Atlas::levels() const { return maxMip() - MIP_MIN + 1 + ROUGHER_LEVELS; }

int Atlas::edgeOf(int level) const { return 1 << std::max(maxMip() - level, std::min(maxMip(), MIP_MIN)); }

gl::Pacer::Rectangle Atlas::tilesOf(int level) const {
  const int edge = edgeOf(level), beside = level == 0 ? 0 : std::max(level - (maxMip() - MIP_MIN), 0);
  return {3 * edge * beside, 4 * (faceSize - edge), 3 * edge, 2 * edge};
}

glm::vec2 Atlas::texel() const { return glm::vec2(1.0 / width(), 1.0 / height()); }

Atlas createAtlas(const gl::Context& context, int faceSize) {
  const gl::Functions& gl = context.gl();
  Atlas atlas{gl::Texture(gl), faceSize};
  gl.BindTexture(GL_TEXTURE_2D, atlas.texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, atlas.width(), atlas.height());
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  context.check("environment atlas");
  return atlas;
}

std::vector<std::uint16_t> readAtlas(const gl::Context& context, const Atlas& atlas) {
  const gl::Functions& gl = context.gl();
  const std::size_t row = static_cast<std::size_t>(atlas.width()) * 4;
  std::vector<std::uint16_t> all(row * static_cast<std::size_t>(atlas.height()));
  const gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, atlas.texture.get(), 0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int level = 0; level < atlas.levels(); ++level) {
    const gl::Pacer::Rectangle tiles = atlas.tilesOf(level);
    const std::size_t length = static_cast<std::size_t>(tiles.width) * 4;
    std::vector<std::uint16_t> texels(length * static_cast<std::size_t>(tiles.height));
    gl.ReadPixels(tiles.x, tiles.y, tiles.width, tiles.height, GL_RGBA, GL_HALF_FLOAT, texels.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(tiles.height); ++y) {
      const std::size_t to = (static_cast<std::size_t>(tiles.y) + y) * row + static_cast<std::size_t>(tiles.x) * 4;
      std::copy_n(&texels[y * length], length, &all[to]);
    }
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  context.check("environment readback");
  return all;
}

void renderTiles(const gl::Context& context, gl::DrawCost& cost, const Atlas& target, int level,
                 const CancelToken& cancel) {
  const gl::Functions& gl = context.gl();
  cancel.check();
  const std::vector<Vertex> vertices = tileVertices(target.edgeOf(level));
  const gl::Framebuffer framebuffer(gl);
  const gl::VertexArray array(gl);
  const gl::Buffer buffer(gl);
  gl.BindVertexArray(array.get());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.get());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                GL_STATIC_DRAW);
  const auto attribute = [&gl](GLuint location, GLint size, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
  };
  attribute(CORNER, 2, offsetof(Vertex, corner));
  attribute(PLACE, 2, offsetof(Vertex, place));
  attribute(DIRECTION, 3, offsetof(Vertex, direction));

  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.get(), 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) gl::failIncomplete(gl, "the environment");
  const gl::Pacer::Rectangle tiles = target.tilesOf(level);
  gl.Viewport(tiles.x, tiles.y, tiles.width, tiles.height);
  for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(capability);
  const auto count = static_cast<GLsizei>(vertices.size());
  context.pacer().draw(cost, tiles.area(), tiles, [&gl, count] { gl.DrawArrays(GL_TRIANGLES, 0, count); });
  context.pacer().finish();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.BindVertexArray(0);
}

}  // namespace telar::ibl
