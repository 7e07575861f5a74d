#pragma once
#include <initializer_list>
#include <string>

namespace telar::gl {

/// A shared library that is opened when first needed and stays mapped: GL drivers keep threads and thread-local
/// destructors, so unmapping one while the process lives is not safe.
class Library {
 public:
  /// Opens the first name that exists. @throws Error{X_GL} with the loader's own message.
  explicit Library(std::initializer_list<const char*> names);
  void* symbol(const char* name) const;

  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* handle_ = nullptr;
  std::string name_;
};

}  // namespace telar::gl
