#include "flat/lines.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace telar::flat {
namespace {

/// Pixels over which ends are joined.
constexpr double GAP = 3;
/// Cosine of the angle by which a joined stroke may bend there.
constexpr double GOES_ON = 0.5;
/// Pixels within which a line is a double of another.
constexpr double DOUBLE = 1;
/// Most ends that are looked at about one. Where more lie together no eye tells which line goes on, and the time would
/// grow with the square of their number.
constexpr std::size_t ENDS_LOOKED_AT = 1024;
constexpr std::size_t STROKES_PER_CANCEL_CHECK = 256;

std::uint64_t cellOf(const glm::dvec2& p, double size, int dx = 0, int dy = 0) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x / size)) + dx,
             y = static_cast<std::int64_t>(std::floor(p.y / size)) + dy;
  return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
}

/// Points by place.
template <class Value>
class PlaceMap {
 public:
  explicit PlaceMap(double size) : size_(size) {}
  void add(const glm::dvec2& p, const Value& value) { cells_[cellOf(p, size_)].push_back({p, value}); }
  /// Those within the size of p, until `visit` returns false.
  template <class Visit>
  void near(const glm::dvec2& p, const Visit& visit) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto cell = cells_.find(cellOf(p, size_, dx, dy));
        if (cell == cells_.end()) continue;
        for (const auto& [q, value] : cell->second) {
          if (glm::distance(p, q) <= size_ && !visit(q, value)) return;
        }
      }
    }
  }

 private:
  double size_;
  std::unordered_map<std::uint64_t, std::vector<std::pair<glm::dvec2, Value>>> cells_;
};

/// Direction in which a stroke leaves at one of its ends, over some pixels: single pieces may be crooked.
glm::dvec2 leaving(const std::vector<glm::dvec2>& points, bool atFront) {
  constexpr double LOOK_BACK = 4;
  const std::size_t last = points.size() - 1;
  const glm::dvec2 end = atFront ? points.front() : points.back();
  std::size_t back = 1;
  while (back < last && glm::distance(points[atFront ? back : last - back], end) < LOOK_BACK) ++back;
  back = std::min(back, last);
  const glm::dvec2 direction = end - points[atFront ? back : last - back];
  const double length = glm::length(direction);
  return length > 0 ? direction / length : glm::dvec2(0);
}

struct End {
  std::size_t stroke;
  bool front;
};

/// The other stroke's end that goes on from this one's back.
std::optional<End> continuation(const std::vector<Stroke>& strokes, const PlaceMap<End>& ends, std::size_t self) {
  const Stroke& stroke = strokes[self];
  const glm::dvec2 direction = leaving(stroke.points, false);
  std::size_t looked = 0;
  std::optional<End> best;
  double least = std::numeric_limits<double>::infinity();
  ends.near(stroke.points.back(), [&](const glm::dvec2& p, const End& end) {
    const Stroke& other = strokes[end.stroke];
    const bool goesOn = ++looked < ENDS_LOOKED_AT;
    if (end.stroke == self || other.closed || other.points.empty() || other.kind != stroke.kind) return goesOn;
    if (p != (end.front ? other.points.front() : other.points.back())) return goesOn;  // joined meanwhile
    const double bend = glm::dot(direction, -leaving(other.points, end.front));
    const double distance = glm::distance(p, stroke.points.back());
    if (bend < GOES_ON || distance >= least) return goesOn;
    least = distance;
    best = end;
    return goesOn;
  });
  return best;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const double length2 = glm::dot(b - a, b - a);
  const double part = length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(p, glm::mix(a, b, part));
}

}  // namespace

double lengthOf(const std::vector<glm::dvec2>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
  return sum;
}

void closeGaps(std::vector<Stroke>& strokes, const CancelToken& cancel) {
  PlaceMap<End> ends(GAP);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    ends.add(strokes[i].points.front(), {i, true});
    ends.add(strokes[i].points.back(), {i, false});
  }
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (i % STROKES_PER_CANCEL_CHECK == 0) cancel.check();
    Stroke& stroke = strokes[i];
    for (int side = 0; side < 2 && !stroke.points.empty(); ++side) {
      while (const auto next = continuation(strokes, ends, i)) {
        cancel.check();
        std::vector<glm::dvec2>& points = strokes[next->stroke].points;
        if (!next->front) std::reverse(points.begin(), points.end());
        stroke.points.insert(stroke.points.end(), points.begin(), points.end());
        stroke.fold = stroke.fold && strokes[next->stroke].fold;
        points.clear();
        ends.add(stroke.points.back(), {i, false});
      }
      std::reverse(stroke.points.begin(), stroke.points.end());
      ends.add(stroke.points.back(), {i, false});
      ends.add(stroke.points.front(), {i, true});
    }
    if (stroke.points.size() > 3 && glm::distance(stroke.points.front(), stroke.points.back()) <= GAP &&
        lengthOf(stroke.points) > 4 * GAP) {
      stroke.closed = true;
      if (stroke.points.front() == stroke.points.back()) stroke.points.pop_back();
    }
  }
  std::erase_if(strokes, [](const Stroke& stroke) { return stroke.points.size() < 2; });
}

std::vector<Stroke> withoutDoubles(std::vector<Stroke> strokes, const CancelToken& cancel) {
  std::stable_sort(strokes.begin(), strokes.end(), [](const Stroke& p, const Stroke& q) {
    return p.kind != q.kind ? p.kind < q.kind : lengthOf(p.points) > lengthOf(q.points);
  });
  constexpr double STEP = 0.75;  // pixels
  PlaceMap<char> drawn(DOUBLE);
  std::vector<Stroke> out;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (i % STROKES_PER_CANCEL_CHECK == 0) cancel.check();
    const Stroke& stroke = strokes[i];
    std::vector<glm::dvec2> dense{stroke.points.front()};
    const std::size_t count = stroke.points.size();
    for (std::size_t k = 1; k < count + (stroke.closed ? 1 : 0); ++k) {
      const glm::dvec2 a = stroke.points[k - 1], b = stroke.points[k % count];
      const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / STEP)));
      for (int s = 1; s <= steps; ++s) dense.push_back(glm::mix(a, b, double{1} * s / steps));
    }
    Stroke piece{stroke.kind, stroke.fold, stroke.closed, {}};
    const auto end = [&] {
      if (piece.points.size() > 1) out.push_back(piece);
      piece.points.clear();
      piece.closed = false;
    };
    std::vector<char> isDouble(dense.size());
    for (std::size_t k = 0; k < dense.size(); ++k)
      drawn.near(dense[k], [&](const glm::dvec2&, char) {
        isDouble[k] = 1;
        return false;
      });
    // A line goes on to the one that it meets, at both its ends, so that no gap is seen between them.
    constexpr std::size_t REACH = 2;
    for (std::size_t k = 0; k < dense.size(); ++k) {
      bool meets = false;
      for (std::size_t n = k - std::min(k, REACH); n <= std::min(k + REACH, dense.size() - 1); ++n)
        meets |= !isDouble[n];
      if (isDouble[k]) piece.closed = false;
      if (meets) piece.points.push_back(dense[k]);
      if (!meets) end();
    }
    end();
    for (const glm::dvec2& p : dense) drawn.add(p, 1);
  }
  return out;
}

std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points, double tolerance, bool closed) {
  std::vector<glm::dvec2> line = points;
  if (closed) line.push_back(points.front());
  std::vector<char> kept(line.size());
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  const auto keep = [&](std::size_t i) { kept[i] = 1; };
  keep(0), keep(line.size() - 1);
  if (closed) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (glm::distance(line[i], line[0]) > glm::distance(line[farthest], line[0])) farthest = i;
    }
    keep(farthest);
    spans = {{0, farthest}, {farthest, line.size() - 1}};
  } else {
    spans = {{0, line.size() - 1}};
  }
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    std::size_t farthest = from;
    double most = tolerance;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = distanceToSegment(line[i], line[from], line[to]);
      if (distance > most) most = distance, farthest = i;
    }
    if (farthest == from) continue;
    keep(farthest);
    spans.emplace_back(from, farthest);
    spans.emplace_back(farthest, to);
  }
  std::vector<glm::dvec2> out;
  for (std::size_t i = 0; i + (closed ? 1 : 0) < line.size(); ++i) {
    if (kept[i]) out.push_back(line[i]);
  }
  return out;
}

}  // namespace telar::flat
