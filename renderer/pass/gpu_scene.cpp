#include "pass/gpu_scene.h"

#include <algorithm>
#include <utility>

namespace telar::pass {
namespace {

/// RGBA16F or RGBA8; all mip levels are a third as large as the first.
std::uint64_t bytesOf(DerivedTexture::Kind kind, std::uint64_t texels) {
  using Kind = DerivedTexture::Kind;
  std::uint64_t first = texels * 8;
  if (kind == Kind::kCoverage || kind == Kind::kMetal) first = texels * 4;
  if (kind == Kind::kYarnRelief) first = texels / 2 + 8;  // a sixteenth of the texels
  return first + first / 3;
}
constexpr std::uint64_t MOMENT_BYTES = 5;  ///< a texel of the source, while its first levels are made in RGBA32F

}  // namespace

GpuScene::GpuScene(const gl::Context& context, TextureStore& store, const std::shared_ptr<const Scene>& scene,
                   GpuScene* model)
    : context_(context), store_(store), scene_(scene), model_(model), fileImages_(static_cast<int>(scene->fileImages)) {
  if (!model) return;
  for (std::size_t i = scene->fileMeshes; i < scene->meshes.size(); ++i) {
    for (const Primitive& primitive : scene->meshes[i].primitives) own_.insert(&primitive);
  }
}

GpuScene::~GpuScene() {
  for (auto& entry : textures_) store_.keep(std::move(entry.second));
}

bool GpuScene::isMadeOf(const Scene& model) const {
  const auto scene = scene_.lock();
  return scene && scene->model.get() == &model;
}

const GpuPrimitive& GpuScene::primitive(const Primitive& primitive, const Instances* instances) {
  if (model_ && !own_.contains(&primitive)) return model_->primitive(primitive, instances);
  const auto key = std::make_pair(&primitive, instances);
  const auto found = primitives_.find(key);
  if (found != primitives_.end()) return found->second;
  const gl::Functions& gl = context_.gl();
  const VertexStreams& streams = streams_.try_emplace(&primitive, context_, primitive).first->second;
  const InstanceStreams* places =
      instances ? &instances_.try_emplace(instances, context_, *instances).first->second : nullptr;
  GpuPrimitive made{gl::VertexArray(gl), streams.mode(), streams.count(), streams.indices(), places};
  gl.BindVertexArray(made.vertexArray.get());
  streams.attach(gl);
  if (places) places->attach(gl);
  gl.BindVertexArray(0);
  context_.check("vertex arrays");
  return primitives_.emplace(key, std::move(made)).first->second;
}

const PartExtents& GpuScene::extents(const Primitive& primitive) {
  if (model_ && !own_.contains(&primitive)) return model_->extents(primitive);
  return extents_.try_emplace(&primitive, primitive).first->second;
}

GLuint GpuScene::texture(const Scene& scene, int image, bool colorUse, const CancelToken& cancel, int unread) {
  if (isModels(image)) return model_->texture(scene, image, colorUse, cancel, unread);
  const bool srgb = decodesSrgb(scene.images[static_cast<std::size_t>(image)].coding, colorUse);
  const auto key = std::make_pair(image, srgb);
  const auto found = textures_.find(key);
  if (found != textures_.end() && found->second.firstLevel <= unread) return found->second.texture.get();
  cancel.check();
  StoredTexture stored = store_.upload(scene.images[static_cast<std::size_t>(image)], srgb, unread);
  if (found != textures_.end()) {
    std::swap(found->second, stored);
    store_.keep(std::move(stored));
    return found->second.texture.get();
  }
  return textures_.emplace(key, std::move(stored)).first->second.texture.get();
}

bool GpuScene::isWhole(int image) const {
  if (isModels(image)) return model_->isWhole(image);
  bool is = false;
  for (const bool srgb : {false, true}) {
    const auto found = textures_.find({image, srgb});
    if (found == textures_.end()) continue;
    if (found->second.firstLevel > 0) return false;
    is = true;
  }
  return is;
}

TexelCount GpuScene::texels() const {
  TexelCount texels = model_ ? model_->texels() : TexelCount();
  for (const auto& [key, stored] : textures_) {
    const TextureStorage& has = stored.storage;
    const auto largest = static_cast<std::uint64_t>(has.width) * static_cast<unsigned>(has.height);
    std::uint64_t unread = 0, read = 0;
    for (int level = 1; level <= stored.firstLevel; ++level) unread += largest << (2 * level);
    for (int level = 0; level < has.levels; ++level)
      read += static_cast<std::uint64_t>(std::max(has.width >> level, 1)) *
              static_cast<unsigned>(std::max(has.height >> level, 1));
    texels.all += read + unread;
    texels.unread += unread;
  }
  return texels;
}

GLuint GpuScene::derived(const DerivedTexture& key, const std::function<gl::Texture()>& make) {
  if (isModels(key.image) && isModels(key.cover) && isModels(key.yarns)) return model_->derived(key, make);
  const auto found = derived_.find(key);
  if (found != derived_.end()) return found->second.get();
  return derived_.emplace(key, make()).first->second.get();
}

std::uint64_t GpuScene::derivedBytes(const Scene& scene, std::set<DerivedTexture> wanted) const {
  std::uint64_t bytes = 0, largest = 0;
  for (const GpuScene* of = this; of; of = of->model_) {
    for (const auto& made : of->derived_) wanted.insert(made.first);
  }
  for (const DerivedTexture& key : wanted) {
    const Image8& image = scene.images[static_cast<std::size_t>(key.image)];
    const std::uint64_t texels = std::uint64_t{image.width} * image.height;
    bytes += bytesOf(key.kind, texels);
    largest = std::max(largest, texels);
  }
  return bytes + largest * MOMENT_BYTES;
}

GLuint GpuScene::sampler(const Sampler& wanted) {
  if (model_) return model_->sampler(wanted);
  for (const auto& [sampler, object] : samplers_) {
    if (sampler == wanted) return object.get();
  }
  const gl::Functions& gl = context_.gl();
  gl::Sampler object(gl);
  gl.SamplerParameteri(object.get(), GL_TEXTURE_WRAP_S, static_cast<GLint>(wanted.wrapS));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_WRAP_T, static_cast<GLint>(wanted.wrapT));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(wanted.magFilter));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(wanted.minFilter));
  samplers_.emplace_back(wanted, std::move(object));
  return samplers_.back().second.get();
}

}  // namespace telar::pass
