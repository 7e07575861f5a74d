#include "trace/library.h"

namespace telar::trace {

Library::Library()
    : OwnLibrary("libtelar_reference.so",
                 "Embree is needed for quality \"reference\", the layer \"ao\" and ambient visibility",
                 "apt-get install libembree3-3") {
  if (function<TelarReferenceLayoutFunction>("telar_reference_layout")() != traceLayout()) refuse();
}

void throwFailure(const TraceFailure& failure) {
  Error error(failure.code, failure.message);
  if (failure.pointer) error.at(*failure.pointer);
  if (failure.limit) error.withLimit(failure.limit->name, failure.limit->max, failure.limit->actual);
  throw error;
}

}  // namespace telar::trace
