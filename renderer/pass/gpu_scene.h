#pragma once
#include <map>
#include <memory>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar::pass {

// Attribute locations of shaders/material/vertex_inputs.glsl.
enum VertexLocation : GLuint { POSITION = 0, NORMAL = 1, TANGENT = 2, UV0 = 3, UV1 = 4, COLOR = 5 };

/// One primitive's streams on the GPU.
struct GpuPrimitive {
  gl::VertexArray vertexArray;
  gl::Buffer vertices;
  gl::Buffer indices;
  GLenum mode = GL_TRIANGLES;
  GLsizei count = 0;  ///< indices, or vertices where there are none
  bool indexed = false;
};

/// A scene's data on the GPU, made when a draw first needs it, freed with the object.
class GpuScene {
 public:
  GpuScene(const gl::Context& context, std::weak_ptr<const Scene> scene)
      : context_(context), scene_(std::move(scene)) {}

  const GpuPrimitive& primitive(const Primitive& primitive);
  /// Uploads once for each way of decoding, with mip levels: SRGB8_ALPHA8 or RGBA8, as the image's coding and the use
  /// as a colour or as data say.
  GLuint texture(const Scene& scene, int image, bool colorUse, const CancelToken& cancel);
  GLuint sampler(const Sampler& sampler);
  bool expired() const { return scene_.expired(); }

 private:
  const gl::Context& context_;
  std::weak_ptr<const Scene> scene_;
  std::map<const Primitive*, GpuPrimitive> primitives_;
  std::map<std::pair<int, bool>, gl::Texture> textures_;
  std::vector<std::pair<Sampler, gl::Sampler>> samplers_;
};

}  // namespace telar::pass
