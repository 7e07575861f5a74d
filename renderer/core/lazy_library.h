#pragma once
#include <string>

namespace telar {

/// A system library that few jobs need: opened when a job does, closed with the object. Nothing links it, so that
/// loading telar does not load it.
class LazyLibrary {
 public:
  /// @param file SONAME, found as the dynamic linker finds it
  /// @param package Debian package that has it, for the error
  /// @param purpose "<purpose> need it"
  /// @throws Error{X_LIBRARY_MISSING}
  LazyLibrary(const std::string& file, const std::string& package, const std::string& purpose);
  ~LazyLibrary();
  LazyLibrary(const LazyLibrary&) = delete;
  LazyLibrary& operator=(const LazyLibrary&) = delete;

  /// @throws Error{X_LIBRARY_MISSING} where the library has no such function
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(address(name));
  }

 private:
  void* address(const char* name) const;

  std::string file_;
  void* handle_;
};

}  // namespace telar
