#include "telar/simplify.h"

#include <meshoptimizer.h>

#include <cmath>
#include <tuple>
#include <type_traits>

#include "core/lazy_library.h"

namespace telar {
namespace {

using Indices = std::vector<std::uint32_t>;

// The header has templates of the same names.
using Remap = std::size_t(unsigned*, const unsigned*, std::size_t, std::size_t, const meshopt_Stream*, std::size_t);
using Simplify = std::size_t(unsigned*, const unsigned*, std::size_t, const float*, std::size_t, std::size_t,
                             std::size_t, float, unsigned, float*);
static_assert(std::is_same_v<decltype(static_cast<Remap*>(meshopt_generateVertexRemapMulti)), Remap*>);
static_assert(std::is_same_v<decltype(static_cast<Simplify*>(meshopt_simplify)), Simplify*>);

constexpr double WORTH_IT = 0.8;  ///< of the triangles, that may be left
constexpr std::uint32_t UNUSED = ~std::uint32_t{0};

/// Calls visit(stream...) with each stream of one primitive, or with those of several side by side.
template <class Visit, class... P>
void eachStream(const Visit& visit, P&... primitive) {
  visit(primitive.positions...);
  visit(primitive.normals...);
  visit(primitive.tangents...);
  for (std::size_t i = 0; i < std::tuple_size_v<decltype(Primitive::uvs)>; ++i) visit(primitive.uvs[i]...);
  visit(primitive.colors...);
  for (std::size_t i = 0; i < std::tuple_size_v<decltype(Primitive::visibility)>; ++i)
    visit(primitive.visibility[i]...);
}

/// Whole triangles, whose equal vertices are one: files that give each triangle its own are one surface then.
struct Welded {
  Indices indices;                   ///< into the others
  Indices vertices;                  ///< of the primitive
  std::vector<glm::vec3> positions;  ///< theirs
};

Welded welded(const LazyLibrary& library, const Primitive& primitive) {
  const std::size_t count = primitive.positions.size();
  Welded out;
  out.indices = primitive.indices;
  if (out.indices.empty()) {
    out.indices.resize(count);
    for (std::size_t i = 0; i < count; ++i) out.indices[i] = static_cast<std::uint32_t>(i);
  }
  out.indices.resize(out.indices.size() / 3 * 3);
  std::vector<meshopt_Stream> streams;
  eachStream(
      [&](const auto& stream) {
        if (!stream.empty()) streams.push_back({stream.data(), sizeof stream[0], sizeof stream[0]});
      },
      primitive);
  Indices remap(count);
  const std::size_t unique = library.function<Remap>("meshopt_generateVertexRemapMulti")(
      remap.data(), out.indices.data(), out.indices.size(), count, streams.data(), streams.size());
  out.vertices.resize(unique);
  out.positions.resize(unique);
  for (std::uint32_t& index : out.indices) {
    const std::uint32_t same = remap[index];
    out.vertices[same] = index;
    out.positions[same] = primitive.positions[index];
    index = same;
  }
  return out;
}

/// The primitive with these triangles, and no vertex that none of them has.
Primitive withIndices(const Primitive& primitive, const Indices& indices) {
  Primitive out;
  out.topology = primitive.topology;
  out.colorsHaveAlpha = primitive.colorsHaveAlpha;
  out.file = primitive.file;
  out.material = primitive.material;
  out.variantMaterials = primitive.variantMaterials;
  // What is estimated and sorted by them is the same.
  out.bounds = primitive.bounds;
  out.fileBounds = primitive.fileBounds;
  out.center = primitive.center;
  Indices place(primitive.positions.size(), UNUSED), used;
  for (const std::uint32_t index : indices) {
    if (place[index] == UNUSED) {
      place[index] = static_cast<std::uint32_t>(used.size());
      used.push_back(index);
    }
    out.indices.push_back(place[index]);
  }
  eachStream(
      [&](const auto& from, auto& to) {
        if (from.empty()) return;
        to.reserve(used.size());
        for (const std::uint32_t index : used) to.push_back(from[index]);
      },
      primitive, out);
  return out;
}

}  // namespace

std::optional<Primitive> simplified(const Primitive& primitive, double error) {
  const LazyLibrary library("libmeshoptimizer.so.2d", "libmeshoptimizer2d", "pictures of fewer triangles");
  const Welded whole = welded(library, primitive);
  if (whole.indices.empty()) return std::nullopt;
  const auto* positions = &whole.positions.data()->x;
  constexpr std::size_t STRIDE = sizeof whole.positions[0];
  const std::size_t vertices = whole.positions.size();
  const float extent =
      library.function<decltype(meshopt_simplifyScale)>("meshopt_simplifyScale")(positions, vertices, STRIDE);
  const auto relative = static_cast<float>(error / extent);
  if (!(extent > 0) || !std::isfinite(extent) || !(relative > 0)) return std::nullopt;
  Indices left(whole.indices.size());
  left.resize(library.function<Simplify>("meshopt_simplify")(left.data(), whole.indices.data(), whole.indices.size(),
                                                             positions, vertices, STRIDE, 0, relative, 0, nullptr));
  // A surface that is smaller than the error has no triangle left: it would not be seen at all.
  if (left.empty() || static_cast<double>(left.size()) > WORTH_IT * static_cast<double>(whole.indices.size()))
    return std::nullopt;
  for (std::uint32_t& index : left) index = whole.vertices[index];
  return withIndices(primitive, left);
}

}  // namespace telar
