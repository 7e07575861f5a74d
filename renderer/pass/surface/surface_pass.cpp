#include "pass/surface/surface_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "brdf/release_factors.h"
#include "frame/sample_passes.h"
#include "ibl/dfg.h"
#include "pass/plan/world_origin.h"
#include "pass/shadow/shadow_pass.h"
#include "pass/surface/environment_uniforms.h"
#include "pass/surface/surface_programs.h"
#include "pass/visible/sliced_draw.h"

namespace telar::pass {
namespace {

// The material's textures come first, in the order of TEXTURE_SLOTS.
constexpr GLuint DFG_UNIT = TEXTURE_SLOTS.size();
constexpr GLuint ENVIRONMENT_UNIT = DFG_UNIT + 1;
constexpr GLuint IRRADIANCE_UNIT = ENVIRONMENT_UNIT + 1;
constexpr GLuint LTC_INVERSE_UNIT = IRRADIANCE_UNIT + 1;
constexpr GLuint LTC_ALBEDO_UNIT = LTC_INVERSE_UNIT + 1;
constexpr GLuint TRANSMISSION_UNIT = LTC_ALBEDO_UNIT + 1;
constexpr GLuint METAL_UNIT = TRANSMISSION_UNIT + 1;
constexpr GLuint YARN_RELIEF_UNIT = METAL_UNIT + 1;
constexpr GLuint VARYING_UNIT = YARN_RELIEF_UNIT + 1;
constexpr GLuint UNIT_COUNT = VARYING_UNIT + 1;

/// Half floats: 8 bits cannot hold the 0.5 of a flat normal.
gl::Texture texelTexture(const gl::Functions& gl, const std::array<float, 4>& rgba) {
  gl::Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, 1, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, rgba.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return texture;
}

/// Inverse transpose; for a flattened node its cofactors, which point the same way and need no division.
glm::mat3 normalMatrixOf(const glm::dmat3& m) {
  if (glm::determinant(m) != 0) return glm::mat3(glm::inverseTranspose(m));
  return glm::mat3(glm::dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])));
}

/// Without vertex tangents the frame follows the texture's rows downwards: y turns round, as in three.js's loader,
/// which does so twice for instances. On back faces that are drawn as front faces both turn round, as in its renderer.
glm::vec2 normalScaleOf(float scale, const DrawItem& item) {
  const glm::vec2 signs(1, hasTangents(*item.primitive, *item.material) || item.instances() ? 1 : -1);
  return signs * (item.key.flipSided ? -scale : scale);
}

/// Sizes of a texture after which its texels come again along u and v; 0 where the last ones go on.
glm::vec2 periodOf(const Sampler& sampler) {
  const auto along = [](std::uint32_t wrap) {
    return wrap == Sampler::REPEAT ? 1.0f : wrap == Sampler::MIRRORED_REPEAT ? 2.0f : 0.0f;
  };
  return {along(sampler.wrapS), along(sampler.wrapT)};
}

/// Lengths of the matrix's axes.
glm::vec3 scaleOf(const glm::mat4& m) {
  return {glm::length(glm::vec3(m[0])), glm::length(glm::vec3(m[1])), glm::length(glm::vec3(m[2]))};
}

/// Factors of the layers that the program has.
void setLayers(const gl::Program& program, const DrawItem& item) {
  const shader::VariantKey& key = item.key;
  {
    const PhysicalLayers& l = item.material->layers;
#include "pass/physical_uniforms.inc"
  }
  const FabricLayers& l = item.material->fabric;
#include "pass/fabric_uniforms.inc"
}

bool readsTransmission(const std::vector<DrawItem>* list) {
  return std::any_of(list->begin(), list->end(), [](const DrawItem& item) { return item.key.transmission; });
}

/// What a draw of cut-out cloth shows: of shaders/material/coverage.glsl.
constexpr int COVERAGE_MASKED = 0, COVERAGE_WHOLE = 1, COVERAGE_BLENDED = 2, COVERAGE_SHARES = 3;

}  // namespace

EnvironmentForms environmentForms(const FramePlan& plan, const Shot& shot) {
  const bool sampled = plan.frame.environmentSamples > 0;
  const double turned = ibl::turnOfTexels(plan.frame.three, shot.environment.rotation);
  EnvironmentForms forms{{.three = plan.frame.three, .turned = turned}, {}};
  if (!ibl::hasAtlas(plan.frame.three)) forms.lit.settings = {shot.environmentSize, shot.prefilterSamples};
  ibl::EnvironmentUses seen = forms.lit;
  seen.prefiltered = plan.environmentBackground && shot.background.blur > 0;
  seen.background = plan.environmentBackground && shot.background.blur <= 0;
  forms.lit.prefiltered = forms.lit.suns = plan.environment && !sampled;
  forms.lit.radiance = plan.environment && sampled;
  const bool studio = shot.environment.source == Shot::Environment::Source::kStudio;  // it has no small lights
  forms.lit.smallSuns = forms.lit.suns && !studio && shot.shading == ShadingModel::kFabric;
  if (forms.lit.smallSuns && plan.environmentBackground) {
    forms.seen = seen;
  } else {
    forms.lit.prefiltered = forms.lit.prefiltered || seen.prefiltered;
    forms.lit.background = seen.background;
  }
  return forms;
}

SurfacePass::SurfacePass(const gl::Context& context, Limits limits)
    : context_(context), limits_(limits), dfg_(ibl::createDfgTexture(context.gl())), textures_(context, limits) {}

GLuint SurfacePass::firstShadowUnit() { return UNIT_COUNT; }

int SurfacePass::prepare(const FramePlan& plan, const CancelToken& cancel) {
  std::set<shader::VariantKey> wanted = plan.keys();
  for (const shader::VariantKey& key : plan.keys()) {
    if (key.visibilityBuffer) wanted.insert(capturedKey(key));
  }
  checkLimit("L_PROGRAMS", static_cast<double>(limits_.programs), static_cast<double>(wanted.size()));
  int compiled = 0;
  for (const shader::VariantKey& key : wanted) {
    if (programs_.contains(key)) continue;
    cancel.check();
    gl::Program program = programOf(context_, key);
    programs_.emplace(key, Surface{std::move(program), gl::DrawCost(weightOf(key))});
    ++compiled;
  }
  return compiled;
}

void SurfacePass::upload(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  textures_.checkMemory(plan, scene, gpu);
  for (const auto* list : plan.draws.shown()) {
    for (const DrawItem& item : *list) {
      cancel.check();
      gpu.primitive(*item.primitive, item.instances());
    }
  }
}

const SurfacePass::StandIns& SurfacePass::standIns() {
  if (!standIns_) {
    const gl::Functions& gl = context_.gl();
    standIns_ = StandIns{texelTexture(gl, {1, 1, 1, 1}), texelTexture(gl, {0.5f, 0.5f, 1, 1}),
                         std::move(ibl::createCube(gl, 1, 1).texture)};
  }
  return *standIns_;
}

SurfacePass::Surface& SurfacePass::useProgram(const shader::VariantKey& key, const SurfaceInputs& in) {
  Surface& surface = programs_.at(key);
  if (&surface == current_) return surface;
  current_ = &surface;
  const gl::Program& program = surface.program;
  program.use();
  program.set("projectionMatrix", glm::mat4(in.plan.camera.projection));
  program.set("exposure", static_cast<float>(in.shot.exposure));
  if (key.alphaToCoverage) program.set("coverageSamples", in.samples);
  if (key.ownPlaces) {
    const frame::SamplePasses passes = frame::samplePassesOf(in.shot);
    program.set("samplePass", in.samplePass);
    program.set("cellsAcross", passes.cellsAcross());
    program.set("cell", glm::vec2(passes.cell(in.samplePass)));
    program.set("shiftInCell", glm::vec2(passes.shiftInCell(in.samplePass)));
  }
  if (key.debugOutput) program.set("debugOutput", static_cast<int>(in.shot.debugOutput));
  if (key.layers) program.set("viewToWorld", glm::mat3(glm::transpose(glm::dmat3(in.plan.camera.view))));
  if (key.unlit) return surface;
  in.plan.lights.upload(program);
  program.set("ltcInverseMap", static_cast<int>(LTC_INVERSE_UNIT));
  program.set("ltcAlbedoMap", static_cast<int>(LTC_ALBEDO_UNIT));
  program.set("dfgMap", static_cast<int>(DFG_UNIT));
  if (key.environment) {
    setEnvironment(program, key, in, {ENVIRONMENT_UNIT, IRRADIANCE_UNIT});
  }
  if (key.transmission || key.lights.shadows() > 0)
    program.set("viewMatrix", glm::mat4(toOrigin(in.plan.camera.view, in.plan.origin)));
  if (key.transmission) {
    program.set("transmissionTarget", static_cast<int>(TRANSMISSION_UNIT));
    program.set("cameraPosition", glm::vec3(glm::dvec3(glm::inverse(in.plan.camera.view)[3]) - in.plan.origin));
  }
  if (key.lights.shadows() > 0) {
    const auto flat = static_cast<std::size_t>(key.lights.spotShadows + key.lights.directionalShadows);
    uploadShadows(program, in.plan.shadows, flat, key.lights.pointShadows, UNIT_COUNT);
  }
  return surface;
}

void SurfacePass::bindMaterial(const gl::Program& program, const DrawItem& item, const SurfaceInputs& in) {
  const gl::Functions& gl = context_.gl();
  const Material& m = *item.material;
  for (GLuint unit = 0; unit < TEXTURE_SLOTS.size(); ++unit) {
    const TextureSlot& slot = TEXTURE_SLOTS[unit];
    if (!(item.key.*slot.map)) continue;
    const TextureRef& texture = slot.texture(m);
    program.set(slot.sampler, static_cast<int>(unit));
    program.set(slot.uvTransform, texture.uvTransform);
    if (in.captures) continue;
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    if (texture) {
      gl.BindTexture(GL_TEXTURE_2D, textures_.texture(item, slot, in.scene, in.gpu, in.cancel, in.unread));
      gl.BindSampler(unit, in.gpu.sampler(texture.sampler));
    } else {
      const bool normal = slot.map == &shader::VariantKey::normalMap;
      gl.BindTexture(GL_TEXTURE_2D, (normal ? standIns().flatNormal : standIns().white).get());
      gl.BindSampler(unit, 0);
    }
  }
  if (in.captures) return;  // the rest is the fragments'
  if (item.key.metalMeans) {
    program.set("metalMap", static_cast<int>(METAL_UNIT));
    gl.ActiveTexture(GL_TEXTURE0 + METAL_UNIT);
    gl.BindTexture(GL_TEXTURE_2D, textures_.metal(item, in.scene, in.gpu, in.cancel, in.unread));
    gl.BindSampler(METAL_UNIT, in.gpu.sampler(m.baseColorTexture.sampler));
  }
  if (item.key.yarnRelief) {
    program.set("yarnReliefMap", static_cast<int>(YARN_RELIEF_UNIT));
    gl.ActiveTexture(GL_TEXTURE0 + YARN_RELIEF_UNIT);
    gl.BindTexture(GL_TEXTURE_2D, textures_.yarnRelief(item, in.scene, in.gpu, in.cancel));
    gl.BindSampler(YARN_RELIEF_UNIT, in.gpu.sampler(m.normalTexture.sampler));
  }
  program.set("baseColorFactor", m.baseColorFactor);
  program.set("alphaCutoff", m.alphaMode == AlphaMode::kMask ? m.alphaCutoff : 0.0f);
  if (item.key.unlit) return;
  program.set("metallicFactor", m.metallicFactor);
  program.set("roughnessFactor", m.roughnessFactor);
  program.set("emissiveFactor", m.emissiveFactor);
  program.set("occlusionStrength", m.occlusionStrength);
  program.set("normalScale", normalScaleOf(m.normalScale, item));
  if (item.hasReliefAxis()) program.set("reliefAxis", textures_.reliefAxis(item, in.scene, in.gpu, in.cancel));
  if (item.key.normalFacets) program.set("normalMapPeriod", periodOf(m.normalTexture.sampler));
  setLayers(program, item);
  const ThreeTerms& three = item.key.three;
  if (three.ior0 && (item.key.specular || item.key.transmission)) program.set("ior", iorOf(m.layers, three));
  if (three.sheenAlbedo && item.key.sheen) program.set("sheenRoughnessFactor", sheenRoughnessOf(m.layers, three));
  if (item.key.transmission) {
    program.set("modelMatrix", glm::mat4(fromOrigin(item.node->world, in.plan.origin)));
    program.set("thicknessScale", scaleOf(glm::mat4(item.node->world)));
  }
}

void SurfacePass::drawItem(const DrawItem& item, const SurfaceInputs& in) {
  const gl::Functions& gl = context_.gl();
  Surface& surface = useProgram(in.captures ? capturedKey(item.key) : item.key, in);
  const gl::Program& program = surface.program;
  const glm::dmat4 modelView = in.plan.camera.view * item.node->world;
  program.set("modelViewMatrix", glm::mat4(modelView));
  program.set("normalMatrix", normalMatrixOf(glm::dmat3(modelView)));
  if (item.key.lights.shadows() > 0)
    program.set("modelMatrix", glm::mat4(fromOrigin(item.node->world, in.plan.origin)));
  if (in.ids) program.set("layerIds", glm::vec2(in.ids->part(*item.node), in.ids->material(item.materialIndex)));
  bindMaterial(program, item, in);

  const auto blends = [&gl](bool yes) {
    yes ? gl.Enable(GL_BLEND) : gl.Disable(GL_BLEND);
    gl.DepthMask(yes ? GL_FALSE : GL_TRUE);
  };
  blends(item.blend);
  if (in.captures) return in.buffer->capture(item, in.gpu);
  if (item.key.visibilityBuffer) {
    gl.Disable(GL_CULL_FACE);
    in.buffer->draw(item, program, surface.cost, VARYING_UNIT);
    return;
  }
  const bool cull = !item.bothSides && item.primitive->topology == Topology::kTriangles;
  cull ? gl.Enable(GL_CULL_FACE) : gl.Disable(GL_CULL_FACE);
  gl.FrontFace(item.mirrored != item.key.flipSided ? GL_CW : GL_CCW);
  const frame::Camera& camera = in.plan.camera;
  const auto draw = [&] {
    SlicedDraw(context_, surface.cost, item, in.gpu, camera.projection * camera.view,
               {0, 0, in.shot.width, in.shot.height}, in.visible)
        .run();
  };
  if (item.key.alphaToCoverage) program.set("coverageDraw", item.blendsCoverage ? COVERAGE_WHOLE : COVERAGE_MASKED);
  if (!item.isPartial) draw();
  if (!item.blendsCoverage) return;
  program.set("coverageDraw", item.isPartial ? COVERAGE_SHARES : COVERAGE_BLENDED);
  blends(true);
  if (!item.bothSides || item.farToNear) return draw();
  // What faces away first, as three.js does: but for folds it lies behind.
  gl.Enable(GL_CULL_FACE);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    gl.CullFace(hidden);
    draw();
  }
}

void SurfacePass::bindShared(const SurfaceInputs& in, bool transmission) {
  const gl::Functions& gl = context_.gl();
  // Before the others, and not over a shadow map: making a texture binds it.
  gl.ActiveTexture(GL_TEXTURE0);
  if ((in.plan.environment && !in.environment) || (transmission && !in.transmission)) standIns();
  if (in.plan.frame.lights.area() > 0 && !ltc_) ltc_ = createLtcTextures(context_);
  const bool dfg32 = in.plan.frame.three.dfg == ThreeTerms::THREE_DFG_TABLE_32;
  if (dfg32 && !dfg32_) dfg32_ = ibl::createDfgTexture(gl, in.plan.frame.three);
  const auto bind = [&gl](GLuint unit, GLenum target, const gl::Texture& texture) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(target, texture.get());
  };
  bind(DFG_UNIT, GL_TEXTURE_2D, dfg32 ? dfg32_ : dfg_);
  if (in.plan.environment) {
    const bool sampled = in.plan.frame.environmentSamples > 0;
    if (!sampled && !ibl::hasAtlas(in.plan.frame.three)) {
      bind(ENVIRONMENT_UNIT, GL_TEXTURE_CUBE_MAP,
           in.environment ? in.environment->prefiltered.texture : standIns().blackCube);
    } else {
      bind(ENVIRONMENT_UNIT, GL_TEXTURE_2D,
           !in.environment ? standIns().white
           : sampled       ? in.environment->radiance.texture
                           : in.environment->atlas.texture);
    }
    if (sampled)
      bind(IRRADIANCE_UNIT, GL_TEXTURE_2D, in.environment ? in.environment->irradiance.texture : standIns().white);
  }
  if (in.plan.frame.lights.area() > 0) {
    bind(LTC_INVERSE_UNIT, GL_TEXTURE_2D, ltc_.inverse);
    bind(LTC_ALBEDO_UNIT, GL_TEXTURE_2D, ltc_.albedo);
  }
  if (transmission) {
    gl.ActiveTexture(GL_TEXTURE0 + TRANSMISSION_UNIT);
    gl.BindTexture(GL_TEXTURE_2D, in.transmission ? in.transmission->texture() : standIns().white.get());
  }
}

void SurfacePass::draw(std::initializer_list<const std::vector<DrawItem>*> lists, const SurfaceInputs& in) {
  const gl::Functions& gl = context_.gl();
  current_ = nullptr;
  bindShared(in, std::any_of(lists.begin(), lists.end(), readsTransmission));
  gl.VertexAttrib4f(UV0, 0, 0, 0, 1);
  gl.VertexAttrib4f(UV1, 0, 0, 0, 1);
  gl.VertexAttrib4f(COLOR, 1, 1, 1, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.CullFace(GL_BACK);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const std::vector<DrawItem>* list : lists) {
    for (const DrawItem& item : *list) {
      in.cancel.check();
      if (item.visible) drawItem(item, in);
    }
  }
  gl.DepthMask(GL_TRUE);
  gl.BindVertexArray(0);
  for (GLuint unit = 0; unit < UNIT_COUNT; ++unit) gl.BindSampler(unit, 0);
  context_.check("surface pass");
}

}  // namespace telar::pass
