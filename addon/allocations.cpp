#include "allocations.h"

#include <dlfcn.h>

#include <cstdint>
#include <cstdlib>

namespace telar::addon {
namespace {

using Counter = unsigned();

/// The counter of libtelar_worker.so, if one that cannot succeed is counted.
Counter* findCounter() {
  auto* counter = reinterpret_cast<Counter*>(dlsym(RTLD_DEFAULT, "telarFailedAllocations"));
  if (!counter) return nullptr;
  const unsigned before = counter();
  volatile std::size_t most = PTRDIFF_MAX;
  void* volatile none = std::malloc(most);
  std::free(none);
  return counter() == before ? nullptr : counter;
}

}  // namespace

std::optional<unsigned> failedAllocations() {
  static Counter* const counter = findCounter();
  if (!counter) return std::nullopt;
  return counter();
}

}  // namespace telar::addon
