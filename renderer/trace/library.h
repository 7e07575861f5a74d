#pragma once
#include "core/own_library.h"
#include "reference/plugin.h"

namespace telar::trace {

/// libtelar_reference.so, loaded. @throws Error{X_LIBRARY_MISSING}
class Library : public OwnLibrary {
 public:
  Library();
};

/// What failed there, as the error that it was.
[[noreturn]] void throwFailure(const TraceFailure& failure);

}  // namespace telar::trace
