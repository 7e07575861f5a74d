#include "mesh/reindex.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace telar {
namespace {

using Variant = std::array<std::uint32_t, 5>;  ///< vertex and the bits of a tangent

/// For each corner the first corner with the same variant. Sorted, not hashed: no input makes this slow.
std::vector<std::uint32_t> firstCorners(const std::vector<Variant>& variants) {
  std::vector<std::uint32_t> order(variants.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return variants[a] != variants[b] ? variants[a] < variants[b] : a < b;
  });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && variants[order[i]] == variants[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

template <class T>
void repeat(std::vector<T>& stream, std::uint32_t vertex) {
  if (stream.empty()) return;
  const T value = stream[vertex];
  stream.push_back(value);
}

std::uint32_t repeatVertex(Primitive& primitive, std::uint32_t vertex) {
  repeat(primitive.positions, vertex);
  repeat(primitive.normals, vertex);
  repeat(primitive.tangents, vertex);
  for (auto& uvs : primitive.uvs) repeat(uvs, vertex);
  repeat(primitive.colors, vertex);
  return static_cast<std::uint32_t>(primitive.positions.size() - 1);
}

}  // namespace

Primitive withCornerTangents(const Primitive& source, const std::vector<glm::vec4>& tangents) {
  Primitive result = source;
  result.tangents.assign(source.positions.size(), glm::vec4(1, 0, 0, 1));
  if (source.indices.empty()) {
    std::copy(tangents.begin(), tangents.end(), result.tangents.begin());
    return result;
  }
  std::vector<Variant> variants;
  variants.reserve(tangents.size());
  for (std::size_t corner = 0; corner < tangents.size(); ++corner) {
    const auto bits = std::bit_cast<std::array<std::uint32_t, 4>>(tangents[corner]);
    variants.push_back({source.indices[corner], bits[0], bits[1], bits[2], bits[3]});
  }
  const std::vector<std::uint32_t> first = firstCorners(variants);
  std::vector<bool> taken(source.positions.size(), false);
  for (std::size_t corner = 0; corner < tangents.size(); ++corner) {
    std::uint32_t& index = result.indices[corner];
    if (first[corner] != corner) {
      index = result.indices[first[corner]];
      continue;
    }
    if (taken[index]) {
      index = repeatVertex(result, index);
    } else {
      taken[index] = true;
    }
    result.tangents[index] = tangents[corner];
  }
  return result;
}

}  // namespace telar
