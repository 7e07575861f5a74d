#include "visibility/sample_owners.h"

#include <algorithm>
#include <cmath>

#include "visibility/lanes.h"
#include "visibility/patience.h"

namespace telar::visibility {
namespace {

/// Steps of the grid that corners stand on, in a pixel: llvmpipe's.
constexpr int STEPS = 256;
/// Depths of the buffer: 24 bits.
constexpr float DEPTHS = 16777215;
constexpr std::int32_t FARTHEST = 1 << 24;
/// Pixels of a tile, on a side.
constexpr int TILE = 8;
int tilesOf(int pixels) { return (pixels + TILE - 1) / TILE; }
/// Up to so many pixels on a side, edge functions in steps fit into 32 bits.
constexpr int SMALL = 60;

using Doubles = double __attribute__((vector_size(32)));

Doubles doublesOf(double value) { return Doubles{value, value, value, value}; }

}  // namespace

/// A triangle whose corners run counter-clockwise.
struct SampleOwners::Setup {
  Pixels box;  ///< cells
  LinearPlane<float> depth;
  Owner owner;
};

namespace {

/// An edge function at the four samples of cells: twice the area of a point and the edge in steps, positive inside,
/// and 0 or more for what belongs to the triangle. Of a point on the edge between two triangles one has it: left and
/// lower edges keep theirs.
/// @tparam Vector  Mask, where all numbers fit into 32 bits, or Doubles, which are exact: no corner is farther off than
/// MOST_PLACE, and whole numbers below 2^53 have no rounding
template <class Vector>
class Edge {
 public:
  using Scalar = std::conditional_t<std::is_same_v<Vector, Mask>, std::int32_t, double>;
  /// @param placesX, placesY  of the samples in a cell, in steps    @param x, y  first cell    @param cell  steps
  Edge(const glm::ivec2& u, const glm::ivec2& v, const Mask& placesX, const Mask& placesY, int x, int y, int cell) {
    const auto dx = static_cast<Scalar>(v.x - u.x), dy = static_cast<Scalar>(v.y - u.y);
    const bool keeps = dy < 0 || (dy == 0 && dx > 0);
    const Scalar fromX = static_cast<Scalar>(x * cell - u.x), fromY = static_cast<Scalar>(y * cell - u.y);
    const Scalar begin = dx * fromY - dy * fromX - static_cast<Scalar>(keeps ? 0 : 1);
    begin_ = __builtin_convertvector(placesY, Vector) * dx - __builtin_convertvector(placesX, Vector) * dy + begin;
    nextX_ = -dy * static_cast<Scalar>(cell);
    nextY_ = dx * static_cast<Scalar>(cell);
  }
  const Vector& begin() const { return begin_; }
  Scalar nextX() const { return nextX_; }
  Scalar nextY() const { return nextY_; }

 private:
  Vector begin_{};
  Scalar nextX_, nextY_;
};

Mask insideOf(const Mask& a, const Mask& b, const Mask& c) { return (a | b | c) >= Mask{0, 0, 0, 0}; }
Mask insideOf(const Doubles& a, const Doubles& b, const Doubles& c) {
  const Doubles zero = doublesOf(0);
  return __builtin_convertvector((a >= zero) & (b >= zero) & (c >= zero), Mask);
}

template <class Vector>
using Edges = std::array<Edge<Vector>, 3>;

}  // namespace

template <class Rounding, class EdgesOf>
[[gnu::always_inline]] inline void SampleOwners::coverAs(const Setup& setup, const EdgesOf& edges,
                                                         std::int64_t& steps) {
  const Pixels& box = setup.box;
  auto row0 = edges[0].begin(), row1 = edges[1].begin(), row2 = edges[2].begin();
  const Lanes placesX = load(placesX_), placesY = load(placesY_);
  steps += static_cast<std::int64_t>(countOf(box));
  for (int y = box.fromY; y <= box.toY; ++y) {
    auto e0 = row0, e1 = row1, e2 = row2;
    const Lanes sampleY = placesY + lanesOf(static_cast<float>(y * grid_.cell));
    CellSamples* at = &samples_[indexOf(box.fromX, y)];
    for (int x = box.fromX; x <= box.toX; ++x, ++at) {
      const Mask inside = insideOf(e0, e1, e2);
      if (any(inside)) {
        const Lanes depth =
            valueAt<Rounding>(setup.depth, placesX + lanesOf(static_cast<float>(x * grid_.cell)), sampleY);
        // In this order, what is no number is farthest.
        const Lanes held = larger(lanesOf(0), smaller(depth, lanesOf(1)));
        const Mask z = __builtin_convertvector(held * lanesOf(DEPTHS), Mask);
        Mask known, owner;
        std::memcpy(&known, at->depths, sizeof known);
        std::memcpy(&owner, at->owners, sizeof owner);
        const Mask wins = inside & (z <= known);
        const auto number = static_cast<std::int32_t>(setup.owner);
        known = wins ? z : known;
        owner = wins ? Mask{number, number, number, number} : owner;
        std::memcpy(at->depths, &known, sizeof known);
        std::memcpy(at->owners, &owner, sizeof owner);
      }
      e0 += edges[0].nextX();
      e1 += edges[1].nextX();
      e2 += edges[2].nextX();
    }
    row0 += edges[0].nextY();
    row1 += edges[1].nextY();
    row2 += edges[2].nextY();
  }
}

template <class EdgesOf>
TELAR_FUSED void SampleOwners::coverFused(const Setup& setup, const EdgesOf& edges, std::int64_t& steps) {
  coverAs<Fused>(setup, edges, steps);
}

template <class EdgesOf>
void SampleOwners::cover(const Setup& setup, const EdgesOf& edges, std::int64_t& steps) {
  fused_ ? coverFused(setup, edges, steps) : coverAs<Apart>(setup, edges, steps);
}

void SampleOwners::drawTriangle(const WindowVertices& vertices, const Corners& at, Faces faces, Owner owner,
                                std::int64_t& steps) {
  const glm::ivec2 *p = &steps_[at[0]], *q = &steps_[at[1]], *r = &steps_[at[2]];
  const glm::ivec2 low = glm::min(glm::min(*p, *q), *r), high = glm::max(glm::max(*p, *q), *r);
  // Cells with a sample between them: rounded towards where there are fewer, but for numbers below 0.
  const int cell = grid_.cell * STEPS;
  const Pixels box{std::max((low.x - lastPlace_.x + cell - 1) / cell, 0),
                   std::min((high.x - firstPlace_.x) / cell, (grid_.width - 1) / grid_.cell),
                   std::max((low.y - lastPlace_.y + cell - 1) / cell, 0),
                   std::min((high.y - firstPlace_.y) / cell, (grid_.height - 1) / grid_.cell)};
  if (box.fromX > box.toX || box.fromY > box.toY || !isAskedFor(box)) return;
  const std::int64_t area = std::int64_t{q->x - p->x} * (r->y - p->y) - std::int64_t{r->x - p->x} * (q->y - p->y);
  if (area == 0) return;
  const bool counterClockwise = area > 0;
  if (faces != Faces::kBoth && counterClockwise != (faces == Faces::kCounterClockwise)) return;
  Corners turned = at;
  if (counterClockwise) std::swap(turned[0], turned[1]);
  const WindowVertex* corners[3];
  for (std::size_t i = 0; i < 3; ++i) corners[i] = &vertices.vertices[turned[i]];
  const Setup setup{box,
                    TriangleSetup(*corners[0], *corners[1], *corners[2], grid_.offset)
                        .plane(corners[0]->z, corners[1]->z, corners[2]->z),
                    owner | (counterClockwise ? COUNTER_CLOCKWISE : 0)};
  const Lanes placesX = load(placesX_), placesY = load(placesY_);
  const Mask inStepsX = __builtin_convertvector(placesX * lanesOf(STEPS), Mask);
  const Mask inStepsY = __builtin_convertvector(placesY * lanesOf(STEPS), Mask);
  if (!counterClockwise) std::swap(q, r);
  const auto edgesAs = [&](auto vector) {
    using Vector = decltype(vector);
    const auto edge = [&](const glm::ivec2& u, const glm::ivec2& v) {
      return Edge<Vector>(u, v, inStepsX, inStepsY, box.fromX, box.fromY, cell);
    };
    cover(setup, Edges<Vector>{edge(*p, *q), edge(*q, *r), edge(*r, *p)}, steps);
  };
  // A corner outside of the window is as far from the box as the triangle is large.
  if (high.x - low.x < SMALL * STEPS && high.y - low.y < SMALL * STEPS) {
    edgesAs(Mask{});
  } else {
    edgesAs(Doubles{});
  }
}

bool SampleOwners::draw(std::size_t index, const CancelToken& cancel) {
  const PlacedMesh& mesh = meshes_[index];
  const WindowVertices& vertices = vertices_[index];
  steps_.clear();
  const auto stepOf = [this](float v) { return static_cast<int>(std::lrint((v - grid_.offset) * STEPS)); };
  for (const WindowVertex& v : vertices.vertices) steps_.emplace_back(stepOf(v.x), stepOf(v.y));
  Patience patience(cancel);
  for (std::size_t i = 0; i < trianglesOf(mesh); ++i) {
    patience.spend();
    const Corners at = cornersOf(mesh, i);
    const std::uint32_t a = vertices.vertices[at[0]].outside, b = vertices.vertices[at[1]].outside,
                        c = vertices.vertices[at[2]].outside;
    if ((a & b & c & FAR_OFF) != 0) continue;
    // The GL cuts what crosses a side of the window: its corners are others, and so is what they round to.
    if (((a | b | c) & (UNPROJECTED | FAR_OFF)) != 0) return false;
    drawTriangle(vertices, at, mesh.faces, firsts_[index] + static_cast<Owner>(i), patience.steps);
  }
  return true;
}

void SampleOwners::begin() {
  Pixels all{grid_.width, -1, grid_.height, -1};
  for (const WindowVertices& v : vertices_) {
    for (const WindowVertex& at : v.vertices) {
      if ((at.outside & UNPROJECTED) != 0) continue;
      all.fromX = std::min(all.fromX, static_cast<int>(std::floor(at.x)) - 1);
      all.fromY = std::min(all.fromY, static_cast<int>(std::floor(at.y)) - 1);
      all.toX = std::max(all.toX, static_cast<int>(std::floor(at.x)) + 1);
      all.toY = std::max(all.toY, static_cast<int>(std::floor(at.y)) + 1);
    }
  }
  const auto even = [](int v) { return std::max(v, 0) & ~1; };
  const auto odd = [](int v, int size) { return std::min(v, size - 1) | 1; };
  covered_ = {even(all.fromX), odd(all.toX, grid_.width), even(all.fromY), odd(all.toY, grid_.height)};
  const bool none = covered_.fromX > covered_.toX || covered_.fromY > covered_.toY;
  const auto cells = [this](int from, int to) {
    return static_cast<std::size_t>(to + 1 - from) / static_cast<std::size_t>(grid_.cell);
  };
  stride_ = none ? 0 : cells(covered_.fromX, covered_.toX);
  samples_.assign(none ? 0 : stride_ * cells(covered_.fromY, covered_.toY),
                  {{FARTHEST, FARTHEST, FARTHEST, FARTHEST}, {NO_OWNER, NO_OWNER, NO_OWNER, NO_OWNER}});
}

void SampleOwners::findTiles(std::span<const std::uint8_t> settled) {
  tiles_.clear();
  if (settled.empty()) return;
  tiles_.assign(static_cast<std::size_t>(tilesOf(grid_.width)) * static_cast<std::size_t>(tilesOf(grid_.height)), 0);
  const std::uint8_t* pixel = settled.data();
  for (int y = grid_.height - 1; y >= 0; --y) {
    std::uint8_t* row = tiles_.data() + std::ptrdiff_t{y / TILE} * tilesOf(grid_.width);
    for (int x = 0; x < grid_.width; ++x) row[x / TILE] |= *pixel++ == 0;
  }
}

/// @param box  cells
bool SampleOwners::isAskedFor(const Pixels& box) const {
  if (tiles_.empty()) return true;
  const auto tile = [this](int cell, int size) { return std::min(cell * grid_.cell, size - 1) / TILE; };
  const auto last = [this](int cell, int size) { return std::min((cell + 1) * grid_.cell - 1, size - 1) / TILE; };
  for (int y = tile(box.fromY, grid_.height); y <= last(box.toY, grid_.height); ++y) {
    const std::uint8_t* row = tiles_.data() + std::ptrdiff_t{y} * tilesOf(grid_.width);
    for (int x = tile(box.fromX, grid_.width); x <= last(box.toX, grid_.width); ++x) {
      if (row[x] != 0) return true;
    }
  }
  return false;
}

bool SampleOwners::look(const SampleGrid& grid, std::span<const PlacedMesh> meshes, const Part& part,
                        const CancelToken& cancel) {
  grid_ = grid;
  meshes_ = meshes;
  firstPlace_ = glm::ivec2(grid.cell * STEPS);
  lastPlace_ = glm::ivec2(0);
  for (std::size_t i = 0; i < SAMPLES; ++i) {
    placesX_[i] = grid.places[i].x;
    placesY_[i] = grid.places[i].y;
    firstPlace_ = glm::min(firstPlace_, glm::ivec2(grid.places[i] * static_cast<float>(STEPS)));
    lastPlace_ = glm::max(lastPlace_, glm::ivec2(grid.places[i] * static_cast<float>(STEPS)));
  }
  firsts_.clear();
  vertices_.resize(meshes.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    cancel.check();
    firsts_.push_back(static_cast<std::uint32_t>(count));
    count += trianglesOf(meshes[i]);
    if (count >= COUNTER_CLOCKWISE - 1) return false;
    vertices_[i].place(meshes[i].outputs.floats, meshes[i].outputs.stride(), meshes[i].count, {grid.width, grid.height},
                       part.moved);
  }
  firsts_.push_back(static_cast<std::uint32_t>(count));
  begin();
  findTiles(part.settled);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!draw(i, cancel)) return false;
  }
  return true;
}

bool SampleOwners::inFrontOf(const Plane& depths) const {
  constexpr float ROUNDING = 4;  // depths: of the plane, of a place, of a depth
  const Lanes placesX = load(placesX_) + lanesOf(grid_.offset), placesY = load(placesY_) + lanesOf(grid_.offset);
  for (int y = covered_.fromY; y <= covered_.toY; y += grid_.cell) {
    for (int x = covered_.fromX; x <= covered_.toX; x += grid_.cell) {
      const CellSamples& cell = samples_[indexOf(x / grid_.cell, y / grid_.cell)];
      Mask known, owners;
      std::memcpy(&known, cell.depths, sizeof known);
      std::memcpy(&owners, cell.owners, sizeof owners);
      const Lanes plane = lanesOf(depths.a) * (placesX + lanesOf(static_cast<float>(x))) +
                          lanesOf(depths.b) * (placesY + lanesOf(static_cast<float>(y))) + lanesOf(depths.c);
      const Lanes depth = __builtin_convertvector(known, Lanes);
      if (any((depth > plane * lanesOf(DEPTHS) + lanesOf(ROUNDING)) & (owners != Mask{-1, -1, -1, -1}))) return false;
    }
  }
  return true;
}

SampleOwners::Triangle SampleOwners::triangle(Owner owner) const {
  const std::uint32_t number = numberOf(owner);
  const auto next = std::upper_bound(firsts_.begin(), firsts_.end() - 1, number);
  const auto mesh = static_cast<std::uint32_t>(next - firsts_.begin() - 1);
  return {mesh, number - firsts_[mesh]};
}

std::size_t SampleOwners::memory() const {
  std::size_t bytes = bytesOf(samples_) + bytesOf(vertices_) + bytesOf(firsts_) + bytesOf(steps_) + bytesOf(tiles_);
  for (const WindowVertices& v : vertices_) bytes += bytesOf(v.vertices);
  return bytes;
}

}  // namespace telar::visibility
