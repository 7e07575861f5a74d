#pragma once
#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <utility>

#include "gl/program.h"
#include "shader/library.h"
#include "telar/cancel.h"

namespace telar::pass {

/// Level 0 of a 2D texture, and its texels.
struct BakeSource {
  GLuint texture = 0;  ///< 0 = there is none
  glm::ivec2 size{0};
};

/// Makes textures whose mip levels hold moments and coverage in place of plain averages (shaders/texture). Keeps its
/// programs, and what it needs in between: a GL that draws by the CPU clears a new texture page by page.
class TextureBaker {
 public:
  explicit TextureBaker(const gl::Context& context) : context_(context) {}

  /// A normal map as relief, RGBA16F: RGB = the mean of unit normals, whose length tells how far they differ, A = the
  /// mean of 1 / (1 + 4 slope^2). All can be filtered.
  /// @param source the normals
  /// @param cover  tells holes, which lie flat, by an alpha below `cutoff`, or by its alpha where that is 0; none = there
  ///               are no holes
  /// @param unread  largest levels that are not wanted: what is made begins with the next
  gl::Texture normalVariance(const BakeSource& source, const BakeSource& cover, float cutoff, int unread,
                             const CancelToken& cancel);

  /// The direction across the lines that a normal map's relief runs along: the axis of reliefTowards()
  /// (shaders/brdf/relief.glsl) in its tangent space. Waits for the GL.
  glm::vec2 reliefAxis(const BakeSource& source, const CancelToken& cancel);

  /// The flat part of a normal map, RGBA16F: its slopes RG and their square A, each times its share B.
  /// @param source the normals
  gl::Texture normalFacets(const BakeSource& source, const CancelToken& cancel);

  /// How flat the yarns of a woven material lie, RGBA16F: means of 1 / (1 + 4 slope^2) along the warp and across it,
  /// times its share, and those of the weft. Slopes are those of normal map and weave map together. A quarter as wide
  /// and high as the source.
  /// @param source the normals      @param yarns  the weave map
  gl::Texture yarnRelief(const BakeSource& source, const BakeSource& yarns, const CancelToken& cancel);

  /// What of a base colour is metal's, SRGB8_ALPHA8 or RGBA8: RGB = base colour times metalness, A = metalness times
  /// the share of the warp.
  /// @param source    the colours
  /// @param metallic  the metalness, in blue
  /// @param yarns     tells the warp, by alpha; none = the material is not woven
  /// @param unread    as of normalVariance()
  gl::Texture metal(const BakeSource& source, bool srgb, const BakeSource& metallic, const BakeSource& yarns,
                    int unread, const CancelToken& cancel);

  /// A colour map with holes, SRGB8_ALPHA8 or RGBA8. Of an alpha-tested one level 0 is the source's, in the others alpha is
  /// the part of the texel that passes the test, and the colour is the mean of that part. Of a blended one colours are
  /// times alpha in all levels.
  /// @param cutoff  smallest alpha that passes the test; 0 = it is blended
  gl::Texture coverage(const BakeSource& source, bool srgb, float cutoff, const CancelToken& cancel);

 private:
  struct Kind;
  struct Beside;
  gl::Texture bake(const Kind& kind, const BakeSource& source, const Beside& beside, const CancelToken& cancel);
  const gl::Program& program(const char* file, const shader::Defines& features);

  /// Of moments that stay for the next texture: those of one of 2048 x 2048 texels.
  static constexpr std::size_t MOST_KEPT_BYTES = std::size_t{22} << 20;

  const gl::Context& context_;
  std::map<std::pair<std::string, shader::Defines>, gl::Program> programs_;  ///< by file and features
  std::map<std::pair<int, int>, gl::Texture> moments_;                       ///< by width and height
  gl::DrawCost cost_, axisCost_{32};  ///< of a fragment: that of the axis looks at 1024 texels
};

}  // namespace telar::pass
