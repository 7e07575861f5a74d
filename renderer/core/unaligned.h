#pragma once
#include <cstring>

namespace telar {

/// The value that lies at any address, aligned or not.
template <typename T>
T loadUnaligned(const void* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

}  // namespace telar
