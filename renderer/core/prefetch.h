#pragma once

namespace telar {

/// Asks the memory for the line of an address that is about to be read. It may be any address.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  // GCC 12 takes a function that only prefetches for one without an effect, and leaves out its calls. An asm is an effect.
  asm volatile("");
}

}  // namespace telar
