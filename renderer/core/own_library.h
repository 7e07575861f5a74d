#pragma once
#include <string>

namespace telar {

/// A library of ours that few jobs need, and that links what not every host has. It lies beside the addon (or in
/// TELAR_LIBRARY_DIR), is loaded when a job first needs it, and is never unloaded: what it links does not bear that,
/// and loading it again is cheap.
class OwnLibrary {
 public:
  /// @param file  e.g. "libtelar_oiio.so"
  /// @param need  "OpenImageIO is needed for .hdr files"
  /// @param cure  "apt-get install libopenimageio2.4"
  /// @throws Error{X_LIBRARY_MISSING}
  OwnLibrary(std::string file, std::string need, std::string cure);
  ~OwnLibrary();
  OwnLibrary(const OwnLibrary&) = delete;
  OwnLibrary& operator=(const OwnLibrary&) = delete;

  /// @throws Error{X_LIBRARY_MISSING}
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(address(name));
  }
  /// @throws Error{X_LIBRARY_MISSING} always: the library says that it was built apart from the addon
  [[noreturn]] void refuse() const;

 private:
  void* address(const char* name) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_, need_, cure_;
  void* handle_ = nullptr;
};

}  // namespace telar
