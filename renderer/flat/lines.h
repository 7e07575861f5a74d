#pragma once
#include "flat/flat.h"

namespace telar::flat {

double lengthOf(const std::vector<glm::dvec2>& points);

/// Walks over pieces that meet, as straight as they go; the kinds are those of the pieces.
struct Walk {
  std::vector<glm::dvec2> points;
  std::vector<Kind> kinds;  ///< of the piece from points[i] to points[i + 1]
  std::vector<char> folds;  ///< of that piece
};
std::vector<Walk> walksOf(const std::vector<Piece>& pieces);

/// Joins open strokes of one kind whose ends are near and go on into one another; closes those that end where they
/// begin.
/// @throws Error{X_CANCELLED, X_TIMEOUT}
void closeGaps(std::vector<Stroke>& strokes, const CancelToken& cancel);

/// Leaves out what lies on a more important stroke, or on a longer one of the same kind.
std::vector<Stroke> withoutDoubles(std::vector<Stroke> strokes, const CancelToken& cancel);

/// Fewest points such that none that is left out is farther from the line than the tolerance (Ramer 1972; Douglas and
/// Peucker 1973).
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points, double tolerance, bool closed);

}  // namespace telar::flat
