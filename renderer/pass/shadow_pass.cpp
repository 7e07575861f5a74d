#include "pass/shadow_pass.h"

#include <string>

#include "gl/incomplete.h"
#include "pass/sliced_draw.h"
#include "shader/library.h"

namespace telar::pass {
namespace {

/// As a shader compares: 1 where the map's depth is not less, four texels blended.
void setComparison(const gl::Functions& gl, GLenum target) {
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

bool isMasked(const DrawItem& item) {
  return item.material->alphaMode == AlphaMode::kMask && item.material->alphaCutoff > 0 &&
         item.material->baseColorTexture;
}

/// `name[index]`
std::string element(const char* name, std::size_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

/// Uniforms of one kind of map; `name` is "flatShadow" or "cubeShadow".
void uploadKind(const gl::Program& program, const std::string& name, const std::vector<ShadowMap>& maps,
                std::size_t count, GLuint firstUnit) {
  std::vector<glm::mat4> matrices;
  std::vector<glm::vec4> settings;
  std::vector<glm::vec2> ranges;
  std::vector<float> normalBiases;
  for (std::size_t i = 0; i < count; ++i) {
    const Shot::Light::Shadow& s = maps[i].settings;
    matrices.emplace_back(maps[i].matrix);
    settings.emplace_back(glm::dvec4(s.radius, s.mapSize, s.bias, s.intensity));
    ranges.emplace_back(glm::dvec2(s.near, s.far));
    normalBiases.push_back(static_cast<float>(s.normalBias));
    program.set(element((name + "Map").c_str(), i).c_str(), static_cast<int>(firstUnit + i));
  }
  program.set((name + "Matrix").c_str(), matrices);
  program.set(name.c_str(), settings);
  program.set((name + "Range").c_str(), ranges);
  program.set((name + "NormalBias").c_str(), normalBiases);
}

}  // namespace

bool castsShadow(const DrawItem& item) {
  return item.primitive->topology == Topology::kTriangles && !item.key.flipSided;
}

ShadowPass::Target ShadowPass::makeTarget(bool cube, int size) const {
  const gl::Functions& gl = context_.gl();
  checkLimit("L_OUTPUT_SIZE", context_.capabilities().maxTextureSize, size, "/lights");
  const GLenum kind = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
  Target target{cube, size, gl::Texture(gl), {}};
  gl.BindTexture(kind, target.depth.get());
  gl.TexStorage2D(kind, 1, GL_DEPTH_COMPONENT24, size, size);
  setComparison(gl, kind);
  for (int face = 0; face < (cube ? 6 : 1); ++face) {
    gl::Framebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    const GLenum plane = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, plane, target.depth.get(), 0);
    const GLenum none = GL_NONE;
    gl.DrawBuffers(1, &none);
    target.faces.push_back(std::move(framebuffer));
  }
  context_.check("shadow map creation");
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    gl::failIncomplete(gl, "a shadow map of " + std::to_string(size) + " texels a side");
  return target;
}

void ShadowPass::resize(const ShadowSet& shadows) {
  std::vector<std::pair<bool, int>> wanted;
  for (const ShadowMap& map : shadows.flat) wanted.emplace_back(false, map.settings.mapSize);
  for (const ShadowMap& map : shadows.cube) wanted.emplace_back(true, map.settings.mapSize);
  if (targets_.size() > wanted.size()) targets_.resize(wanted.size());
  // Frees maps of the wrong size first: memory may not hold both sets.
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (std::pair(targets_[i].cube, targets_[i].size) != wanted[i]) targets_[i] = Target();
  }
  targets_.resize(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!targets_[i].depth) targets_[i] = makeTarget(wanted[i].first, wanted[i].second);
  }
}

ShadowPass::Caster& ShadowPass::caster(CasterKey key) {
  const auto found = casters_.find(key);
  if (found != casters_.end()) return found->second;
  const shader::Defines defines{{"ALPHA_MASK", key.mask}, {"BASE_COLOR_UV1", key.uv1}, {"INSTANCING", key.instancing}};
  gl::Program program(context_, "shadow caster", shader::assemble("shadow/caster.vert", defines),
                      shader::assemble("shadow/caster.frag", defines));
  return casters_.emplace(key, Caster{std::move(program), gl::DrawCost()}).first->second;
}

void ShadowPass::drawView(const frame::Camera& view, int mapSize, const FramePlan& plan, const Scene& scene,
                          GpuScene& gpu, const CancelToken& cancel) {
  const gl::Functions& gl = context_.gl();
  const gl::Program* current = nullptr;
  for (const auto* list : plan.draws.shown()) {
    for (const DrawItem& item : *list) {
      if (!castsShadow(item)) continue;
      cancel.check();
      const Material& material = *item.material;
      const bool masked = isMasked(item);
      Caster& used = caster({masked, masked && material.baseColorTexture.texCoord == 1, item.key.instancing});
      const gl::Program& wanted = used.program;
      if (&wanted != current) {
        current = &wanted;
        wanted.use();
        wanted.set("projectionMatrix", glm::mat4(view.projection));
      }
      wanted.set("modelViewMatrix", glm::mat4(view.view * item.node->world));
      if (masked) {
        wanted.set("baseColorMap", 0);
        wanted.set("baseColorUvTransform", material.baseColorTexture.uvTransform);
        wanted.set("alphaCutoff", material.alphaCutoff);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindTexture(GL_TEXTURE_2D, gpu.texture(scene, material.baseColorTexture.image, true, cancel));
        gl.BindSampler(0, gpu.sampler(material.baseColorTexture.sampler));
      }
      material.doubleSided ? gl.Disable(GL_CULL_FACE) : gl.Enable(GL_CULL_FACE);
      // Of one-sided surfaces the back sides are drawn, so that the lit side does not shadow itself.
      gl.FrontFace(item.mirrored ? GL_CCW : GL_CW);
      SlicedDraw(context_, used.cost, item, gpu, view.projection * view.view, mapSize, mapSize).run();
    }
  }
}

void ShadowPass::draw(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  resize(plan.shadows);
  if (plan.shadows.empty()) return;
  const gl::Functions& gl = context_.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.ClearDepthf(1.0f);
  gl.CullFace(GL_BACK);
  gl.VertexAttrib4f(UV0, 0, 0, 0, 1);
  gl.VertexAttrib4f(UV1, 0, 0, 0, 1);
  std::size_t index = 0;
  for (const auto* maps : {&plan.shadows.flat, &plan.shadows.cube}) {
    for (const ShadowMap& map : *maps) {
      const Target& target = targets_[index++];
      gl.Viewport(0, 0, target.size, target.size);
      for (std::size_t face = 0; face < map.views.size(); ++face) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, target.faces[face].get());
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        drawView(map.views[face], target.size, plan, scene, gpu, cancel);
      }
    }
  }
  gl.BindVertexArray(0);
  gl.BindSampler(0, 0);
  context_.check("shadow pass");
}

void ShadowPass::bind(const ShadowSet& shadows, GLuint firstUnit) const {
  const gl::Functions& gl = context_.gl();
  for (std::size_t i = 0; i < shadows.flat.size() + shadows.cube.size(); ++i) {
    const GLuint unit = firstUnit + static_cast<GLuint>(i);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(targets_[i].cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, targets_[i].depth.get());
    gl.BindSampler(unit, 0);
  }
  gl.ActiveTexture(GL_TEXTURE0);  // what others create does not take a map's place
}

void uploadShadows(const gl::Program& program, const ShadowSet& shadows, std::size_t flat, std::size_t cube,
                   GLuint firstUnit) {
  uploadKind(program, "flatShadow", shadows.flat, flat, firstUnit);
  uploadKind(program, "cubeShadow", shadows.cube, cube, firstUnit + static_cast<GLuint>(shadows.flat.size()));
}

}  // namespace telar::pass
