#pragma once
#include <tuple>

#include "frame/camera.h"
#include "gl/program.h"
#include "ibl/environment_cache.h"
#include "shader/variant_key.h"

namespace telar::pass {

/// The environment behind the model, sharp or blurred, tone mapped like the model.
class BackgroundPass {
 public:
  explicit BackgroundPass(const gl::Context& context) : context_(context) {}

  /// The target is bound and cleared.
  void draw(const frame::Camera& camera, const Shot& shot, const ibl::Environment& environment,
            const shader::VariantKey& frame);

 private:
  const gl::Context& context_;
  /// Neutral tone mapping's form, linear output, blurred, terms of prefilter and samplers.
  using Key = std::tuple<shader::ToneMapping, int, bool, bool, int, int>;
  std::map<Key, gl::Program> programs_;
  gl::DrawCost cost_;
  gl::VertexArray cube_;
  gl::Buffer corners_;
};

}  // namespace telar::pass
