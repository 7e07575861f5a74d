#include "visibility/hidden_triangles.h"

#include <algorithm>

#include "visibility/patience.h"

namespace telar::visibility {
namespace {

/// Where the GL may place vertices farther off than this, in pixels, hardly a triangle hides another.
constexpr float COARSE = 1.0f / 16;

bool isCoarse(const WindowVertices& v) { return !(v.slack < COARSE); }

/// Pixels that all vertices stand in.
Pixels extentOf(const std::vector<WindowVertices>& all, const SampleGrid& grid) {
  Pixels extent{grid.width, -1, grid.height, -1};
  for (const WindowVertices& v : all) {
    if (isCoarse(v) || !(v.low[0] <= v.high[0])) continue;
    extent.fromX = std::min(extent.fromX, static_cast<int>(v.low[0]) - 1);
    extent.fromY = std::min(extent.fromY, static_cast<int>(v.low[1]) - 1);
    extent.toX = std::max(extent.toX, static_cast<int>(v.high[0]) + 1);
    extent.toY = std::max(extent.toY, static_cast<int>(v.high[1]) + 1);
  }
  return {std::max(extent.fromX, 0), std::min(extent.toX, grid.width - 1), std::max(extent.fromY, 0),
          std::min(extent.toY, grid.height - 1)};
}

}  // namespace

std::int64_t HiddenTriangles::look(const SampleGrid& grid, std::span<const DrawnMesh> meshes,
                                   const CancelToken& cancel) {
  grid_ = grid;
  meshes_ = meshes;
  vertices_.resize(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    cancel.check();
    vertices_[i].project(meshes[i].positions, meshes[i].modelView, meshes[i].projection, grid);
  }
  depth_.begin(grid, extentOf(vertices_, grid));
  std::int64_t steps = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].hides && !isCoarse(vertices_[i])) steps += addOccluders(i, cancel);
  }
  depth_.close();
  return steps;
}

WindowTriangle::Kind HiddenTriangles::make(std::size_t mesh, const Corners& at, WindowTriangle& out) const {
  const WindowVertices& v = vertices_[mesh];
  const WindowVertex &a = v.vertices[at[0]], &b = v.vertices[at[1]], &c = v.vertices[at[2]];
  if ((a.outside | b.outside | c.outside) != 0) return WindowTriangle::Kind::kUnsure;
  const auto kind = makeTriangle(a, b, c, v.slack, v.depthSlack, meshes_[mesh].faces, out);
  if (kind == WindowTriangle::Kind::kRegular) out.pixels = boxOf(a, b, c, v.slack, {grid_.width, grid_.height}).pixels;
  return kind;
}

std::int64_t HiddenTriangles::addOccluders(std::size_t index, const CancelToken& cancel) {
  const DrawnMesh& mesh = meshes_[index];
  fans_.read(mesh.indices, mesh.positions.size());
  WindowTriangle triangle;
  Patience patience(cancel);
  edge_.clear();
  for (std::size_t i = 0; i < trianglesOf(mesh); ++i) {
    patience.spend();
    const Corners at = cornersOf(mesh, i);
    if (make(index, at, triangle) != WindowTriangle::Kind::kRegular) continue;
    depth_.add(triangle, edge_, patience.steps);
    for (const Sample& sample : edge_) addBetween(index, at, triangle, sample, patience.steps);
    edge_.clear();
  }
  return patience.steps;
}

// Two triangles of one winding on either side of an edge cover, together, each sample that all their other edges
// enclose: the rasterizer gives a sample of the edge between to exactly one of them, wherever it puts the corners. So
// only those other edges need their margins. The sample may be outside of the second triangle by the inset of the edge
// between; in the bound of window_triangle.cpp this makes the sum of the other weights at most 1.5 in place of 1, hence
// twice the inset.
void HiddenTriangles::addBetween(std::size_t index, const Corners& at, const WindowTriangle& triangle,
                                 const Sample& sample, std::int64_t& steps) {
  const glm::vec2 p = depth_.placeOf(sample);
  int between = -1;
  for (int i = 0; i < 3; ++i) {
    const float inside = triangle.edges[i].at(p);
    if (inside >= triangle.margins[i] * triangle.inset) continue;
    // The other triangle's, but for what rounding puts outside of both; or near a corner.
    if (inside < -0.5f * triangle.margins[i] || between >= 0) return;
    between = i;
  }
  if (between < 0) return;
  const std::uint32_t from = at[static_cast<std::size_t>(between)],
                      to = at[static_cast<std::size_t>((between + 1) % 3)];
  const std::optional<std::uint32_t> other = fans_.withEdge(to, from, steps);
  WindowTriangle second;
  if (!other || make(index, cornersOf(meshes_[index], *other), second) != WindowTriangle::Kind::kRegular) return;
  if (second.counterClockwise != triangle.counterClockwise) return;
  const Corners corners = cornersOf(meshes_[index], *other);
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i] == to && corners[(i + 1) % 3] == from) continue;
    if (second.edges[i].at(p) < 2 * second.margins[i] * second.inset) return;
  }
  depth_.add(sample, std::max(triangle.depth.at(p) + triangle.depthSlack, second.depth.at(p) + second.depthSlack));
}

VisibleTriangles HiddenTriangles::visible(std::size_t index, const CancelToken& cancel) const {
  const DrawnMesh& mesh = meshes_[index];
  const WindowVertices& vertices = vertices_[index];
  const glm::ivec2 size(grid_.width, grid_.height);
  const double all = static_cast<double>(size.x) * size.y;
  VisibleTriangles out;
  const bool coarse = isCoarse(vertices);
  const std::size_t count = trianglesOf(mesh);
  out.indices.reserve(count * 3);
  out.parts.reserve(count);
  WindowTriangle triangle;
  Patience patience(cancel);
  for (std::size_t i = 0; i < count; ++i) {
    patience.spend();
    const Corners at = cornersOf(mesh, i);
    const WindowVertex &a = vertices.vertices[at[0]], &b = vertices.vertices[at[1]], &c = vertices.vertices[at[2]];
    double pixels = all;
    if (const std::uint32_t outside = a.outside | b.outside | c.outside; !coarse && (outside & UNPROJECTED) == 0) {
      if ((a.outside & b.outside & c.outside & FAR_OFF) != 0) continue;
      const TriangleBox box = boxOf(a, b, c, outside == 0 ? vertices.slack : CLIPPED_SLACK, size);
      if (box.pixels.fromX > box.pixels.toX || box.pixels.fromY > box.pixels.toY) continue;
      pixels = countOf(box.pixels);
      if (outside == 0) {
        const auto kind = makeTriangle(a, b, c, vertices.slack, vertices.depthSlack, mesh.faces, triangle);
        if (kind == WindowTriangle::Kind::kTurned) continue;
        triangle.pixels = box.pixels;
        if (kind == WindowTriangle::Kind::kRegular &&
            (depth_.covers(box.pixels, box.nearest - triangle.depthSlack, patience.steps) ||
             depth_.hides(triangle, patience.steps))) {
          out.hiddenPixels += pixels;
          continue;
        }
      }
    }
    out.indices.insert(out.indices.end(), at.begin(), at.end());
    out.parts.push_back(static_cast<std::uint32_t>(i));
    out.pixels += pixels;
  }
  out.steps = patience.steps;
  return out;
}

std::size_t HiddenTriangles::memory() const {
  std::size_t bytes = bytesOf(vertices_) + bytesOf(edge_) + fans_.memory() + depth_.memory();
  for (const WindowVertices& v : vertices_) bytes += bytesOf(v.vertices);
  return bytes;
}

void HiddenTriangles::release() {
  meshes_ = {};
  if (memory() > KEPT) *this = {};
}

}  // namespace telar::visibility
