#include "flat/lines.h"

namespace telar::flat {
namespace {

/// Pixels: a run of another kind within a line that is shorter is rounding at its sides, and takes the kind before it.
constexpr double RUN = 4;
/// Pixels: what is shorter is no line.
constexpr double SPECK = 3;

struct Run {
  Kind kind;
  std::size_t begin, end;  ///< pieces of the walk
  double length, folded = 0;
};

std::vector<Run> runsOf(const Walk& walk) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < walk.kinds.size(); ++i) {
    const double length = glm::distance(walk.points[i], walk.points[i + 1]);
    if (runs.empty() || runs.back().kind != walk.kinds[i]) runs.push_back({walk.kinds[i], i, i, 0});
    runs.back().end = i + 1;
    runs.back().length += length;
    if (walk.folds[i]) runs.back().folded += length;
  }
  return runs;
}

/// One kind where kinds flicker.
void settleKinds(Walk& walk) {
  const std::vector<Run> runs = runsOf(walk);
  for (std::size_t i = 0; i < runs.size() && runs.size() > 1; ++i) {
    if (runs[i].length >= RUN) continue;
    const Run& other = i == 0 ? runs[1] : runs[i - 1];
    for (std::size_t k = runs[i].begin; k < runs[i].end; ++k)
      walk.kinds[k] = walk.kinds[i == 0 ? other.begin : other.end - 1];
  }
}

double wholeLength(const Stroke& stroke) {
  return lengthOf(stroke.points) + (stroke.closed ? glm::distance(stroke.points.front(), stroke.points.back()) : 0);
}

double leastLength(const Stroke& stroke, const FlatOptions& options) {
  if (stroke.kind == Kind::kSilhouette) return SPECK;
  return std::max(SPECK, stroke.fold ? options.foldLength : options.foldLength / 4);
}

void dropShort(std::vector<Stroke>& strokes, const FlatOptions& options) {
  std::erase_if(strokes, [&](const Stroke& stroke) { return wholeLength(stroke) < leastLength(stroke, options); });
}

}  // namespace

std::vector<Stroke> strokesOf(const std::vector<Piece>& pieces, const FlatOptions& options, const CancelToken& cancel) {
  std::vector<Stroke> strokes;
  for (Walk& walk : walksOf(pieces)) {
    settleKinds(walk);
    for (const Run& run : runsOf(walk)) {
      strokes.push_back({run.kind,
                         2 * run.folded > run.length,
                         false,
                         {walk.points.begin() + static_cast<std::ptrdiff_t>(run.begin),
                          walk.points.begin() + static_cast<std::ptrdiff_t>(run.end) + 1}});
    }
  }
  cancel.check();
  closeGaps(strokes, cancel);
  dropShort(strokes, options);
  strokes = withoutDoubles(std::move(strokes), cancel);
  closeGaps(strokes, cancel);
  dropShort(strokes, options);
  for (Stroke& stroke : strokes) stroke.points = simplified(stroke.points, options.tolerance, stroke.closed);
  return strokes;
}

}  // namespace telar::flat
