#pragma once
#include <cstddef>
#include <cstring>

namespace telar::asset {

/// The number that lies at any address.
template <typename T>
T loadUnaligned(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

}  // namespace telar::asset
