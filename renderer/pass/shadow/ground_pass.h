#pragma once
#include <map>
#include <tuple>

#include "gl/program.h"
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// Blends the shadows on the ground over what is behind them. Where there is no shadow it draws nothing.
class GroundPass {
 public:
  explicit GroundPass(const gl::Context& context) : context_(context) {}

  /// The target is bound and holds the opaque surfaces; the shadow maps are bound from `firstUnit` on.
  void draw(const FramePlan& plan, const Shot& shot, GLuint firstUnit);

 private:
  /// Numbers of flat and cube maps, tone mapping, linear output, terms of a release.
  using Key = std::tuple<std::size_t, std::size_t, shader::ToneMapping, bool, ThreeTerms>;
  const gl::Program& program(const Key& key);
  void makeRectangle(const glm::dvec2& size);

  const gl::Context& context_;
  std::map<Key, gl::Program> programs_;
  gl::DrawCost cost_{2};  // of some lights' shadows
  gl::VertexArray rectangle_;
  gl::Buffer corners_;
};

}  // namespace telar::pass
