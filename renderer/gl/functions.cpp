#include "gl/functions.h"

#include <string>

#include "telar/error.h"

namespace telar::gl {
namespace {

template <class Proc>
Proc load(ProcLoader loader, const std::string& name) {
  if (auto* proc = loader(name.c_str())) return reinterpret_cast<Proc>(proc);
  return reinterpret_cast<Proc>(loader((name + "KHR").c_str()));
}

}  // namespace

Functions loadFunctions(ProcLoader loader) {
  Functions gl;
#define TELAR_GL_LOAD(upper, name)                        \
  gl.name = load<PFNGL##upper##PROC>(loader, "gl" #name); \
  if (!gl.name) throw Error("X_GL", "the GL driver has no gl" #name "; OpenGL ES 3.0 is needed");
  TELAR_GL_FUNCTIONS(TELAR_GL_LOAD)
#undef TELAR_GL_LOAD
#define TELAR_GL_LOAD(upper, name) gl.name = load<PFNGL##upper##PROC>(loader, "gl" #name);
  TELAR_GL_OPTIONAL_FUNCTIONS(TELAR_GL_LOAD)
#undef TELAR_GL_LOAD
  return gl;
}

}  // namespace telar::gl
