#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "flat/view.h"

namespace telar::flat {

/// What a line of a technical flat stands for, the most important first: where two lie on one another, the first stays.
enum class Kind { kSilhouette, kContour, kSeam, kStitch, kCrease };
constexpr std::array<std::string_view, 5> KIND_NAMES{"silhouette", "contour", "seam", "stitch", "crease"};

struct FlatOptions {
  double creaseAngle = 60;       ///< degrees between the normals of two faces
  double foldDepth = 0;          ///< metres: a surface that lies less before another is a fold that is not drawn
  double foldLength = 0;         ///< pixels: contours and creases within one part that are shorter are not drawn
  double tolerance = 0.3;        ///< pixels that a simplified line may leave the exact one
  std::vector<char> stitched{};  ///< by source: its seams are stitches
};

struct Stroke {
  Kind kind = Kind::kSilhouette;
  bool fold = false;  ///< where short, it is none: of one part by itself, and no silhouette
  bool closed = false;
  std::vector<glm::dvec2> points;  ///< pixels
};

/// A visible piece of an edge.
struct Piece {
  Kind kind;
  bool fold;               ///< of one part by itself
  std::uint32_t from, to;  ///< nodes: pieces that meet have one in common
  glm::dvec2 a, b;         ///< pixels
};

/// The edges of a surface that a flat shows, without what is hidden.
/// @throws Error{X_CANCELLED, X_TIMEOUT}
std::vector<Piece> visiblePieces(const surface::Surface& surface, const View& view, const FlatOptions& options,
                                 const CancelToken& cancel);

/// Pieces to long lines: chained over small gaps, kinds that flicker made one, doubles left out, simplified.
std::vector<Stroke> strokesOf(const std::vector<Piece>& pieces, const FlatOptions& options, const CancelToken& cancel);

}  // namespace telar::flat
