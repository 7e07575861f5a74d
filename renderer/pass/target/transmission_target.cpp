#include "pass/target/transmission_target.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "gl/clamped_sampling.h"
#include "gl/incomplete.h"

namespace telar::pass {

TransmissionTarget::Extent TransmissionTarget::extentOf(const Shot& shot, const ThreeTerms& three) {
  constexpr int SQUARE = 1024, SAMPLES = 4;
  const bool square = three.glassBuffer == ThreeTerms::THREE_GLASS_BUFFER_SQUARE_1024;
  const bool asFrame = three.glassSamples == ThreeTerms::THREE_GLASS_SAMPLES_OF_CANVAS ||
                       three.glassSamples == ThreeTerms::THREE_GLASS_SAMPLES_OF_ANTIALIAS;
  const auto scaled = [&](int side) {
    return std::max(static_cast<int>(std::lround((square ? SQUARE : side) * shot.transmissionScale)), 1);
  };
  return {scaled(shot.width), scaled(shot.height), asFrame && shot.samples == 1 ? 1 : SAMPLES};
}

TransmissionTarget::TransmissionTarget(const gl::Context& context, const Extent& extent)
    : context_(context), extent_(extent), color_(context.gl()), resolved_(context.gl()) {
  const gl::Functions& gl = context_.gl();
  const auto [width, height, samples] = extent;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, color_.get());
  gl.TexStorage2D(GL_TEXTURE_2D, static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(width, height)))),
                  GL_RGBA16F, width, height);
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.get(), 0);
  // A GPU may lack multisampled half floats.
  const int most = std::min(samples, context.capabilities().maxSamples);
  const bool complete =
      draw_.allocate(gl, GL_RGBA16F, most, width, height) || draw_.allocate(gl, GL_RGBA16F, 1, width, height);
  context_.check("creation of the transmission target");
  if (!complete) gl::failIncomplete(gl, "what lies behind transmissive materials");
}

void TransmissionTarget::resolve() const {
  const gl::Functions& gl = context_.gl();
  draw_.resolveInto(gl, resolved_.get());
  draw_.bind(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, color_.get());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  context_.check("transmission target");
}

}  // namespace telar::pass
