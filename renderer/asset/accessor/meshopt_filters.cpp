#include "asset/accessor/meshopt_filters.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/unaligned.h"

namespace telar::asset {
namespace {

template <typename T>
void store(std::byte* to, T value) {
  std::memcpy(to, &value, sizeof value);
}

/// To the nearest, halves to the even one. The low bits of what does not fit, as vector code keeps them.
template <typename T>
T rounded(float value) {
  return static_cast<T>(std::isfinite(value) ? static_cast<std::int64_t>(std::nearbyint(value)) : 0);
}

template <typename T>
void decodeOctahedralOf(std::span<std::byte> data) {
  constexpr auto LARGEST = static_cast<float>(std::numeric_limits<T>::max());
  for (std::size_t at = 0; at + 4 * sizeof(T) <= data.size(); at += 4 * sizeof(T)) {
    std::byte* const vector = data.data() + at;
    auto x = static_cast<float>(loadUnaligned<T>(vector)), y = static_cast<float>(loadUnaligned<T>(vector + sizeof(T)));
    const float z = static_cast<float>(loadUnaligned<T>(vector + 2 * sizeof(T))) - (std::abs(x) + std::abs(y));
    const float fold = std::min(z, 0.0f);  // the lower half is folded over the edges
    x += std::copysign(1.0f, x) * fold;
    y += std::copysign(1.0f, y) * fold;
    const float scale = LARGEST / std::sqrt(x * x + (y * y + z * z));
    store(vector, rounded<T>(x * scale));
    store(vector + sizeof(T), rounded<T>(y * scale));
    store(vector + 2 * sizeof(T), rounded<T>(z * scale));
  }
}

}  // namespace

void decodeOctahedral(std::span<std::byte> data, std::size_t stride) {
  stride == 4 ? decodeOctahedralOf<std::int8_t>(data) : decodeOctahedralOf<std::int16_t>(data);
}

void decodeQuaternion(std::span<std::byte> data) {
  const float root = 1.0f / std::sqrt(2.0f);  // no component but the largest one exceeds it
  for (std::size_t at = 0; at + 8 <= data.size(); at += 8) {
    std::byte* const quaternion = data.data() + at;
    const int last = loadUnaligned<std::int16_t>(quaternion + 6);
    const float scale = root / static_cast<float>(last | 3);
    float value[4];
    for (std::size_t i = 0; i < 3; ++i)
      value[i + 1] = static_cast<float>(loadUnaligned<std::int16_t>(quaternion + 2 * i)) * scale;
    const float rest = 1.0f - (value[1] * value[1] + (value[2] * value[2] + value[3] * value[3]));
    value[0] = std::sqrt(std::max(rest, 0.0f));
    for (std::size_t i = 0; i < 4; ++i) {
      store(quaternion + 2 * ((static_cast<std::size_t>(last) + i) & 3), rounded<std::int16_t>(value[i] * 32767.0f));
    }
  }
}

void decodeExponential(std::span<std::byte> data) {
  for (std::size_t at = 0; at + 4 <= data.size(); at += 4) {
    const auto bits = loadUnaligned<std::uint32_t>(data.data() + at);
    const auto exponent = static_cast<std::int32_t>(bits) >> 24;
    const auto mantissa = static_cast<std::int32_t>(bits << 8) >> 8;
    const auto power = std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23);
    store(data.data() + at, power * static_cast<float>(mantissa));
  }
}

}  // namespace telar::asset
