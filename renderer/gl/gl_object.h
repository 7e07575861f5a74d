#pragma once
#include <utility>

#include "gl/functions.h"

namespace telar::gl {

/// Owns one GL name. Move-only; an empty one (name 0) owns nothing. Its context must outlive it and be current when it
/// is made and destroyed. `Kind` has static generate(gl) and destroy(gl, name).
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const Functions& gl) : gl_(&gl), name_(Kind::generate(gl)) { gl.liveObjects += name_ != 0; }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      reset();
      gl_ = other.gl_;
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() { reset(); }

  void reset() noexcept {
    if (const GLuint name = std::exchange(name_, 0)) {
      Kind::destroy(*gl_, name);
      --gl_->liveObjects;
    }
  }
  GLuint get() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Functions* gl_ = nullptr;
  GLuint name_ = 0;
};

#define TELAR_GL_KIND(Kind, Gen, Del)                                                    \
  struct Kind##Kind {                                                                    \
    static GLuint generate(const Functions& gl) {                                        \
      GLuint name = 0;                                                                   \
      gl.Gen(1, &name);                                                                  \
      return name;                                                                       \
    }                                                                                    \
    static void destroy(const Functions& gl, GLuint name) noexcept { gl.Del(1, &name); } \
  };                                                                                     \
  using Kind = GlObject<Kind##Kind>;

TELAR_GL_KIND(Buffer, GenBuffers, DeleteBuffers)
TELAR_GL_KIND(Texture, GenTextures, DeleteTextures)
TELAR_GL_KIND(Sampler, GenSamplers, DeleteSamplers)
TELAR_GL_KIND(Framebuffer, GenFramebuffers, DeleteFramebuffers)
TELAR_GL_KIND(Renderbuffer, GenRenderbuffers, DeleteRenderbuffers)
TELAR_GL_KIND(VertexArray, GenVertexArrays, DeleteVertexArrays)
#undef TELAR_GL_KIND

struct ProgramNameKind {
  static GLuint generate(const Functions& gl) { return gl.CreateProgram(); }
  static void destroy(const Functions& gl, GLuint name) noexcept { gl.DeleteProgram(name); }
};
using ProgramName = GlObject<ProgramNameKind>;

template <GLenum Stage>
struct ShaderKind {
  static GLuint generate(const Functions& gl) { return gl.CreateShader(Stage); }
  static void destroy(const Functions& gl, GLuint name) noexcept { gl.DeleteShader(name); }
};
template <GLenum Stage>
using Shader = GlObject<ShaderKind<Stage>>;

}  // namespace telar::gl
