#pragma once

namespace telar {

/// Asks the memory for the line of an address that is about to be read. It may be any address.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  // GCC 12 leaves out the calls of a function that only prefetches, as if it had no effect. An asm is one.
  asm volatile("");
}

}  // namespace telar
