#include "pass/shadow/ground_pass.h"

#include <array>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "pass/plan/world_origin.h"
#include "pass/shadow/shadow_pass.h"

namespace telar::pass {

const gl::Program& GroundPass::program(const Key& key) {
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  const auto& [flat, cube, toneMapping, linear, three] = key;
  const shader::Defines defines{{"FLAT_SHADOWS", static_cast<int>(flat)},
                                {"CUBE_SHADOWS", static_cast<int>(cube)},
                                {"SHADING_FABRIC", 0},  // seen from above alone
                                {"TONE_MAPPING", static_cast<int>(toneMapping)},
                                {"THREE_NEUTRAL_TONE_MAPPING_TERM", 0},  // black is black in both
                                {"OUTPUT_LINEAR", linear ? 1 : 0},
                                {"THREE_SHADOW_FILTER_TERM", three.shadowFilter},
                                {"THREE_SHADOW_PACKING_TERM", three.shadowPacking},
                                {"THREE_SHADOW_NORMAL_OFFSET_TERM", three.shadowNormalOffset},
                                {"THREE_POINT_SHADOW_TERM", three.pointShadow},
                                {"THREE_SAMPLER_PRECISION_TERM", three.samplerPrecision}};
  return programs_
      .emplace(key, gl::Program(context_, "ground", shader::assemble("shadow/ground.vert", defines),
                                shader::assemble("shadow/ground.frag", defines)))
      .first->second;
}

void GroundPass::makeRectangle(const glm::dvec2& size) {
  const gl::Functions& gl = context_.gl();
  rectangle_ = gl::VertexArray(gl);
  corners_ = gl::Buffer(gl);
  const glm::vec2 half(size / 2.0);
  const std::array<glm::vec3, 6> corners{{{-half.x, 0, -half.y},
                                          {-half.x, 0, half.y},
                                          {half.x, 0, half.y},
                                          {-half.x, 0, -half.y},
                                          {half.x, 0, half.y},
                                          {half.x, 0, -half.y}}};
  gl.BindVertexArray(rectangle_.get());
  gl.BindBuffer(GL_ARRAY_BUFFER, corners_.get());
  gl.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void GroundPass::draw(const FramePlan& plan, const Shot& shot, GLuint firstUnit) {
  const gl::Functions& gl = context_.gl();
  const ShadowSet& shadows = plan.shadows;
  const gl::Program& program = this->program(
      {shadows.flat.size(), shadows.cube.size(), plan.frame.toneMapping, plan.frame.outputLinear, plan.frame.three});
  makeRectangle(shot.ground->size);
  program.use();
  const glm::dmat4 world = glm::translate(glm::dmat4(1.0), shot.ground->position);
  const glm::dmat4 modelView = plan.camera.view * world;
  program.set("modelViewMatrix", glm::mat4(modelView));
  program.set("projectionMatrix", glm::mat4(plan.camera.projection));
  program.set("normalMatrix", glm::mat3(glm::inverseTranspose(glm::dmat3(modelView))));
  program.set("modelMatrix", glm::mat4(fromOrigin(world, plan.origin)));
  program.set("viewMatrix", glm::mat4(toOrigin(plan.camera.view, plan.origin)));
  program.set("opacity", static_cast<float>(shot.ground->opacity));
  program.set("exposure", static_cast<float>(shot.exposure));
  uploadShadows(program, shadows, shadows.flat.size(), shadows.cube.size(), firstUnit);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CCW);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.BindVertexArray(rectangle_.get());
  const gl::Pacer::Rectangle target{0, 0, shot.width, shot.height};
  context_.pacer().draw(cost_, target.area(), target, [&gl] { gl.DrawArrays(GL_TRIANGLES, 0, 6); });
  gl.BindVertexArray(0);
  gl.DepthMask(GL_TRUE);
  context_.check("ground pass");
}

}  // namespace telar::pass
