#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "flat/lines.h"

namespace telar::flat {
namespace {

/// Radians that a walk turns at most where several pieces go on.
constexpr double TURN_MAX = 1.0;
/// What a change of kind costs against a turn, radians.
constexpr double OTHER_KIND = 0.7;

class Walker {
 public:
  explicit Walker(const std::vector<Piece>& pieces) : pieces_(pieces), used_(pieces.size()) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      at_[pieces[i].from].push_back(i);
      at_[pieces[i].to].push_back(i);
    }
  }

  std::vector<Walk> all() {
    std::vector<std::uint32_t> order(pieces_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [this](auto p, auto q) { return pieces_[p].kind < pieces_[q].kind; });
    std::vector<Walk> walks;
    for (const std::uint32_t i : order) {
      if (used_[i]) continue;
      used_[i] = true;
      const Piece& piece = pieces_[i];
      Walk back{{piece.b, piece.a}, {piece.kind}, {static_cast<char>(piece.fold)}};
      extend(back, piece.from);
      std::reverse(back.points.begin(), back.points.end());
      std::reverse(back.kinds.begin(), back.kinds.end());
      std::reverse(back.folds.begin(), back.folds.end());
      extend(back, piece.to);
      walks.push_back(std::move(back));
    }
    return walks;
  }

 private:
  void extend(Walk& walk, std::uint32_t node) {
    while (true) {
      const glm::dvec2 end = walk.points.back(), direction = end - walk.points[walk.points.size() - 2];
      std::uint32_t best = surface::NONE, left = 0;
      double least = TURN_MAX;
      for (const std::uint32_t i : at_.at(node)) {
        if (used_[i]) continue;
        ++left;
        const double cost =
            turn(direction, far(i, node) - end) + (pieces_[i].kind == walk.kinds.back() ? 0 : OTHER_KIND);
        if (cost < least) least = cost, best = i;
      }
      if (best == surface::NONE && left == 1) {
        const auto only = std::find_if(at_.at(node).begin(), at_.at(node).end(), [this](auto i) { return !used_[i]; });
        if (pieces_[*only].kind == walk.kinds.back()) best = *only;
      }
      if (best == surface::NONE) return;
      used_[best] = true;
      walk.points.push_back(far(best, node));
      walk.kinds.push_back(pieces_[best].kind);
      walk.folds.push_back(static_cast<char>(pieces_[best].fold));
      node = pieces_[best].from == node ? pieces_[best].to : pieces_[best].from;
    }
  }

  glm::dvec2 far(std::uint32_t piece, std::uint32_t node) const {
    return pieces_[piece].from == node ? pieces_[piece].b : pieces_[piece].a;
  }
  static double turn(const glm::dvec2& u, const glm::dvec2& v) {
    return std::abs(std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v)));
  }

  const std::vector<Piece>& pieces_;
  std::vector<char> used_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_;
};

}  // namespace

std::vector<Walk> walksOf(const std::vector<Piece>& pieces) { return Walker(pieces).all(); }

}  // namespace telar::flat
