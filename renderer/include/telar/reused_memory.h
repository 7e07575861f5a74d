#pragma once
#include <cstddef>

namespace telar {

/// While it lives, large blocks that this thread gets of ZeroedAllocator may hold what freed ones held: for a decoder
/// that writes every byte. The kernel takes a third as long to clear a block as a decoder to fill it.
class ReusesMemory {
 public:
  ReusesMemory();
  ~ReusesMemory();
  ReusesMemory(const ReusesMemory&) = delete;
  ReusesMemory& operator=(const ReusesMemory&) = delete;
};

/// Bytes of freed blocks that the process keeps at most. They belong to no renderer: loader threads decode images for
/// all of them, and a block is freed where the last owner of an image ends, on any thread.
constexpr std::size_t MOST_FREED_BYTES = std::size_t{64} << 20;
/// Gives the freed blocks back to the system, those of other renderers too: they then ask the kernel for their next
/// ones, which takes time and changes no byte. @return bytes that were given back
std::size_t giveFreedBack() noexcept;

}  // namespace telar
