#pragma once
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "gl/program.h"
#include "telar/cancel.h"

namespace telar::pass {

/// Makes textures whose mip levels hold moments and coverage in place of plain averages (shaders/texture). Keeps its
/// programs.
class TextureBaker {
 public:
  explicit TextureBaker(const gl::Context& context) : context_(context) {}

  /// A normal map as relief, RGBA16F: RGB = the mean of unit normals, whose length tells how far they differ, A = the
  /// mean of 1 / (1 + 4 slope^2). All can be filtered.
  /// @param source its level 0 holds the normals; `width` x `height` texels
  /// @param cover  its level 0 tells holes, which lie flat, by an alpha below `cutoff`; 0 = there are none
  gl::Texture normalVariance(GLuint source, int width, int height, GLuint cover, float cutoff,
                             const CancelToken& cancel);

  /// The flat part of a normal map, RGBA16F: its slopes RG and their square A, each times its share B.
  /// @param source as above
  gl::Texture normalFacets(GLuint source, int width, int height, const CancelToken& cancel);

  /// How flat the yarns of a woven material lie, RGBA16F: means of 1 / (1 + 4 slope^2) along the warp and across it,
  /// times its share, and those of the weft. Slopes are those of normal map and weave map together. A quarter as wide
  /// and high as the source.
  /// @param source as above      @param yarns  its level 0 is the weave map
  gl::Texture yarnRelief(GLuint source, int width, int height, GLuint yarns, const CancelToken& cancel);

  /// What of a base colour is metal's, SRGB8_ALPHA8 or RGBA8: RGB = base colour times metalness, A = metalness times
  /// the share of the warp.
  /// @param source    its level 0 holds the colours; `width` x `height` texels
  /// @param metallic  its level 0 holds the metalness, in blue
  /// @param yarns     its level 0 tells the warp, by alpha; 0 = the material is not woven
  gl::Texture metal(GLuint source, bool srgb, int width, int height, GLuint metallic, GLuint yarns,
                    const CancelToken& cancel);

  /// An alpha-tested colour map, SRGB8_ALPHA8 or RGBA8. Level 0 is the source's. In the others alpha is the part of the
  /// texel that passes the test, and the colour is the mean of that part.
  /// @param cutoff smallest alpha that passes the test
  gl::Texture coverage(GLuint source, bool srgb, int width, int height, float cutoff, const CancelToken& cancel);

 private:
  struct Kind;
  struct Beside;
  gl::Texture bake(const Kind& kind, GLuint source, int width, int height, const Beside& beside,
                   const CancelToken& cancel);
  const gl::Program& program(const char* file, bool fromImage, const Beside& beside);

  const gl::Context& context_;
  std::map<std::tuple<std::string, bool, bool, bool>, gl::Program> programs_;  ///< by file, FROM_IMAGE, HOLES, YARNS
  gl::DrawCost cost_;
};

}  // namespace telar::pass
