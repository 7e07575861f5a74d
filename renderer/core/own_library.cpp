#include "core/own_library.h"

#include <dlfcn.h>

#include <cstdlib>

#include "telar/error.h"

namespace telar {
namespace {

/// Folder of the .node, .so or program that holds this function, with a slash at its end.
std::string ownFolder() {
  Dl_info info = {};
  if (!dladdr(reinterpret_cast<const void*>(&ownFolder), &info) || !info.dli_fname) return "./";
  const std::string path = info.dli_fname;
  return path.substr(0, path.rfind('/') + 1);
}

/// What the loader misses, without the folder: its message starts with the file's path.
std::string missingFile(const char* message, const std::string& file) {
  const std::string text = message ? message : file;
  const std::string path = text.substr(0, text.find(':'));
  return path.substr(path.rfind('/') + 1);
}

}  // namespace

OwnLibrary::OwnLibrary(std::string file, std::string need, std::string cure)
    : file_(std::move(file)), need_(std::move(need)), cure_(std::move(cure)) {
  const char* folder = std::getenv("TELAR_LIBRARY_DIR");
  const std::string path = (folder && *folder ? std::string(folder) + "/" : ownFolder()) + file_;
  handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle_) fail(missingFile(dlerror(), file_) + " cannot be loaded");
}

OwnLibrary::~OwnLibrary() { dlclose(handle_); }

void OwnLibrary::refuse() const { fail(file_ + " is of another version"); }

void* OwnLibrary::address(const char* name) const {
  void* out = dlsym(handle_, name);
  if (!out) fail(file_ + " is incomplete");
  return out;
}

void OwnLibrary::fail(const std::string& what) const {
  throw Error("X_LIBRARY_MISSING",
              need_ + ", but " + what + "; run: " + cure_ + ", and build telar again if it is older");
}

}  // namespace telar
