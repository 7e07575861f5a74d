#include "gl/library.h"

#include <dlfcn.h>

#include "telar/error.h"

namespace telar::gl {

Library::Library(std::initializer_list<const char*> names) {
  std::string failure;
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_) {
      name_ = name;
      return;
    }
    if (failure.empty()) failure = std::string(name) + " cannot be loaded";
  }
  throw Error("X_GL", failure);
}

void* Library::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (!found) throw Error("X_GL", name_ + " has no " + name);
  return found;
}

}  // namespace telar::gl
