#include "pass/layer/layer_pass.h"

#include <algorithm>
#include <string>

#include "frame/layers.h"
#include "gl/incomplete.h"
#include "gl/nearest_texture.h"
#include "pass/layer/ambient_layer.h"

namespace telar::pass {
namespace {

std::string sizeOf(const Shot& shot) { return std::to_string(shot.width) + " x " + std::to_string(shot.height); }

void attach(const gl::Functions& gl, std::size_t index, const gl::Texture& texture) {
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index), GL_TEXTURE_2D,
                          texture.get(), 0);
}

void clear(const gl::Functions& gl, GLbitfield what) {
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.DepthMask(GL_TRUE);
  gl.ClearColor(0, 0, 0, 0);
  gl.ClearDepthf(1.0f);
  gl.Clear(what);
}

/// What the pass has drawn, row 0 on top.
struct Texels {
  std::vector<glm::vec4> place, color, number, ground;
  std::vector<float> open;  ///< ambient occlusion
};

/// What one pixel shows.
struct SeenTexel {
  const Texels& texels;
  std::size_t i;
  float groundOpacity;

  bool isSurface() const { return texels.number[i].x > 0; }
  float depth() const { return texels.place[i].w; }
  glm::vec3 normal() const { return glm::vec3(texels.place[i]); }
  float partId() const { return texels.number[i].x; }
  float materialId() const { return texels.number[i].y; }
  float open() const { return texels.open[i]; }
  glm::vec3 albedo() const { return glm::vec3(texels.color[i]); }
  float shadow() const {
    if (isSurface() || texels.ground.empty()) return texels.color[i].a;
    return groundOpacity > 0 ? std::min(texels.ground[i].a / groundOpacity, 1.0f) : 0.0f;
  }
};

/// Row 0 on top.
std::vector<glm::vec4> readTexels(const gl::Context& context, const gl::Texture& texture, int width, int height) {
  const gl::Functions& gl = context.gl();
  const gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  attach(gl, 0, texture);
  const auto row = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  std::vector<glm::vec4> texels(row * rows);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
  context.check("readback of layers");
  for (std::size_t y = 0; y < rows / 2; ++y)
    std::swap_ranges(&texels[y * row], &texels[y * row] + row, &texels[(rows - 1 - y) * row]);
  return texels;
}

}  // namespace

LayerPass::Target LayerPass::makeTarget(const Shot& shot) const {
  const gl::Functions& gl = context_.gl();
  Target target{gl::Framebuffer(gl), {}, gl::Renderbuffer(gl)};
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
  std::array<GLenum, TEXTURES> buffers{};
  for (std::size_t i = 0; i < TEXTURES; ++i) {
    gl.ActiveTexture(GL_TEXTURE0);
    target.textures[i] = gl::nearestTexture(gl, GL_RGBA32F, shot.width, shot.height);
    attach(gl, i, target.textures[i]);
    buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
  }
  gl.BindRenderbuffer(GL_RENDERBUFFER, target.depth.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH_COMPONENT24, shot.width, shot.height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
  gl.DrawBuffers(TEXTURES, buffers.data());
  context_.check("making layers");
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    gl::failIncomplete(gl, "layers of " + sizeOf(shot) + " pixels");
  return target;
}

std::vector<glm::vec4> LayerPass::groundShadow(const Target& target, const FramePlan& plan,
                                               const LayerInputs& in) const {
  if (!plan.ground || !in.shot.hasLayer(Layer::kShadow)) return {};
  const gl::Functions& gl = context_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  const gl::Texture shadow = gl::nearestTexture(gl, GL_RGBA32F, in.shot.width, in.shot.height);
  const gl::Framebuffer framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  attach(gl, 0, shadow);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth.get());
  clear(gl, GL_COLOR_BUFFER_BIT);
  in.shadows.bind(plan.shadows, SurfacePass::firstShadowUnit());
  in.ground.draw(plan, in.shot, SurfacePass::firstShadowUnit());
  context_.pacer().finish();
  return readTexels(context_, shadow, in.shot.width, in.shot.height);
}

std::vector<LayerImage> LayerPass::draw(const LayerInputs& in) {
  const gl::Functions& gl = context_.gl();
  FramePlan plan = planLayers(in.scene, in.shot, in.limits);
  in.surfaces.upload(plan, in.scene, in.gpu, in.cancel);
  in.surfaces.prepare(plan, in.cancel);
  SurfaceInputs inputs{plan, in.shot, in.scene, in.gpu, nullptr, nullptr, in.cancel};
  in.surfaces.uploadTextures(inputs);
  if (!plan.shadows.empty()) {
    in.shadows.draw(plan, in.scene, in.gpu, in.cancel);
    context_.pacer().finish();
  }
  const Target target = makeTarget(in.shot);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
  gl.Viewport(0, 0, in.shot.width, in.shot.height);
  clear(gl, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  in.shadows.bind(plan.shadows, SurfacePass::firstShadowUnit());
  const frame::LayerIds ids(in.scene);
  inputs.ids = &ids;
  in.surfaces.draw({&plan.draws.opaque, &plan.draws.blended}, inputs);
  context_.pacer().finish();

  const auto read = [&](const gl::Texture& texture) {
    return readTexels(context_, texture, in.shot.width, in.shot.height);
  };
  Texels texels{read(target.textures[0]), read(target.textures[1]), read(target.textures[2]), {}, {}};
  texels.ground = groundShadow(target, plan, in);
  if (in.shot.hasLayer(Layer::kAo))
    texels.open = ambientLayer({texels.place, texels.number, in.shot.width, in.shot.height}, plan.camera, in.scene,
                               in.shot, in.cancel);
  const float opacity = in.shot.ground ? static_cast<float>(in.shot.ground->opacity) : 0.0f;
  std::vector<LayerImage> images;
  for (const Layer layer : in.shot.layers) {
    if (layer == Layer::kCoverage || layer == Layer::kLine) continue;
    const std::size_t count = texels.place.size(), channels = channelCount(layer);
    LayerImage& image = images.emplace_back(LayerImage{layer, std::vector<float>(count * channels)});
    for (std::size_t i = 0; i < count; ++i)
      frame::writeLayer(layer, SeenTexel{texels, i, opacity}, &image.pixels[i * channels]);
  }
  return images;
}

}  // namespace telar::pass
