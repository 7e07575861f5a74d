#pragma once
#include <malloc.h>

#include <cstdint>

namespace telar::addon {

/// glibc keeps what models took in the arenas of the threads that freed it: a process that draws many of them grows to
/// several times what it uses. After so many bytes of models were freed, all free pages go back to the system. One
/// thread's.
class FreedMemory {
 public:
  void add(std::uint64_t bytes) {
    since_ += bytes;
    if (since_ >= RETURN_AT) giveBack();
  }
  void giveBack() {
    malloc_trim(0);
    since_ = 0;
  }

 private:
  static constexpr std::uint64_t RETURN_AT = 128ull << 20;
  std::uint64_t since_ = 0;
};

}  // namespace telar::addon
