#include "thread_heap.h"

#include <array>
#include <cstddef>
#include <cstdlib>

namespace telar::addon {
namespace {

constexpr std::size_t BLOCK_BYTES = 31u << 20;  ///< just below the size from which glibc always maps (32 MiB)
constexpr std::size_t BLOCKS = 2;               ///< that lie in one heap of a thread (64 MiB)

}  // namespace

void growHeapOfThread() {
  // A block that was mapped and is freed teaches glibc to keep those of its size on the heap: mallopt(3), M_MMAP_THRESHOLD.
  // What a compiler takes for unused it would leave out.
  void* volatile mapped = std::malloc(BLOCK_BYTES);
  std::free(mapped);
  std::array<void* volatile, BLOCKS> onHeap{};
  for (void* volatile& block : onHeap) block = std::malloc(BLOCK_BYTES);
  for (void* volatile& block : onHeap) std::free(block);
}

}  // namespace telar::addon
