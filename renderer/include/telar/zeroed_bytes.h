#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace telar {

/// Memory that is 0. Large blocks lie in huge pages where the kernel has them: 4 KiB at a time, the kernel takes as
/// long to give the memory of an image as a decoder to fill it. @throws std::bad_alloc
void* allocateZeroed(std::size_t bytes);
/// @param bytes as allocateZeroed() had them
void freeZeroed(void* memory, std::size_t bytes) noexcept;

/// Of elements that are all bits 0 before anything is written: a vector of a size does not clear what is clear.
template <class T>
struct ZeroedAllocator {
  using value_type = T;

  ZeroedAllocator() = default;
  template <class U>
  explicit(false) ZeroedAllocator(const ZeroedAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocateZeroed(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { freeZeroed(memory, count * sizeof(T)); }
  template <class U>
  void construct(U*) noexcept {}
  template <class U, class... Args>
  void construct(U* at, Args&&... args) {
    std::construct_at(at, std::forward<Args>(args)...);
  }
  bool operator==(const ZeroedAllocator&) const = default;
};

/// Bytes that are 0 when made with a size. Grown within its capacity, it may show what it held before.
using ZeroedBytes = std::vector<std::uint8_t, ZeroedAllocator<std::uint8_t>>;

}  // namespace telar
