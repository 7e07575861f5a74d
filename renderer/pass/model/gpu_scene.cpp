#include "pass/model/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "telar/simplify.h"

namespace telar::pass {
namespace {

constexpr std::uint64_t IMAGE_BYTES = 4, RELIEF_BYTES = 8;  ///< a texel: RGBA8, RGBA16F

/// All mip levels are a third as large as the first.
std::uint64_t bytesOf(DerivedTexture::Kind kind, std::uint64_t texels) {
  using Kind = DerivedTexture::Kind;
  std::uint64_t first = texels * RELIEF_BYTES;
  if (kind == Kind::kCoverage || kind == Kind::kMetal) first = texels * IMAGE_BYTES;
  if (kind == Kind::kYarnRelief) first = texels / 2 + 8;  // a sixteenth of the texels
  return first + first / 3;
}
/// Of what is made of an image, with all mip levels.
TexelCount texelsOf(const Scene& scene, const DerivedTexture& key) {
  const Image8& image = scene.images[static_cast<std::size_t>(key.image)];
  TexelCount texels;
  for (int level = 0; std::max(image.width, image.height) >> (key.first + level) > 0; ++level) {
    const int shift = key.first + level;
    const std::uint64_t own = std::uint64_t{std::max(image.width >> shift, 1u)} * std::max(image.height >> shift, 1u);
    texels.all += own;
    if (level < key.unread) texels.unread += own;
  }
  return texels;
}

/// The key by places that lie so far behind.
DerivedTexture moved(DerivedTexture key, int by) {
  for (int* image : {&key.image, &key.cover, &key.yarns}) {
    if (*image >= 0) *image += by;
  }
  return key;
}

constexpr std::uint64_t MOMENT_BYTES = 5;  ///< a texel of the source, while its first levels are made in RGBA32F

}  // namespace

GpuScene::GpuScene(const gl::Context& context, TextureStore& store, const std::shared_ptr<const Scene>& scene,
                   GpuScene* model, std::vector<std::shared_ptr<GpuScene>> cloths)
    : context_(context), store_(store), scene_(scene), model_(model), fileImages_(static_cast<int>(scene->fileImages)) {
  for (std::size_t i = 0; i < cloths.size(); ++i) cloths_.emplace_back(std::move(cloths[i]), scene->cloths[i]);
  if (!model) return;
  for (std::size_t i = scene->fileMeshes; i < scene->meshes.size(); ++i) {
    for (const Primitive& primitive : scene->meshes[i].primitives) own_.insert(&primitive);
  }
}

GpuScene::~GpuScene() {
  for (auto& entry : textures_) store_.keep(std::move(entry.second));
  for (auto& entry : sources_) store_.keep(std::move(entry.second));
}

std::optional<GpuScene::Lender> GpuScene::lenderOf(int image) const {
  if (model_ && image < fileImages_) return Lender{model_, 0, nullptr};
  for (const auto& [gpu, cloth] : cloths_) {
    const int first = static_cast<int>(cloth.firstImage);
    if (image >= first && image < first + static_cast<int>(cloth.scene->images.size()))
      return Lender{gpu.get(), first, cloth.scene.get()};
  }
  return std::nullopt;
}

std::optional<GpuScene::Lender> GpuScene::lenderOf(const DerivedTexture& key) const {
  const auto lender = lenderOf(key.image);
  if (!lender) return std::nullopt;
  for (const int image : {key.cover, key.yarns}) {
    if (image < 0) continue;
    const auto other = lenderOf(image);
    if (!other || other->scene != lender->scene) return std::nullopt;
  }
  if (lender->cloth && key.cutoff != 0) {
    const auto isOwn = [&key](const Material& material) { return textureCutoff(material) == key.cutoff; };
    if (std::ranges::none_of(lender->cloth->materials, isOwn)) return std::nullopt;
  }
  return lender;
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

void GpuScene::forget(const Primitive* primitive) {
  std::erase_if(primitives_, [&](const auto& entry) { return entry.first.first == primitive; });
  streams_.erase(primitive);
  extents_.erase(primitive);
}

const Primitive& GpuScene::simplified(const Primitive& primitive, double error, const CancelToken& cancel) {
  if (model_ && !own_.contains(&primitive)) return model_->simplified(primitive, error, cancel);
  if (!(error > 0) || std::isinf(error)) return primitive;
  const int exponent = std::ilogb(error);
  std::vector<Form>& forms = forms_[&primitive];
  const auto found =
      std::find_if(forms.begin(), forms.end(), [&](const Form& form) { return form.exponent == exponent; });
  if (found != forms.end()) {
    std::rotate(found, found + 1, forms.end());
  } else {
    cancel.check();
    auto made = telar::simplified(primitive, std::ldexp(1.0, exponent));
    if (forms.size() >= FORMS_KEPT) {
      forget(forms.front().made.get());
      forms.erase(forms.begin());
    }
    forms.push_back({exponent, made ? std::make_unique<const Primitive>(std::move(*made)) : nullptr});
  }
  return forms.back().made ? *forms.back().made : primitive;
}

const PartExtents& GpuScene::extents(const Primitive& primitive) {
  if (model_ && !own_.contains(&primitive)) return model_->extents(primitive);
  return extents_.try_emplace(&primitive, primitive).first->second;
}

void GpuScene::limitTextures(int size) {
  if (model_) model_->limitTextures(size);
  for (const auto& [gpu, cloth] : cloths_) gpu->limitTextures(size);
  if (size == textureSize_) return;
  textureSize_ = size;
  std::erase_if(derived_, [](const auto& made) { return made.first.first > 0 || made.first.besideFirst > 0; });
}

int GpuScene::levelsLeftOut(const Scene& scene, int image) const {
  return image < 0 ? 0 : levelsBeyond(scene.images[static_cast<std::size_t>(image)], textureSize_);
}

GLuint GpuScene::texture(const Scene& scene, int image, bool colorUse, const CancelToken& cancel, int unread) {
  waitForImages(scene, cancel);
  const Image8& texels = scene.images[static_cast<std::size_t>(image)];
  if (const auto lender = lenderOf(image))
    return lender->scene->ownTexture(texels, image - lender->first, colorUse, cancel, unread);
  return ownTexture(texels, image, colorUse, cancel, unread);
}

GLuint GpuScene::ownTexture(const Image8& image, int index, bool colorUse, const CancelToken& cancel, int unread) {
  const bool srgb = decodesSrgb(image.coding, colorUse);
  const auto key = std::make_pair(index, srgb);
  const int leftOut = levelsBeyond(image, textureSize_);
  auto found = textures_.find(key);
  if (found == textures_.end() || found->second.firstLevel > std::max(unread, leftOut)) {
    cancel.check();
    StoredTexture stored = store_.upload(image, srgb, std::max(unread, leftOut));
    if (found == textures_.end()) {
      found = textures_.emplace(key, std::move(stored)).first;
    } else {
      std::swap(found->second, stored);
      store_.keep(std::move(stored));
    }
  }
  store_.readFrom(found->second, leftOut);
  return found->second.texture.get();
}

GLuint GpuScene::source(const Scene& scene, int image, bool colorUse, const CancelToken& cancel) {
  waitForImages(scene, cancel);
  const Image8& texels = scene.images[static_cast<std::size_t>(image)];
  if (const auto lender = lenderOf(image))
    return lender->scene->ownSource(texels, image - lender->first, colorUse, cancel);
  return ownSource(texels, image, colorUse, cancel);
}

GLuint GpuScene::ownSource(const Image8& image, int index, bool colorUse, const CancelToken& cancel) {
  const auto key = std::make_pair(index, decodesSrgb(image.coding, colorUse));
  const auto whole = textures_.find(key);
  if (levelsBeyond(image, textureSize_) > 0 || (whole != textures_.end() && whole->second.firstLevel == 0))
    return ownTexture(image, index, colorUse, cancel, 0);
  auto found = sources_.find(key);
  if (found == sources_.end()) {
    cancel.check();
    found = sources_.emplace(key, store_.uploadLargest(image, key.second)).first;
  }
  return found->second.texture.get();
}

void GpuScene::dropSources() {
  for (auto& entry : sources_) store_.keep(std::move(entry.second));
  sources_.clear();
  if (model_) model_->dropSources();
  for (const auto& [gpu, cloth] : cloths_) gpu->dropSources();
}

bool GpuScene::isWhole(int image) const {
  if (const auto lender = lenderOf(image)) return lender->scene->isWhole(image - lender->first);
  bool is = false;
  for (const bool srgb : {false, true}) {
    const auto found = textures_.find({image, srgb});
    if (found == textures_.end()) continue;
    if (found->second.firstLevel > 0) return false;
    is = true;
  }
  return is;
}

TexelCount GpuScene::texels(const Scene& scene) const {
  TexelCount texels = model_ ? model_->texels(scene) : TexelCount();
  for (const auto& [gpu, cloth] : cloths_) texels += gpu->texels(*cloth.scene);
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
    texels.unreadBytes += unread * IMAGE_BYTES;
  }
  for (const auto& [key, made] : derived_) {
    if (key.kind != DerivedTexture::Kind::kNormalVariance) continue;
    const TexelCount own = texelsOf(scene, key);
    texels.all += own.all;
    texels.unread += own.unread;
    texels.unreadBytes += own.unread * RELIEF_BYTES;
  }
  return texels;
}

GLuint GpuScene::derived(const DerivedTexture& key, const std::function<gl::Texture()>& make) {
  if (const auto lender = lenderOf(key)) return lender->scene->derived(moved(key, -lender->first), make);
  DerivedTexture of = key;
  of.unread = 0;
  // All that differ from it in what they lack alone follow each other.
  for (auto at = derived_.lower_bound(of); at != derived_.end(); at = derived_.erase(at)) {
    of.unread = at->first.unread;
    if (at->first != of) break;
    if (of.unread <= key.unread) return at->second.get();
  }
  return derived_.emplace(key, make()).first->second.get();
}

glm::vec2 GpuScene::reliefAxis(int image, int first, const std::function<glm::vec2()>& find) {
  if (const auto lender = lenderOf(image)) return lender->scene->reliefAxis(image - lender->first, first, find);
  const auto known = reliefAxes_.find({image, first});
  return known != reliefAxes_.end() ? known->second
                                    : reliefAxes_.emplace(std::pair(image, first), find()).first->second;
}

int GpuScene::unreadOfDerived(int image) const {
  if (const auto lender = lenderOf(image)) return lender->scene->unreadOfDerived(image - lender->first);
  int unread = 0;
  bool is = false;
  for (const auto& [key, made] : derived_) {
    if (key.image != image) continue;
    unread = std::max(unread, key.unread);
    is = true;
  }
  return is ? unread : std::numeric_limits<int>::max();
}

std::uint64_t GpuScene::derivedBytes(const Scene& scene, std::set<DerivedTexture> wanted) const {
  std::uint64_t bytes = 0, largest = 0;
  const auto addMade = [&wanted](const GpuScene& of, int first) {
    for (const auto& [key, made] : of.derived_) {
      // As large as it may become.
      DerivedTexture whole = moved(key, first);
      whole.unread = 0;
      wanted.insert(whole);
    }
  };
  addMade(*this, 0);
  if (model_) addMade(*model_, 0);
  for (const auto& [gpu, cloth] : cloths_) addMade(*gpu, static_cast<int>(cloth.firstImage));
  for (const DerivedTexture& key : wanted) {
    const Image8& image = scene.images[static_cast<std::size_t>(key.image)];
    const std::uint64_t texels =
        std::uint64_t{std::max(image.width >> key.first, 1u)} * std::max(image.height >> key.first, 1u);
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
