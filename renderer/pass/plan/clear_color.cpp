#include "pass/plan/clear_color.h"

#include "brdf/brdf.h"

namespace telar::pass {
namespace {

bool hasColor(const Shot& shot) { return shot.background.type == Shot::Background::Type::kColor; }

}  // namespace

glm::vec4 clearColor(const Shot& shot, bool linear) {
  if (!hasColor(shot)) return glm::vec4(0);
  const glm::vec3 color = shot.background.color;
  return {linear ? color : brdf_f::srgbFromLinear(glm::clamp(color, 0.0f, 1.0f)), 1.0f};
}

glm::vec4 clearColorBehind(const Shot& shot, const ThreeTerms& three) {
  if (three.glassBackground == ThreeTerms::THREE_GLASS_BACKGROUND_AS_CANVAS) return clearColor(shot, false);
  if (hasColor(shot) && three.glassBackground == ThreeTerms::THREE_GLASS_BACKGROUND_LINEAR)
    return clearColor(shot, true);
  return glm::vec4(0.5f);
}

bool piercesColor(const FramePlan& plan, const Shot& shot) {
  return hasColor(shot) && !plan.draws.transmissive.empty() &&
         plan.frame.three.glassBackground == ThreeTerms::THREE_GLASS_BACKGROUND_HALF_WHITE;
}

bool fillsBackground(const FramePlan& plan, const Shot& shot) {
  if (plan.environmentBackground) return shot.camera.projection == Projection::kPerspective;
  return hasColor(shot) && shot.resolve != Resolve::kLinear && !piercesColor(plan, shot);
}

Behind behindOf(const FramePlan& plan, const Shot& shot) {
  const bool debug = plan.frame.debugOutput;
  const bool opaque = !debug && fillsBackground(plan, shot);
  const bool none = debug || shot.resolve == Resolve::kLinear;
  const glm::vec4 color = none ? glm::vec4(0) : clearColor(shot, plan.frame.outputLinear);
  return {opaque, opaque ? glm::vec4(glm::vec3(color), 0.0f) : color};
}

void clearTarget(const gl::Functions& gl, const glm::vec4& color) {
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_TRUE);
  gl.ClearColor(color.r, color.g, color.b, color.a);
  gl.ClearDepthf(1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void writeAlpha(const gl::Functions& gl, bool write) {
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, write ? GL_TRUE : GL_FALSE);
}

}  // namespace telar::pass
