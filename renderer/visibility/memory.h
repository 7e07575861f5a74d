#pragma once
#include <cstddef>
#include <vector>

namespace telar::visibility {

/// Bytes that a vector holds, used or not.
template <class T>
std::size_t bytesOf(const std::vector<T>& all) {
  return all.capacity() * sizeof(T);
}

}  // namespace telar::visibility
