#include "telar/zeroed_bytes.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <new>

#include "telar/reused_memory.h"

namespace telar {
namespace {

constexpr std::size_t HUGE_PAGE = std::size_t{2} << 20;

std::size_t mappedSize(std::size_t bytes) { return (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE; }

/// Blocks that were freed, the oldest first.
class FreedBlocks {
 public:
  /// Takes a block, and drops the oldest ones that are too much with it. @return false = it is too large
  bool put(void* memory, std::size_t size) noexcept {
    if (size > MOST_FREED_BYTES) return false;
    const std::lock_guard lock(mutex_);
    while (bytes_ + size > MOST_FREED_BYTES || count_ == blocks_.size()) drop(0);
    blocks_[count_++] = {memory, size};
    bytes_ += size;
    return true;
  }
  /// The newest one of this size, or null.
  void* take(std::size_t size) noexcept {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = count_; i-- > 0;) {
      if (blocks_[i].size == size) return remove(i).memory;
    }
    return nullptr;
  }
  /// @return bytes that were kept
  std::size_t clear() noexcept {
    const std::lock_guard lock(mutex_);
    const std::size_t kept = bytes_;
    while (count_ > 0) drop(count_ - 1);
    return kept;
  }

 private:
  struct Block {
    void* memory;
    std::size_t size;
  };
  Block remove(std::size_t at) noexcept {
    const Block block = blocks_[at];
    std::copy(&blocks_[at] + 1, &blocks_[0] + count_, &blocks_[at]);
    --count_;
    bytes_ -= block.size;
    return block;
  }
  void drop(std::size_t at) noexcept {
    const Block block = remove(at);
    munmap(block.memory, block.size);
  }

  std::mutex mutex_;
  std::array<Block, MOST_FREED_BYTES / HUGE_PAGE> blocks_{};
  std::size_t count_ = 0, bytes_ = 0;
};

/// One for the process, as the heap is: an allocator that containers carry by type knows of no renderer.
FreedBlocks& freedBlocks() {
  static constinit FreedBlocks blocks;
  return blocks;
}

thread_local bool reusesMemory = false;

}  // namespace

ReusesMemory::ReusesMemory() { reusesMemory = true; }
ReusesMemory::~ReusesMemory() { reusesMemory = false; }
std::size_t giveFreedBack() noexcept { return freedBlocks().clear(); }

void* allocateZeroed(std::size_t bytes) {
  if (bytes < HUGE_PAGE) {
    if (void* memory = std::calloc(bytes, 1)) return memory;
    throw std::bad_alloc();
  }
  const std::size_t size = mappedSize(bytes);
  if (size < bytes || size + HUGE_PAGE < size) throw std::bad_alloc();
  if (reusesMemory) {
    if (void* const memory = freedBlocks().take(size)) return memory;
  }
  const auto map = [size] {
    return mmap(nullptr, size + HUGE_PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  };
  void* mapped = map();
  if (mapped == MAP_FAILED) {
    giveFreedBack();
    mapped = map();
  }
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
  } else if (!freedBlocks().put(memory, mappedSize(bytes))) {
    munmap(memory, mappedSize(bytes));
  }
}

}  // namespace telar
