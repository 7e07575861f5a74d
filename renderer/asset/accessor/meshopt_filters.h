#pragma once
#include <cstddef>
#include <span>

namespace telar::asset {

// The filters of EXT_meshopt_compression, in place. libmeshoptimizer has them too, but takes the processor's
// approximate reciprocal root for them, so that its results depend on the machine; these give those of the client's
// WebAssembly.

/// Unit vectors: x, y and the largest value of 8 or 16 bits (by the stride, 4 or 8) to normalised x, y, z; w stays.
void decodeOctahedral(std::span<std::byte> data, std::size_t stride);

/// Unit quaternions of 8 bytes: three components, and in the last one the scale and which component is left out, to
/// four normalised components.
void decodeQuaternion(std::span<std::byte> data);

/// 24-bit integers with 8-bit exponents to floats.
void decodeExponential(std::span<std::byte> data);

}  // namespace telar::asset
