#pragma once
#include <map>
#include <string>
#include <utility>

#include "gl/program.h"
#include "telar/cancel.h"

namespace telar::pass {

/// Makes textures whose mip levels keep what plain averages of texels lose (shaders/texture). Keeps its programs.
class TextureBaker {
 public:
  explicit TextureBaker(const gl::Context& context) : context_(context) {}

  /// A normal map as slopes, RGBA16F: RG = their mean along tangent and bitangent, BA = the mean of their squares. Both
  /// may be filtered: what they differ by is the variance of all that was filtered.
  /// @param source its level 0 holds the normals; `width` x `height` texels
  gl::Texture normalVariance(GLuint source, int width, int height, const CancelToken& cancel);

  /// A colour map with holes, SRGB8_ALPHA8 or RGBA8: level 0 is the source's; in the others alpha is the share of the
  /// texel that is there, and the colour that of this part.
  /// @param cutoff alpha from which on a texel is there
  gl::Texture coverage(GLuint source, bool srgb, int width, int height, float cutoff, const CancelToken& cancel);

 private:
  struct Kind;
  gl::Texture bake(const Kind& kind, GLuint source, int width, int height, float cutoff, const CancelToken& cancel);
  const gl::Program& program(const char* file, bool fromImage);

  const gl::Context& context_;
  std::map<std::pair<std::string, bool>, gl::Program> programs_;
  gl::DrawCost cost_;
};

}  // namespace telar::pass
