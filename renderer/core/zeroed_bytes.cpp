#include "telar/zeroed_bytes.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace telar {
namespace {

constexpr std::size_t HUGE_PAGE = std::size_t{2} << 20;

std::size_t mappedSize(std::size_t bytes) { return (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE; }

}  // namespace

void* allocateZeroed(std::size_t bytes) {
  if (bytes < HUGE_PAGE) {
    if (void* memory = std::calloc(bytes, 1)) return memory;
    throw std::bad_alloc();
  }
  const std::size_t size = mappedSize(bytes);
  if (size < bytes || size + HUGE_PAGE < size) throw std::bad_alloc();
  void* const mapped = mmap(nullptr, size + HUGE_PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  char* const begin = static_cast<char*>(mapped);
  const std::size_t before =
      mappedSize(reinterpret_cast<std::uintptr_t>(begin)) - reinterpret_cast<std::uintptr_t>(begin);
  if (before > 0) munmap(begin, before);
  munmap(begin + before + size, HUGE_PAGE - before);
  // The last page stays small: a huge one would take memory beyond the end.
  madvise(begin + before, bytes / HUGE_PAGE * HUGE_PAGE, MADV_HUGEPAGE);
  return begin + before;
}

void freeZeroed(void* memory, std::size_t bytes) noexcept {
  if (bytes < HUGE_PAGE) {
    std::free(memory);
  } else {
    munmap(memory, mappedSize(bytes));
  }
}

}  // namespace telar
