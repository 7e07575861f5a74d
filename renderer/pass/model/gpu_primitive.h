#pragma once
#include <span>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "telar/scene.h"

namespace telar::pass {

// Attribute locations of shaders/material/vertex_inputs.glsl.
enum VertexLocation : GLuint {
  POSITION = 0,
  NORMAL = 1,
  TANGENT = 2,
  UV0 = 3,
  UV1 = 4,
  COLOR = 5,
  INSTANCE_MATRIX = 6,  ///< four columns, to 9
  INSTANCE_COLOR = 10,
  VISIBILITY = 11,
  VISIBILITY_BACK = 12,
};

/// One primitive's streams on the GPU, each uploaded once.
class VertexStreams {
 public:
  VertexStreams(const gl::Context& context, const Primitive& primitive);

  /// Points the bound vertex array at the streams.
  void attach(const gl::Functions& gl) const;
  GLenum mode() const { return mode_; }
  GLsizei count() const { return count_; }
  GLuint indices() const { return indices_.get(); }

 private:
  struct Attribute {
    GLuint location;
    GLint components;
    std::size_t offset;
  };
  gl::Buffer vertices_, indices_;
  std::vector<Attribute> attributes_;
  GLenum mode_ = GL_TRIANGLES;
  GLsizei count_ = 0;  ///< indices, or vertices where there are none
};

/// Matrices and colours of instances on the GPU.
class InstanceStreams {
 public:
  InstanceStreams(const gl::Context& context, const Instances& instances);

  /// Points the bound vertex array at the streams from an instance on; they advance once an instance.
  void attach(const gl::Functions& gl, GLsizei first = 0) const;
  GLsizei count() const { return count_; }

 private:
  gl::Buffer buffer_;
  GLsizei count_ = 0;
  bool colored_ = false;
};

/// What one draw call binds and draws.
struct GpuPrimitive {
  gl::VertexArray vertexArray;
  GLenum mode = GL_TRIANGLES;
  GLsizei count = 0;                           ///< indices, or vertices where there are none
  GLuint indices = 0;                          ///< buffer, 0 = the vertices in their order
  const InstanceStreams* instances = nullptr;  ///< null = drawn once, without instance attributes

  /// All of it.
  void draw(const gl::Functions& gl) const { draw(gl, 0, count, 0, instances ? instances->count() : 0); }
  /// Indices, or vertices, from `first` on, of `drawn` instances from `firstInstance` on. The vertex array stays bound.
  void draw(const gl::Functions& gl, GLint first, GLsizei number, GLsizei firstInstance, GLsizei drawn) const;
  /// `number` indices of another buffer, from a byte on, of what is drawn once. The vertex array stays bound.
  void drawOnly(const gl::Functions& gl, GLuint buffer, std::size_t byte, GLsizei number) const;
};

}  // namespace telar::pass
