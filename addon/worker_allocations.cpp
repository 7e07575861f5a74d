// Of libtelar_worker.so: counts the allocations of a process that failed, whoever asked for them. A worker of a pool
// has it by LD_PRELOAD. GL drivers do not look at each of their allocations: after one that failed they may draw a
// wrong picture without a word. Nothing else is changed: each call goes on to the allocator that is next.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace {

std::atomic<unsigned> failures{0};

/// A function of the allocator that was loaded after this library.
template <typename Function>
class Next {
 public:
  explicit constexpr Next(const char* name) : name_(name) {}

  /// Null while it is looked for: a loader that allocates for that finds another way.
  Function* get() {
    Function* known = function_.load(std::memory_order_relaxed);
    return known ? known : find();
  }

 private:
  [[gnu::noinline, gnu::cold]] Function* find() {
    if (isSearching) return nullptr;
    isSearching = true;
    auto* found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
    isSearching = false;
    function_.store(found, std::memory_order_relaxed);
    return found;
  }

  static inline thread_local bool isSearching = false;
  const char* name_;
  std::atomic<Function*> function_{nullptr};
};

constinit Next<void*(std::size_t)> nextMalloc("malloc"), nextValloc("valloc");
constinit Next<void*(std::size_t, std::size_t)> nextCalloc("calloc"), nextMemalign("memalign"),
    nextAlignedAlloc("aligned_alloc");
constinit Next<void*(void*, std::size_t)> nextRealloc("realloc");
constinit Next<int(void**, std::size_t, std::size_t)> nextPosixMemalign("posix_memalign");

/// An allocation of no bytes may give nothing.
void* counted(void* memory, std::size_t bytes) {
  if (!memory && bytes > 0) [[unlikely]]
    failures.fetch_add(1, std::memory_order_relaxed);
  return memory;
}

template <typename Function, typename... Arguments>
void* call(Next<Function>& next, std::size_t bytes, Arguments... arguments) {
  if (auto* function = next.get()) [[likely]]
    return counted(function(arguments...), bytes);
  errno = ENOMEM;
  return nullptr;
}

}  // namespace

#define TELAR_EXPORT extern "C" [[gnu::visibility("default")]]

/// How many have failed so far. The addon looks it up by this name (allocations.cpp).
TELAR_EXPORT unsigned telarFailedAllocations() { return failures.load(std::memory_order_relaxed); }

TELAR_EXPORT void* malloc(std::size_t bytes) { return call(nextMalloc, bytes, bytes); }

TELAR_EXPORT void* valloc(std::size_t bytes) { return call(nextValloc, bytes, bytes); }

TELAR_EXPORT void* calloc(std::size_t count, std::size_t bytes) {
  return call(nextCalloc, count == 0 ? 0 : bytes, count, bytes);
}

TELAR_EXPORT void* realloc(void* old, std::size_t bytes) { return call(nextRealloc, bytes, old, bytes); }

TELAR_EXPORT void* memalign(std::size_t alignment, std::size_t bytes) {
  return call(nextMemalign, bytes, alignment, bytes);
}

TELAR_EXPORT void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return call(nextAlignedAlloc, bytes, alignment, bytes);
}

TELAR_EXPORT int posix_memalign(void** result, std::size_t alignment, std::size_t bytes) {
  auto* function = nextPosixMemalign.get();
  const int error = function ? function(result, alignment, bytes) : ENOMEM;
  if (function && error == ENOMEM) [[unlikely]]
    failures.fetch_add(1, std::memory_order_relaxed);
  return error;
}
