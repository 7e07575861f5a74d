#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "flat/flat.h"

namespace telar::test {

/// Pixels that are on.
struct Mask {
  int width = 0, height = 0;
  std::vector<char> on;
  Mask(int w, int h) : width(w), height(h), on(static_cast<std::size_t>(w * h)) {}
  char& at(int x, int y) { return on[static_cast<std::size_t>(y * width + x)]; }
  char at(int x, int y) const { return on[static_cast<std::size_t>(y * width + x)]; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

  std::size_t count() const { return static_cast<std::size_t>(std::count(on.begin(), on.end(), 1)); }
  /// Part of the pixels that have one of the other's within the distance.
  double near(const Mask& other, double distance) const {
    std::size_t all = 0, found = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!at(x, y)) continue;
        ++all;
        found += other.isNear(x, y, distance);
      }
    }
    return all == 0 ? 1 : static_cast<double>(found) / static_cast<double>(all);
  }
  bool isNear(int x, int y, double distance) const {
    const int reach = static_cast<int>(std::ceil(distance));
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        if (dx * dx + dy * dy <= distance * distance && inside(x + dx, y + dy) && at(x + dx, y + dy)) return true;
      }
    }
    return false;
  }
};

/// A z-buffer of its own: what flat::View knows it does not use.
struct Picture {
  int width, height;
  std::vector<double> depth;  ///< metres
  std::vector<int> part;      ///< source, -1 = background
  std::vector<glm::dvec3> normal;
  std::vector<glm::dvec2> slope;  ///< metres of depth a pixel

  Picture(const surface::Surface& surface, int w, int h, const std::function<glm::dvec3(const glm::dvec3&)>& project)
      : width(w),
        height(h),
        depth(static_cast<std::size_t>(w * h), 1e30),
        part(depth.size(), -1),
        normal(depth.size()),
        slope(depth.size()) {
    for (const surface::Face& face : surface.faces) {
      const glm::dvec3 a = project(surface.corner(face, 0)), b = project(surface.corner(face, 1)),
                       c = project(surface.corner(face, 2));
      const glm::dvec3 n = glm::cross(surface.corner(face, 1) - surface.corner(face, 0),
                                      surface.corner(face, 2) - surface.corner(face, 0));
      const auto side = [](const glm::dvec3& p, const glm::dvec3& q, double x, double y) {
        return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
      };
      const double area = side(a, b, c.x, c.y);
      if (area == 0) continue;
      const glm::dvec3 ab = b - a, ac = c - a;
      const glm::dvec2 rise = glm::dvec2(ab.z * ac.y - ac.z * ab.y, ac.z * ab.x - ab.z * ac.x) / area;
      const auto put = [&](int x, int y, double u, double v) {
        const auto i = static_cast<std::size_t>(y * w + x);
        const double z = u * a.z + v * b.z + (1 - u - v) * c.z;
        if (z >= depth[i]) return;
        depth[i] = z, part[i] = static_cast<int>(face.source), normal[i] = glm::length(n) > 0 ? glm::normalize(n) : n;
        slope[i] = rise;
      };
      for (int y = std::max(0, static_cast<int>(std::min({a.y, b.y, c.y})) - 1);
           y < std::min<double>(h, std::max({a.y, b.y, c.y}) + 1); ++y) {
        for (int x = std::max(0, static_cast<int>(std::min({a.x, b.x, c.x})) - 1);
             x < std::min<double>(w, std::max({a.x, b.x, c.x}) + 1); ++x) {
          const double u = side(b, c, x + 0.5, y + 0.5) / area, v = side(c, a, x + 0.5, y + 0.5) / area;
          if (u >= 0 && v >= 0 && u + v <= 1) put(x, y, u, v);
        }
      }
      // What is seen from its edge runs between the middles of pixels: its longest side is drawn.
      const std::array<std::array<glm::dvec3, 2>, 3> sides{{{a, b}, {b, c}, {c, a}}};
      std::size_t longest = 0;
      for (std::size_t k = 1; k < 3; ++k) {
        if (flatLength(sides[k]) > flatLength(sides[longest])) longest = k;
      }
      const double length = flatLength(sides[longest]);
      if (std::abs(area) > SLIVER * length) continue;
      const auto steps = static_cast<int>(std::ceil(4 * length));
      for (int s = 0; s <= steps; ++s) {
        const glm::dvec3 p = glm::mix(sides[longest][0], sides[longest][1], double{1} * s / std::max(1, steps));
        if (!(p.x >= 0 && p.y >= 0 && p.x < w && p.y < h)) continue;
        put(static_cast<int>(p.x), static_cast<int>(p.y), side(b, c, p.x, p.y) / area, side(c, a, p.x, p.y) / area);
      }
    }
  }

  /// Pixels across, below which a triangle is a sliver.
  static constexpr double SLIVER = 0.5;
  static double flatLength(const std::array<glm::dvec3, 2>& line) {
    return glm::distance(glm::dvec2(line[0]), glm::dvec2(line[1]));
  }

  /// Metres by which neither of two neighbours goes on into the other, however steep they are.
  double step(std::size_t i, std::size_t k) const {
    const bool below = k == i + static_cast<std::size_t>(width);
    const auto rise = [&](std::size_t at) { return below ? slope[at].y : slope[at].x; };
    const double whole = depth[k] - depth[i];
    return std::min({std::abs(whole), std::abs(whole - rise(i)), std::abs(whole - rise(k))});
  }

  /// Pixels at whose right or lower side `differs(i, k)`.
  Mask edges(const std::function<bool(std::size_t, std::size_t)>& differs) const {
    Mask mask(width, height);
    for (int y = 0; y + 1 < height; ++y) {
      for (int x = 0; x + 1 < width; ++x) {
        const auto i = static_cast<std::size_t>(y * width + x), down = i + static_cast<std::size_t>(width);
        if (differs(i, i + 1)) mask.at(x, y) = mask.at(x + 1, y) = 1;
        if (differs(i, down)) mask.at(x, y) = mask.at(x, y + 1) = 1;
      }
    }
    return mask;
  }
};

/// The pixels of the model beside the background.
inline Mask rimOf(const Picture& picture) {
  Mask rim(picture.width, picture.height);
  for (int y = 1; y + 1 < picture.height; ++y) {
    for (int x = 1; x + 1 < picture.width; ++x) {
      const auto i = static_cast<std::size_t>(y * picture.width + x), row = static_cast<std::size_t>(picture.width);
      const auto isBare = [&](std::size_t k) { return picture.part[k] < 0; };
      rim.at(x, y) = !isBare(i) && (isBare(i - 1) || isBare(i + 1) || isBare(i - row) || isBare(i + row));
    }
  }
  return rim;
}

/// Pixels that strokes of these kinds run through.
inline Mask drawn(const std::vector<flat::Stroke>& strokes, int width, int height,
                  const std::function<bool(flat::Kind)>& isMeant) {
  Mask mask(width, height);
  for (const flat::Stroke& stroke : strokes) {
    if (!isMeant(stroke.kind)) continue;
    const std::size_t count = stroke.points.size();
    for (std::size_t i = 1; i < count + (stroke.closed ? 1 : 0); ++i) {
      const glm::dvec2 a = stroke.points[i - 1], b = stroke.points[i % count];
      const int steps = std::max(1, static_cast<int>(glm::distance(a, b) * 3));
      for (int s = 0; s <= steps; ++s) {
        const glm::dvec2 p = glm::floor(glm::mix(a, b, double{1} * s / steps));
        if (mask.inside(static_cast<int>(p.x), static_cast<int>(p.y)))
          mask.at(static_cast<int>(p.x), static_cast<int>(p.y)) = 1;
      }
    }
  }
  return mask;
}

/// Longest run of pixels of `line` that none of `strokes` is within the distance of: the widest gap.
inline int widestGap(const Mask& line, const Mask& strokes, double distance) {
  Mask missing(line.width, line.height);
  for (int y = 0; y < line.height; ++y) {
    for (int x = 0; x < line.width; ++x) missing.at(x, y) = line.at(x, y) && !strokes.isNear(x, y, distance);
  }
  int widest = 0;
  for (int y = 0; y < line.height; ++y) {
    for (int x = 0; x < line.width; ++x) {
      if (!missing.at(x, y)) continue;
      // The extent of what hangs together.
      std::vector<glm::ivec2> todo{{x, y}};
      missing.at(x, y) = 0;
      glm::ivec2 min(x, y), max(x, y);
      while (!todo.empty()) {
        const glm::ivec2 p = todo.back();
        todo.pop_back();
        min = glm::min(min, p), max = glm::max(max, p);
        for (int k = 0; k < 9; ++k) {
          const glm::ivec2 q = p + glm::ivec2(k % 3 - 1, k / 3 - 1);
          if (!missing.inside(q.x, q.y) || !missing.at(q.x, q.y)) continue;
          missing.at(q.x, q.y) = 0;
          todo.push_back(q);
        }
      }
      widest = std::max(widest, std::max(max.x - min.x, max.y - min.y) + 1);
    }
  }
  return widest;
}

}  // namespace telar::test
