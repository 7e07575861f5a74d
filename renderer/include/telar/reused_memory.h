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

/// Bytes of freed blocks that the process keeps at most.
constexpr std::size_t MOST_FREED_BYTES = std::size_t{64} << 20;
/// Bytes of the freed blocks that it keeps.
std::size_t freedBytes() noexcept;
/// Gives them back to the system.
void giveFreedBack() noexcept;

}  // namespace telar
