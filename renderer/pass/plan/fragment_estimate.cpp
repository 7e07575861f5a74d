#include "pass/plan/fragment_estimate.h"

#include <algorithm>
#include <cmath>

#include "telar/error.h"

namespace telar::pass {
namespace {

constexpr std::size_t PARTS_PER_CANCEL_CHECK = 1 << 16;

/// The clip planes that a point is outside of. A polygon whose points are all outside of one is not visible.
unsigned outside(const glm::vec4& p) {
  return (p.x < -p.w ? 1u : 0u) | (p.x > p.w ? 2u : 0u) | (p.y < -p.w ? 4u : 0u) | (p.y > p.w ? 8u : 0u) |
         (p.z < -p.w ? 16u : 0u);
}

/// The pictures that a frame draws the model into.
struct View {
  glm::dmat4 toClip;
  int width, height;
};

std::size_t countInstances(const DrawItem& item) { return item.instances() ? item.instances()->matrices.size() : 1; }

/// @return fragments of an item in a view, or what was counted when it was more than `enough`
double fragmentsOf(const DrawItem& item, const View& view, double enough, const CancelToken& cancel) {
  FragmentEstimate estimate(*item.primitive, view.toClip * item.node->world, view.width, view.height);
  double sum = 0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < countInstances(item) && sum <= enough; ++i) {
    if (item.instances()) estimate.moveTo(item.instances()->matrices[i]);
    sum += estimate.all(enough - sum);
    if ((seen += estimate.parts()) < PARTS_PER_CANCEL_CHECK) continue;
    seen = 0;
    cancel.check();
  }
  return sum;
}

/// The same as a quick bound.
double mostFragmentsOf(const DrawItem& item, const View& view, const PartExtents& extents) {
  FragmentEstimate estimate(*item.primitive, view.toClip * item.node->world, view.width, view.height);
  if (!item.instances()) return estimate.atMost(extents.all);
  double sum = 0;
  for (const glm::mat4& matrix : item.instances()->matrices) {
    estimate.moveTo(matrix);
    sum += estimate.atMost(extents.all);
  }
  return sum;
}

/// Calls `take` with each item and each view that it is drawn into.
template <class Take>
void forEachDraw(const FramePlan& plan, const Shot& shot, const Take& take) {
  const View picture{plan.camera.projection * plan.camera.view, shot.width, shot.height};
  for (const auto* list : plan.draws.all()) {
    for (const DrawItem& item : *list) take(item, picture);
  }
  for (const auto* maps : {&plan.shadows.flat, &plan.shadows.cube}) {
    for (const ShadowMap& map : *maps) {
      for (const frame::Camera& camera : map.views) {
        const View view{camera.projection * camera.view, map.settings.mapSize, map.settings.mapSize};
        for (const auto* list : plan.draws.shown()) {
          for (const DrawItem& item : *list) {
            if (item.castsShadow()) take(item, view);
          }
        }
      }
    }
  }
}

}  // namespace

FragmentEstimate::FragmentEstimate(const Primitive& primitive, const glm::dmat4& toClip, int width, int height)
    : primitive_(&primitive), layout_(primitive), base_(toClip), toClip_(base_), size_(width, height) {
  measure();
}

void FragmentEstimate::moveTo(const glm::mat4& instance) {
  toClip_ = glm::mat4(base_ * glm::dmat4(instance));
  measure();
}

/// Where a picture's x is X / W, rows of a matrix, its gradient is (X' - x W') / W, and -1 <= x <= 1 in what is seen.
void FragmentEstimate::measure() {
  const glm::dmat4 m(toClip_);
  const auto row = [&m](int i) { return glm::dvec3(m[0][i], m[1][i], m[2][i]); };
  const glm::dvec3 w = row(3);
  const Bounds& bounds = primitive_->bounds;
  double nearest = m[3][3];
  for (int axis = 0; axis < 3; ++axis) nearest += std::min(w[axis] * bounds.min[axis], w[axis] * bounds.max[axis]);
  const double turn = glm::length(w);
  pixelsPerMetre_ = glm::dvec2(glm::length(row(0)) + turn, glm::length(row(1)) + turn) * glm::dvec2(size_) * 0.5 /
                    std::max(nearest, 0.0);
}

double FragmentEstimate::atMost(const Extent& extent) const {
  const glm::dvec2& scale = pixelsPerMetre_;
  const double most = extent.area * scale.x * scale.y + 2 * extent.diameters * (scale.x + scale.y);
  const auto parts = static_cast<double>(extent.parts);
  const double each = (size_.x + 2.0) * (size_.y + 2.0);
  // A bound must be a number.
  return most >= 0 ? std::min(most + parts * 4, parts * each) : parts * each;
}

double FragmentEstimate::of(std::size_t part) const {
  glm::vec4 corners[3];
  const std::size_t count = layout_.corners();
  if (count == 1) return 1;
  unsigned all = ~0u;
  bool front = true;
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = toClip_ * glm::vec4(cornerOf(*primitive_, layout_, part, i), 1);
    all &= outside(corners[i]);
    front = front && corners[i].w > 0;
  }
  if (all != 0) return 0;
  // It crosses the camera's plane, and its projection is unbounded.
  if (!front) return count > 2 ? static_cast<double>(size_.x) * size_.y : 2.0 * (size_.x + size_.y) + 4;
  glm::vec2 low(size_), high(0), at[3];
  for (std::size_t i = 0; i < count; ++i) {
    at[i] = (glm::vec2(corners[i]) / corners[i].w * 0.5f + 0.5f) * size_;
    low = glm::min(low, at[i]);
    high = glm::max(high, at[i]);
  }
  const glm::vec2 box = glm::max(glm::min(high, size_) - glm::max(low, glm::vec2(0)), glm::vec2(0));
  float area = 0;
  if (count > 2) {
    const glm::vec2 a = at[1] - at[0], b = at[2] - at[0];
    area = std::min(box.x * box.y, std::abs(a.x * b.y - a.y * b.x) * 0.5f);
  }
  // Pixels that a convex shape touches are lattice points in the shape made wider by a pixel, at most its area + half
  // its perimeter + 1. src: Nosarzewska 1948, "Evaluation de la difference entre l'aire d'une region plane convexe et
  // le nombre des points aux coordonnees entieres couverts par elle"
  const double touched = static_cast<double>(area) + 2.0 * (box.x + box.y) + 4;
  return std::min(touched, (std::floor(box.x) + 2.0) * (std::floor(box.y) + 2.0));
}

double FragmentEstimate::all(double enough) const {
  double sum = 0;
  for (std::size_t part = 0; part < layout_.parts && sum <= enough; ++part) sum += of(part);
  return sum;
}

double fragmentsOf(const FramePlan& plan, const Shot& shot, double enough, const CancelToken& cancel) {
  double sum = 0;
  forEachDraw(plan, shot, [&](const DrawItem& item, const View& view) {
    if (sum > enough) return;
    cancel.check();
    sum += fragmentsOf(item, view, enough - sum, cancel);
  });
  return sum;
}

void checkFragments(const FramePlan& plan, const Shot& shot, const ExtentsOf& extents, const Limits& limits,
                    const CancelToken& cancel) {
  const auto limit = static_cast<double>(limits.fragments);
  double most = 0;
  forEachDraw(plan, shot, [&](const DrawItem& item, const View& view) {
    cancel.check();
    most += mostFragmentsOf(item, view, extents(*item.primitive));
  });
  if (most > limit) checkSum("L_FRAGMENTS", limit, std::ceil(fragmentsOf(plan, shot, limit, cancel)));
}

}  // namespace telar::pass
