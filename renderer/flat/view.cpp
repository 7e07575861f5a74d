#include "flat/view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flat/crossings.h"
#include "frame/camera.h"

namespace telar::flat {
namespace {

using surface::Face;

/// Triangles over cells that the grid may hold: a GB at most. Few large cells take more triangles each, not more
/// memory.
constexpr std::uint64_t ENTRIES_MAX = std::uint64_t{1} << 26;
constexpr std::uint32_t FACES_PER_CANCEL_CHECK = 1 << 14;

}  // namespace

View::View(const surface::Surface& surface, const Shot& shot, const CancelToken& cancel)
    : surface_(surface), near_(shot.camera.near), far_(shot.camera.far), size_(shot.width, shot.height) {
  const frame::Camera camera = frame::cameraOf(shot);
  orthographic_ = camera.orthographic;
  pixelsPerMetre_ = camera.projection[1][1] * shot.height / 2;
  toPixel_ = frame::worldToPixel(camera, shot.width, shot.height);
  for (const glm::dvec3& p : surface.points) {
    points_.push_back(project(p));
    const double ahead = -(camera.view * glm::dvec4(p, 1)).z;
    seen_.push_back(orthographic_ || ahead > near_ ? 1 : 0);
  }
  cancel.check();
  buildGrid(cancel);
}

glm::dvec3 View::project(const glm::dvec3& world) const {
  const glm::dvec4 p = toPixel_ * glm::dvec4(world, 1);
  return glm::dvec3(p) / p.w;
}

double View::metres(double depth) const {
  return orthographic_ ? near_ + depth * (far_ - near_) : near_ * far_ / (far_ - depth * (far_ - near_));
}

bool View::cellsOf(std::uint32_t f, glm::ivec2& low, glm::ivec2& high) const {
  const auto& [a, b, c] = surface_.faces[f].points;
  if (!seen_[a] || !seen_[b] || !seen_[c]) return false;
  const glm::dvec2 p(points_[a]), q(points_[b]), r(points_[c]);
  const glm::dvec2 min = glm::min(glm::min(p, q), r) / cell_, max = glm::max(glm::max(p, q), r) / cell_;
  if (max.x < 0 || max.y < 0 || min.x > cells_.x || min.y > cells_.y) return false;
  low = glm::clamp(glm::ivec2(glm::floor(glm::max(min, -1.0))), glm::ivec2(0), cells_ - 1);
  high = glm::clamp(glm::ivec2(glm::floor(glm::min(max, 1e6))), glm::ivec2(0), cells_ - 1);
  return true;
}

std::span<const std::uint32_t> View::facesIn(const glm::ivec2& cell) const {
  const auto index =
      static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_.x) + static_cast<std::size_t>(cell.x);
  return {faces_.data() + first_[index], first_[index + 1] - first_[index]};
}

glm::ivec2 View::firstCell(std::uint32_t face) const {
  glm::ivec2 low(0), high;
  cellsOf(face, low, high);
  return low;
}

void View::buildGrid(const CancelToken& cancel) {
  const auto faces = static_cast<std::uint32_t>(surface_.faces.size());
  glm::ivec2 low, high;
  for (;; cell_ *= 2) {
    cells_ = glm::ivec2(glm::ceil(glm::dvec2(size_) / cell_)) + 1;
    first_.assign(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y) + 1, 0);
    std::uint64_t entries = 0;
    for (std::uint32_t f = 0; f < faces && entries <= ENTRIES_MAX; ++f) {
      if (f % FACES_PER_CANCEL_CHECK == 0) cancel.check();
      if (!cellsOf(f, low, high)) continue;
      entries += static_cast<std::uint64_t>(high.x - low.x + 1) * static_cast<std::uint64_t>(high.y - low.y + 1);
      if (entries > ENTRIES_MAX) break;
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) ++first_[static_cast<std::size_t>(y * cells_.x + x) + 1];
      }
    }
    if (entries <= ENTRIES_MAX || cells_.x * cells_.y <= 16) break;
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  faces_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t f = 0; f < faces; ++f) {
    if (f % FACES_PER_CANCEL_CHECK == 0) cancel.check();
    if (!cellsOf(f, low, high)) continue;
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x)
        faces_[next[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.x) + static_cast<std::size_t>(x)]++] =
            f;
    }
  }
}

template <class Visit>
void View::visit(const glm::dvec2& place, const Visit& visit) const {
  const glm::dvec2 cell = glm::floor(place / cell_);
  if (!(cell.x >= 0 && cell.y >= 0 && cell.x < cells_.x && cell.y < cells_.y)) return;
  for (const std::uint32_t f : facesIn(glm::ivec2(cell))) {
    const Face& face = surface_.faces[f];
    const glm::dvec3 &a = points_[face.points[0]], &b = points_[face.points[1]], &c = points_[face.points[2]];
    const glm::dvec2 u(b - a), v(c - a), w = place - glm::dvec2(a);
    const double area = cross(u, v);
    if (area == 0) continue;
    const double s = cross(w, v) / area, t = cross(u, w) / area;
    if (s < 0 || t < 0 || s + t > 1) continue;
    visit(f, a.z + s * (b.z - a.z) + t * (c.z - a.z));
  }
}

View::Hit View::nearest(const glm::dvec2& place) const {
  Hit hit{std::numeric_limits<double>::infinity(), surface::NONE};
  visit(place, [&hit](std::uint32_t face, double depth) {
    if (depth < hit.depth) hit = {depth, face};
  });
  return hit;
}

bool View::isHidden(const glm::dvec2& place, double metresThere, std::span<const std::uint32_t> own) const {
  bool hidden = false;
  visit(place, [&](std::uint32_t face, double depth) {
    hidden |= metres(depth) < metresThere && std::find(own.begin(), own.end(), face) == own.end();
  });
  return hidden;
}

/// Cosine between a face's normal and the line of sight.
double View::flatness(std::uint32_t face) const {
  const auto& [i, k, m] = surface_.faces[face].points;
  const glm::dvec3 &a = points_[i], &b = points_[k], &c = points_[m];
  const glm::dvec2 u(b - a), v(c - a);
  const double at = metres(a.z), toB = metres(b.z) - at, toC = metres(c.z) - at, area = cross(u, v);
  const glm::dvec2 rise = glm::dvec2(toB * v.y - toC * u.y, toC * u.x - toB * v.x) / area * pixelsPerMetre(at);
  return 1 / std::sqrt(1 + glm::dot(rise, rise));
}

bool View::isHiddenBeyond(const glm::dvec2& place, double metresThere, double away,
                          std::span<const std::uint32_t> own) const {
  bool hidden = false;
  visit(place, [&](std::uint32_t face, double depth) {
    const double before = metresThere - metres(depth);
    hidden |= before > away && before * flatness(face) > away && std::find(own.begin(), own.end(), face) == own.end();
  });
  return hidden;
}

}  // namespace telar::flat
