#include "pass/background_pass.h"

namespace telar::pass {
namespace {

/// Twelve triangles of a cube of edge 1, facing outwards.
std::vector<glm::vec3> cubeTriangles() {
  std::vector<glm::vec3> out;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5f, 0.5f}) {
      const auto corner = [&](float u, float v) {
        glm::vec3 p(0.0f);
        p[axis] = side;
        p[(axis + 1) % 3] = side < 0 ? v : u;
        p[(axis + 2) % 3] = side < 0 ? u : v;
        return p;
      };
      for (const glm::vec2 uv :
           {glm::vec2(-0.5f, -0.5f), {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}) {
        out.push_back(corner(uv.x, uv.y));
      }
    }
  }
  return out;
}

}  // namespace

void BackgroundPass::draw(const frame::Camera& camera, const Shot& shot, const ibl::Environment& environment,
                          const shader::VariantKey& frame) {
  const gl::Functions& gl = context_.gl();
  const bool blurred = shot.background.blur > 0;
  const int prefilter = blurred ? frame.three.prefilter : 0;
  const bool atlas = blurred && ibl::hasAtlas(frame.three);
  const Key key{frame.toneMapping, frame.three.neutralToneMapping, frame.outputLinear, blurred,
                prefilter,         frame.three.samplerPrecision};
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    const shader::Defines defines{{"TONE_MAPPING", static_cast<int>(frame.toneMapping)},
                                  {"THREE_NEUTRAL_TONE_MAPPING_TERM", frame.three.neutralToneMapping},
                                  {"OUTPUT_LINEAR", frame.outputLinear ? 1 : 0},
                                  {"BLURRED", blurred ? 1 : 0},
                                  {"THREE_PREFILTER_TERM", prefilter},
                                  {"THREE_SAMPLER_PRECISION_TERM", frame.three.samplerPrecision}};
    found = programs_
                .emplace(key, gl::Program(context_, "background", shader::assemble("environment/background.vert", {}),
                                          shader::assemble("environment/background.frag", defines)))
                .first;
  }
  constexpr GLsizei VERTICES = 36;
  if (!cube_) {
    cube_ = gl::VertexArray(gl);
    corners_ = gl::Buffer(gl);
    const auto triangles = cubeTriangles();
    gl.BindVertexArray(cube_.get());
    gl.BindBuffer(GL_ARRAY_BUFFER, corners_.get());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec3)), triangles.data(),
                  GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  const gl::Program& program = found->second;
  program.use();
  program.set("modelViewMatrix", glm::mat4(glm::dmat4(glm::dmat3(camera.view))));
  program.set("projectionMatrix", glm::mat4(camera.projection));
  program.set("backgroundMap", 0);
  program.set("backgroundIntensity", static_cast<float>(shot.environment.intensity));
  const double rotation = shot.environment.rotation;
  program.set("backgroundRotation", frame::environmentRotation(rotation - ibl::turnOfTexels(frame.three, rotation)));
  program.set("exposure", static_cast<float>(shot.exposure));
  if (blurred) {
    program.set("backgroundBlur", static_cast<float>(shot.background.blur));
    const int maxLod = atlas ? environment.atlas.maxMip() : ibl::maxLodOf(environment.prefiltered);
    program.set("backgroundMaxLod", static_cast<float>(maxLod));
  }
  gl.ActiveTexture(GL_TEXTURE0);
  if (atlas) {
    program.set("backgroundTexel", environment.atlas.texel());
    gl.BindTexture(GL_TEXTURE_2D, environment.atlas.texture.get());
  } else {
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, (blurred ? environment.prefiltered : environment.background).texture.get());
  }
  gl.BindSampler(0, 0);
  for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND}) gl.Disable(capability);
  // Without perspective the near sides lie over the far ones.
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.FrontFace(GL_CCW);
  gl.DepthMask(GL_FALSE);
  gl.BindVertexArray(cube_.get());
  const gl::Pacer::Rectangle target{0, 0, shot.width, shot.height};
  context_.pacer().draw(cost_, target.area(), target, [&gl] { gl.DrawArrays(GL_TRIANGLES, 0, VERTICES); });
  gl.BindVertexArray(0);
  gl.Disable(GL_CULL_FACE);
  gl.DepthMask(GL_TRUE);
  context_.check("background pass");
}

}  // namespace telar::pass
