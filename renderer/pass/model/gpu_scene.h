#pragma once
#include <compare>
#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "pass/model/gpu_primitive.h"
#include "pass/model/part_extents.h"
#include "pass/texture/texture_store.h"
#include "telar/cancel.h"

namespace telar::pass {

/// What a texture is made into for the shading "fabric" (TextureBaker).
struct DerivedTexture {
  enum class Kind { kNormalVariance, kNormalFacets, kCoverage, kMetal, kYarnRelief } kind = Kind::kNormalVariance;
  int image = -1;
  bool srgb = false;
  float cutoff = 0;  ///< alpha from which on it is there, 0 = as far as its alpha says: kCoverage, and of a cover
  int cover = -1;    ///< kNormalVariance of a material with holes: the image whose alpha tells them; kMetal: whose blue
                     ///< is metalness
  int yarns = -1;    ///< kYarnRelief, and kMetal of a woven material: the image that tells which yarn lies on top
  int first = 0, besideFirst = 0;  ///< largest levels that are left out: of `image`, of `cover` and `yarns`
  int unread = 0;                  ///< largest levels of what is made that no fragment reads: they are not made

  auto operator<=>(const DerivedTexture&) const = default;
};

/// Texels of textures with all their levels.
struct TexelCount {
  std::uint64_t all = 0;
  std::uint64_t unread = 0;       ///< of levels that the GPU lacks, for nothing has read them
  std::uint64_t unreadBytes = 0;  ///< of these

  TexelCount& operator+=(const TexelCount& other) {
    all += other.all;
    unread += other.unread;
    unreadBytes += other.unreadBytes;
    return *this;
  }
};

/// A scene's data on the GPU. It is made when a draw first needs it and freed with the object. A scene that was made of
/// another one owns only what that and its cloths lack: deformed meshes, and textures that are made of images of both.
class GpuScene {
 public:
  /// @param model   of the scene that `scene` was made of, which outlives this; null = it was loaded
  /// @param cloths  of Scene::cloths, in their order
  GpuScene(const gl::Context& context, TextureStore& store, const std::shared_ptr<const Scene>& scene, GpuScene* model,
           std::vector<std::shared_ptr<GpuScene>> cloths = {});
  GpuScene(const GpuScene&) = delete;
  GpuScene& operator=(const GpuScene&) = delete;
  /// The store keeps its textures.
  ~GpuScene();

  /// @param instances null = drawn once
  const GpuPrimitive& primitive(const Primitive& primitive, const Instances* instances);
  /// The primitive with fewer triangles, none of which lies further than `error` off (telar/simplify.h), or itself.
  /// Made once for all errors between two powers of two; FORMS_KEPT of a primitive stay, those that were used last.
  /// @param error  mesh space, above 0
  const Primitive& simplified(const Primitive& primitive, double error, const CancelToken& cancel);
  static constexpr std::size_t FORMS_KEPT = 2;
  /// The extents of its parts.
  const PartExtents& extents(const Primitive& primitive);
  /// The most texels of a longer side that textures are read with from now on; 0 = whole.
  void limitTextures(int size);
  /// How many of an image's largest levels that leaves out.
  int levelsLeftOut(const Scene& scene, int image) const;
  /// Uploads once for each way of decoding, with mip levels (TextureStore): from sRGB or linear, as the image's
  /// coding and the use as a colour or as data say. @throws Error{E_IMAGE_FORMAT}
  /// @param unread  largest levels that the draws to come do not read (TextureStore)
  GLuint texture(const Scene& scene, int image, bool colorUse, const CancelToken& cancel, int unread = 0);
  /// A texture that others are made of: of it level 0 is read, or the one that the limit leaves. Where nothing else
  /// reads the image it has no smaller levels, and goes with dropSources().
  GLuint source(const Scene& scene, int image, bool colorUse, const CancelToken& cancel);
  void dropSources();
  /// Whether the GPU has all levels of an image in each form that it has.
  bool isWhole(int image) const;
  /// Of its textures of images, and of the relief that was made of them.
  TexelCount texels(const Scene& scene) const;
  /// The same for a texture that is made of another one, once for each key; anew where the one that there is lacks
  /// levels that are read now. Those of textures that are not read whole go with the next limit.
  GLuint derived(const DerivedTexture& key, const std::function<gl::Texture()>& make);
  /// TextureBaker::reliefAxis() of a normal map, found once.
  /// @param first  of levelsLeftOut()
  glm::vec2 reliefAxis(int image, int first, const std::function<glm::vec2()>& find);
  /// How many levels what derived() has made of an image lacks, at most: 0 where all is there.
  int unreadOfDerived(int image) const;
  /// GPU bytes of the textures that derived() has made and of those to be made.
  std::uint64_t derivedBytes(const Scene& scene, std::set<DerivedTexture> wanted) const;
  GLuint sampler(const Sampler& sampler);
  bool expired() const { return scene_.expired(); }
  bool isMadeOf(const Scene& model) const;

  /// Frames to come for which VisibleDraws does not look for hidden triangles, for it found few.
  int framesWithoutLook = 0;

 private:
  /// A primitive with fewer triangles.
  struct Form {
    int exponent = 0;                       ///< 2^exponent is the error that it was made with
    std::unique_ptr<const Primitive> made;  ///< null = the primitive itself
  };
  /// Another one that has an image's textures, and the place of its first image here.
  struct Lender {
    GpuScene* scene;
    int first;
    const Scene* cloth;  ///< null = the model
  };
  /// None = the image is this one's own.
  std::optional<Lender> lenderOf(int image) const;
  /// Of all images that a texture is made of; none where they are not one's, or where a cloth would keep a texture for
  /// each garment that cuts it out elsewhere.
  std::optional<Lender> lenderOf(const DerivedTexture& key) const;
  GLuint ownTexture(const Image8& image, int index, bool colorUse, const CancelToken& cancel, int unread);
  GLuint ownSource(const Image8& image, int index, bool colorUse, const CancelToken& cancel);
  /// Frees what the GPU has of a primitive.
  void forget(const Primitive* primitive);

  const gl::Context& context_;
  TextureStore& store_;
  std::weak_ptr<const Scene> scene_;
  GpuScene* model_;
  std::vector<std::pair<std::shared_ptr<GpuScene>, WornCloth>> cloths_;
  std::set<const Primitive*> own_;                       ///< where there is a model: the deformed ones
  int fileImages_;                                       ///< images below are the model's
  std::map<const Primitive*, std::vector<Form>> forms_;  ///< the one that was used last, last
  std::map<const Primitive*, VertexStreams> streams_;
  std::map<const Primitive*, PartExtents> extents_;
  std::map<const Instances*, InstanceStreams> instances_;
  std::map<std::pair<const Primitive*, const Instances*>, GpuPrimitive> primitives_;
  int textureSize_ = 0;                                               ///< limitTextures()
  std::map<std::pair<int, bool>, StoredTexture> textures_, sources_;  ///< by image and whether it is decoded from sRGB
  std::map<DerivedTexture, gl::Texture> derived_;
  std::map<std::pair<int, int>, glm::vec2> reliefAxes_;  ///< by image and its levels that are left out
  std::vector<std::pair<Sampler, gl::Sampler>> samplers_;
};

}  // namespace telar::pass
