#include "thread_heap.h"

#include <sys/mman.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace telar::addon {
namespace {

constexpr std::size_t BLOCK_BYTES = 31u << 20;  ///< just below the size from which glibc always maps (32 MiB)
constexpr std::size_t BLOCKS = 2;               ///< that lie in one heap of a thread (64 MiB)
constexpr std::uintptr_t LARGE_PAGE_BYTES = 2u << 20;

void askForLargePages(void* block) {
  const auto begin = reinterpret_cast<std::uintptr_t>(block), end = begin + BLOCK_BYTES;
  const std::uintptr_t first = (begin / LARGE_PAGE_BYTES + 1) * LARGE_PAGE_BYTES;
  // Advice: a system that has none keeps its small ones.
  static_cast<void>(madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE));
}

}  // namespace

void growHeapOfThread() {
  // A block that was mapped and is freed teaches glibc to keep those of its size on the heap: mallopt(3), M_MMAP_THRESHOLD.
  // What a compiler takes for unused it would leave out.
  void* volatile mapped = std::malloc(BLOCK_BYTES);
  std::free(mapped);
  std::array<void* volatile, BLOCKS> onHeap{};
  for (void* volatile& block : onHeap) {
    block = std::malloc(BLOCK_BYTES);
    if (block) askForLargePages(block);
  }
  for (void* volatile& block : onHeap) std::free(block);
}

}  // namespace telar::addon
