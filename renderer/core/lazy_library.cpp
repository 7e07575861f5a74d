#include "core/lazy_library.h"

#include <dlfcn.h>

#include "telar/error.h"

namespace telar {

LazyLibrary::LazyLibrary(const std::string& file, const std::string& package, const std::string& purpose)
    : file_(file), handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_) return;
  throw Error("X_LIBRARY_MISSING",
              purpose + " need " + file + ", which cannot be loaded; run: apt-get install " + package);
}

LazyLibrary::~LazyLibrary() { dlclose(handle_); }

void* LazyLibrary::address(const char* name) const {
  void* out = dlsym(handle_, name);
  if (!out) throw Error("X_LIBRARY_MISSING", file_ + " has no " + name + "; install another version of it");
  return out;
}

}  // namespace telar
