#include "flat/ink.h"

#include <algorithm>
#include <cmath>

#include "telar/shot/flat_dash.inc"

namespace telar::flat {
namespace {

/// Points every so often along a polyline: where dashes begin and end.
struct Dashes {
  const std::vector<glm::dvec2>& points;
  std::size_t at = 0;
  double along = 0;  ///< of the piece from points[at]

  /// The pieces of the next `length`, each given to `visit`. @return false: the line has ended
  template <class Visit>
  bool advance(double length, const Visit& visit) {
    while (at + 1 < points.size()) {
      const glm::dvec2 &a = points[at], &b = points[at + 1];
      const double whole = glm::distance(a, b), left = whole - along;
      const auto place = [&](double d) { return whole > 0 ? glm::mix(a, b, d / whole) : a; };
      if (length < left) {
        visit(place(along), place(along + length));
        along += length;
        return true;
      }
      visit(place(along), b);
      length -= left;
      along = 0;
      ++at;
    }
    return false;
  }
};

}  // namespace

void Paper::segment(const glm::dvec2& a, const glm::dvec2& b, double weight, bool round) {
  const double reach = weight / 2 + 1;
  const glm::dvec2 low = glm::min(a, b) - reach, high = glm::max(a, b) + reach;
  const int x0 = std::max(0, static_cast<int>(std::floor(low.x))),
            y0 = std::max(0, static_cast<int>(std::floor(low.y)));
  const int x1 = std::min(width_ - 1, static_cast<int>(std::ceil(high.x)));
  const int y1 = std::min(height_ - 1, static_cast<int>(std::ceil(high.y)));
  const glm::dvec2 d = b - a;
  const double length2 = glm::dot(d, d), length = std::sqrt(length2);
  const auto overlap = [](double centre, double low1, double high1) {
    return std::clamp(std::min(centre + 0.5, high1) - std::max(centre - 0.5, low1), 0.0, 1.0);
  };
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const glm::dvec2 p = glm::dvec2(x, y) + 0.5 - a;
      const double t = length2 > 0 ? glm::dot(p, d) / length2 : 0;
      double covered = 0;
      if (round || length == 0) {
        covered = overlap(glm::distance(p, d * std::clamp(t, 0.0, 1.0)), -weight / 2, weight / 2);
      } else {
        const double across = glm::distance(p, d * t);
        covered = overlap(across, -weight / 2, weight / 2) * overlap(t * length, 0, length);
      }
      float& ink = ink_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
      ink = std::max(ink, static_cast<float>(covered));
    }
  }
}

void Paper::draw(const Stroke& stroke, double weight) {
  if (weight <= 0 || stroke.points.empty()) return;
  std::vector<glm::dvec2> points = stroke.points;
  if (stroke.closed) points.push_back(points.front());
  Dashes dashes{points};
  if (stroke.kind != Kind::kStitch) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) segment(points[i], points[i + 1], weight, true);
    return;
  }
  bool goes = true;
  while (goes) {
    goes = dashes.advance(shot::FLAT_DASH * weight,
                          [&](const glm::dvec2& a, const glm::dvec2& b) { segment(a, b, weight, false); });
    goes = goes && dashes.advance(shot::FLAT_GAP * weight, [](const glm::dvec2&, const glm::dvec2&) {});
  }
}

std::vector<float> Paper::brightness() const {
  std::vector<float> bright(ink_.size());
  std::transform(ink_.begin(), ink_.end(), bright.begin(), [](float ink) { return 1 - ink; });
  return bright;
}

}  // namespace telar::flat
