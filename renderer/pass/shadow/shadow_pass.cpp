#include "pass/shadow/shadow_pass.h"

#include <array>
#include <string>

#include "frame/variant.h"
#include "gl/clamped_sampling.h"
#include "gl/incomplete.h"
#include "pass/plan/world_origin.h"
#include "pass/visible/sliced_draw.h"
#include "shader/library.h"

namespace telar::pass {
namespace {

/// As a shader compares: 1 where the map's depth is not less, four texels blended.
void setComparison(const gl::Functions& gl, GLenum target) {
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl::setClampedSampling(gl, target, GL_LINEAR, GL_LINEAR);
}

/// Faces of an atlas.
constexpr glm::ivec2 ATLAS{4, 2};

/// Where the faces +x -x +y -y +z -z stand in the atlas: atlasPlace() in shaders/shadow/packed_grid.glsl.
constexpr std::array<glm::ivec2, 6> ATLAS_PLACES{{{2, 1}, {0, 1}, {3, 0}, {1, 0}, {3, 1}, {1, 1}}};

/// Texels of a map that a view is drawn into.
gl::Pacer::Rectangle placeOf(const ShadowMap& map, std::size_t face) {
  const int size = map.settings.mapSize;
  const bool atlas = map.packed && map.type == Shot::Light::Type::kPoint;
  const glm::ivec2 at = atlas ? ATLAS_PLACES[face] * size : glm::ivec2(0);
  return {at.x, at.y, size, size};
}

bool isMasked(const Material& material) {
  return material.alphaMode == AlphaMode::kMask && material.alphaCutoff > 0 && material.baseColorTexture;
}

/// Whether a caster has holes for light by its alpha.
bool letsLightThrough(const DrawItem& item, const FramePlan& plan, const Scene& scene) {
  const Material& material = *item.material;
  const bool blended = material.alphaMode == AlphaMode::kBlend;
  if (plan.everyHole) return blended || isMasked(material);
  // Unlit ones are three.js's own in the browser. The material that layers are drawn with does not say so.
  const bool unlit = frame::materialAt(scene, item.materialIndex, ShadingModel::kFabric).unlit;
  const bool mayBeSheer = material.baseColorFactor.a < 1 || material.baseColorTexture;
  return plan.sheerShadows && blended && mayBeSheer && !unlit;
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

void ShadowPass::makeDepthPlanes(Target& target) const {
  const gl::Functions& gl = context_.gl();
  const auto [cube, packed, size] = target.kind;
  gl.TexStorage2D(target.kind.texture(), 1, GL_DEPTH_COMPONENT24, size, size);
  setComparison(gl, target.kind.texture());
  for (int face = 0; face < (cube ? 6 : 1); ++face) {
    gl::Framebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    const GLenum plane = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, plane, target.texture.get(), 0);
    const GLenum none = GL_NONE;
    gl.DrawBuffers(1, &none);
    target.planes.push_back(std::move(framebuffer));
  }
}

void ShadowPass::makePackedPlane(Target& target) const {
  const gl::Functions& gl = context_.gl();
  const glm::ivec2 size = target.kind.size * (target.kind.cube ? ATLAS : glm::ivec2(1));
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size.x, size.y);
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  target.depth = gl::Renderbuffer(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, target.depth.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH_COMPONENT24, size.x, size.y);
  gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture.get(), 0);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
  target.planes.push_back(std::move(framebuffer));
}

ShadowPass::Target ShadowPass::makeTarget(const Kind& kind) const {
  const gl::Functions& gl = context_.gl();
  const int widest = kind.cube && kind.packed ? kind.size * ATLAS.x : kind.size;
  checkLimit("L_OUTPUT_SIZE", context_.capabilities().maxTextureSize, widest, "/lights");
  Target target{kind, gl::Texture(gl), {}, {}};
  gl.BindTexture(kind.texture(), target.texture.get());
  kind.packed ? makePackedPlane(target) : makeDepthPlanes(target);
  context_.check("shadow map creation");
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    gl::failIncomplete(gl, "a shadow map of " + std::to_string(kind.size) + " texels a side");
  return target;
}

void ShadowPass::resize(const ShadowSet& shadows) {
  std::vector<Kind> wanted;
  for (const ShadowMap& map : shadows.flat) wanted.push_back({false, map.packed, map.settings.mapSize});
  for (const ShadowMap& map : shadows.cube) wanted.push_back({true, map.packed, map.settings.mapSize});
  if (targets_.size() > wanted.size()) targets_.resize(wanted.size());
  // Frees maps of the wrong size first: memory may not hold both sets.
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (targets_[i].kind != wanted[i]) targets_[i] = Target();
  }
  targets_.resize(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!targets_[i].texture) targets_[i] = makeTarget(wanted[i]);
  }
}

ShadowPass::Caster& ShadowPass::caster(CasterKey key) {
  const auto found = casters_.find(key);
  if (found != casters_.end()) return found->second;
  const shader::Defines defines{{"ALPHA_MAP", key.alphaMap},
                                {"EVERY_HOLE", key.everyHole},
                                {"BASE_COLOR_UV1", key.uv1},
                                {"INSTANCING", key.instancing},
                                {"PACKED_DEPTH", key.packedDepth},
                                {"PACKED_DISTANCE", key.packedDistance},
                                {"THREE_SHADOW_PACKING_TERM", key.packing},
                                {"THREE_SAMPLER_PRECISION_TERM", key.samplerPrecision}};
  gl::Program program(context_, "shadow caster", shader::assemble("shadow/caster.vert", defines),
                      shader::assemble("shadow/caster.frag", defines));
  return casters_.emplace(key, Caster{std::move(program), gl::DrawCost()}).first->second;
}

void ShadowPass::drawView(const ShadowMap& map, std::size_t face, const FramePlan& plan, const Scene& scene,
                          GpuScene& gpu, const CancelToken& cancel) {
  const gl::Functions& gl = context_.gl();
  const frame::Camera& view = map.views[face];
  const bool distance = map.packed && map.type == Shot::Light::Type::kPoint;
  const ThreeTerms& three = plan.frame.three;
  const gl::Program* current = nullptr;
  for (const auto* list : plan.draws.shown()) {
    for (const DrawItem& item : *list) {
      if (!item.castsShadow()) continue;
      cancel.check();
      const Material& material = *item.material;
      const bool everyHole = letsLightThrough(item, plan, scene);
      const bool cut = everyHole && material.alphaMode == AlphaMode::kMask;
      if (cut && textureCutoff(material) > 1) continue;  // all of it is cut out
      const bool mapped = isMasked(material) || (everyHole && material.baseColorTexture);
      Caster& used = caster({mapped, everyHole, mapped && material.baseColorTexture.texCoord == 1, item.key.instancing,
                             map.packed && !distance, distance, map.packed ? three.shadowPacking : 0,
                             mapped ? three.samplerPrecision : 0});
      const gl::Program& wanted = used.program;
      if (&wanted != current) {
        current = &wanted;
        wanted.use();
        wanted.set("projectionMatrix", glm::mat4(view.projection));
        if (distance) {
          wanted.set("range", glm::vec2(glm::dvec2(map.settings.near, map.settings.far)));
          wanted.set("lightPosition", -glm::vec3(map.matrix[3]));
        }
      }
      wanted.set("modelViewMatrix", glm::mat4(view.view * item.node->world));
      if (distance) wanted.set("modelMatrix", glm::mat4(fromOrigin(item.node->world, plan.origin)));
      if (everyHole) wanted.set("alphaFactor", cut ? 1.0f : material.baseColorFactor.a);
      if (cut) {
        wanted.set("alphaCutoff", textureCutoff(material));
      } else if (mapped || everyHole) {
        wanted.set("alphaCutoff", material.alphaMode == AlphaMode::kMask ? material.alphaCutoff : 0.0f);
      }
      if (mapped) {
        wanted.set("baseColorMap", 0);
        wanted.set("baseColorUvTransform", material.baseColorTexture.uvTransform);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindTexture(GL_TEXTURE_2D, gpu.texture(scene, material.baseColorTexture.image, true, cancel));
        gl.BindSampler(0, gpu.sampler(material.baseColorTexture.sampler));
      }
      material.doubleSided ? gl.Disable(GL_CULL_FACE) : gl.Enable(GL_CULL_FACE);
      // Of one-sided surfaces the back sides are drawn, so that the lit side does not shadow itself.
      gl.FrontFace(item.mirrored ? GL_CCW : GL_CW);
      SlicedDraw(context_, used.cost, item, gpu, view.projection * view.view, placeOf(map, face)).run();
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
  gl.ClearColor(1, 1, 1, 1);
  gl.CullFace(GL_BACK);
  gl.VertexAttrib4f(UV0, 0, 0, 0, 1);
  gl.VertexAttrib4f(UV1, 0, 0, 0, 1);
  std::size_t index = 0;
  for (const auto* maps : {&plan.shadows.flat, &plan.shadows.cube}) {
    for (const ShadowMap& map : *maps) {
      const Target& target = targets_[index++];
      for (std::size_t face = 0; face < map.views.size(); ++face) {
        if (face < target.planes.size()) {
          gl.BindFramebuffer(GL_FRAMEBUFFER, target.planes[face].get());
          gl.Clear(map.packed ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
        }
        const gl::Pacer::Rectangle place = placeOf(map, face);
        gl.Viewport(place.x, place.y, place.width, place.height);
        drawView(map, face, plan, scene, gpu, cancel);
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
    gl.BindTexture(targets_[i].kind.texture(), targets_[i].texture.get());
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
