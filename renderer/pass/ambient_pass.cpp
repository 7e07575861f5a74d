#include "pass/ambient_pass.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "pass/layer_pass.h"
#include "shader/library.h"

namespace telar::pass {
namespace {

constexpr int MAPS = 8;          ///< a pass reads: a driver has 16 units at least
constexpr int DIRECTIONS = 256;  ///< half of them lie above a surface
constexpr int SIDE = 1024;       ///< texels
/// A surface is looked up so many texels above itself, so that it does not hide itself: a bilinear tap reaches 1.5.
constexpr double LIFT = 2;

/// Points spread evenly over the unit sphere.
/// src: Swinbank and Purser 2006, "Fibonacci grids: A novel approach to global modelling"
glm::dvec3 directionOf(int i) {
  const double y = 1 - (2 * i + 1.0) / DIRECTIONS, r = std::sqrt(1 - y * y);
  const double phi = i * glm::pi<double>() * (3 - std::sqrt(5.0));
  return {r * std::cos(phi), y, r * std::sin(phi)};
}

/// A sphere about all that is drawn.
struct Sphere {
  glm::dvec3 centre{0};
  double radius = 1;
};

Sphere sphereOf(const Bounds& bounds) {
  if (bounds.empty()) return {};
  const double radius = glm::length(bounds.max - bounds.min) / 2;
  return {(bounds.min + bounds.max) * 0.5, radius > 0 ? radius : 1.0};
}

/// The map that sees the sphere from a direction.
ShadowMap mapFrom(const glm::dvec3& direction, const Sphere& sphere) {
  ShadowMap map{Shot::Light::Type::kDirectional, {}, {}, glm::dmat4(1.0)};
  map.settings.mapSize = SIDE;
  frame::Camera view;
  view.orthographic = true;
  const double r = sphere.radius * (1 + 4.0 * LIFT / SIDE);
  view.view = frame::lookAtView(sphere.centre + direction * (2 * r), sphere.centre, glm::dvec3(0, 1, 0));
  view.projection = glm::ortho(-r, r, -r, r, r, 3 * r);
  map.views = {view};
  return map;
}

}  // namespace

gl::Texture AmbientPass::draw(const AmbientInputs& in, const gl::Texture& place, const gl::Texture& number) {
  const gl::Functions& gl = context_.gl();
  if (!noVertices_) {
    program_ = gl::Program(context_, "ambient occlusion", shader::assemble("settled/settled.vert", {}),
                           shader::assemble("layers/ambient.frag", {{"MAPS", MAPS}}));
    noVertices_ = gl::VertexArray(gl);
  }
  const int width = in.shot.width, height = in.shot.height;
  gl::Texture sums = floatTexture(gl, width, height), before = floatTexture(gl, width, height);
  const gl::Framebuffer framebuffer(gl);
  const auto drawInto = [&](const gl::Texture& texture) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), 0);
    gl.Viewport(0, 0, width, height);
  };
  gl.ClearColor(0, 0, 0, 0);
  drawInto(sums);
  gl.Clear(GL_COLOR_BUFFER_BIT);

  const Sphere sphere = sphereOf(in.scene.bounds);
  const frame::Camera& camera = in.plan.camera;
  const glm::dmat4 toWorld = glm::inverse(camera.view);
  const glm::dmat4 clipToMap =
      glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
  for (int first = 0; first < DIRECTIONS; first += MAPS) {
    in.cancel.check();
    in.plan.shadows = {};
    std::vector<glm::mat4> toMap;
    std::vector<glm::vec3> directions;
    for (int i = first; i < first + MAPS; ++i) {
      const ShadowMap& map = in.plan.shadows.flat.emplace_back(mapFrom(directionOf(i), sphere));
      toMap.emplace_back(clipToMap * map.views[0].projection * map.views[0].view * toWorld);
      directions.emplace_back(glm::dmat3(camera.view) * directionOf(i));
    }
    maps_.draw(in.plan, in.scene, in.gpu, in.cancel);
    context_.pacer().finish();
    std::swap(sums, before);
    drawInto(sums);
    program_.use();
    GLuint unit = 0;
    for (const auto& [name, texture] : {std::pair("placeMap", &place), std::pair("numberMap", &number),
                                        std::pair("sumMap", &std::as_const(before))}) {
      program_.set(name, static_cast<int>(unit));
      gl.ActiveTexture(GL_TEXTURE0 + unit);
      gl.BindTexture(GL_TEXTURE_2D, texture->get());
      gl.BindSampler(unit++, 0);
    }
    maps_.bind(in.plan.shadows, unit);
    for (int i = 0; i < MAPS; ++i)
      program_.set(("depthMap[" + std::to_string(i) + "]").c_str(), static_cast<int>(unit) + i);
    program_.set("toMap", toMap);
    program_.set("direction", directions);
    program_.set("projectionMatrix", glm::mat4(camera.projection));
    program_.set("pictureSize", glm::vec2(width, height));
    program_.set("lift", static_cast<float>(LIFT * 2 * sphere.radius / SIDE));
    for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(capability);
    gl.BindVertexArray(noVertices_.get());
    const gl::Pacer::Rectangle target{0, 0, width, height};
    context_.pacer().draw(cost_, target.area(), target, [&gl] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    context_.pacer().finish();
    gl.BindVertexArray(0);
    // A map that is drawn again must not be bound.
    for (GLuint i = 0; i < unit + MAPS; ++i) {
      gl.ActiveTexture(GL_TEXTURE0 + i);
      gl.BindTexture(GL_TEXTURE_2D, 0);
    }
  }
  context_.check("ambient occlusion");
  return sums;
}

}  // namespace telar::pass
