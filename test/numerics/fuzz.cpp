// Random materials in random light, drawn: no pixel may be NaN, infinite or negative.
#include <algorithm>

#include "checks.h"
#include "frames.h"
#include "fuzz_scene.h"

namespace telar::numerics {
namespace {

struct Tally {
  std::uint64_t materials = 0, pictured = 0, covered = 0, notFinite = 0, negative = 0;
  std::string notFiniteAt, negativeAt;
};

std::string placeOf(const FuzzFrame& frame, std::uint64_t seed, std::size_t pixel) {
  return "frame " + std::to_string(seed) + ", pixel " + std::to_string(pixel) + ": " +
         describe(frame.materialAt(pixel));
}

/// Radiance before anything caps it must be finite; the picture must be neither negative nor infinite.
void drawFrame(Renderer& renderer, std::uint64_t seed, ShadingModel shading, bool picture, Tally& tally) {
  FuzzFrame frame(seed, shading);
  const BadPixels raw = badPixels(drawn(renderer, frame.scene, frame.shot, frame.environment));
  tally.materials += FuzzFrame::MATERIALS;
  tally.covered += raw.covered;
  if (raw.notFinite > 0 && tally.notFinite == 0) {
    tally.notFiniteAt = placeOf(frame, seed, raw.first);
  }
  tally.notFinite += raw.notFinite;
  if (!picture) return;
  tally.pictured += FuzzFrame::MATERIALS;
  frame.shot.debugOutput = DebugOutput::kNone;
  const BadPixels shown = badPixels(drawn(renderer, frame.scene, frame.shot, frame.environment));
  if (shown.notFinite + shown.negative > 0 && tally.negative == 0) tally.negativeAt = placeOf(frame, seed, shown.first);
  tally.negative += shown.notFinite + shown.negative;
}

}  // namespace

std::vector<Figure> checkFuzz(const ShadingPromise& shading, Scale scale) {
  const auto count = static_cast<std::uint64_t>(shadingPromises().size());  // each draws frames of its own
  constexpr std::uint64_t FULL = 176;
  const std::uint64_t frames = countOf(scale, 4, FULL) / count, materials = FULL / count * FuzzFrame::MATERIALS;
  const auto renderer = makeRenderer();
  Tally tally;
  for (std::uint64_t i = 0; i < frames; ++i)
    drawFrame(*renderer, i * count + static_cast<std::uint64_t>(shading.model), shading.model, i % 4 == 0, tally);
  return {{"pixels of random materials whose radiance is not finite", shading.name,
           static_cast<double>(tally.notFinite), 0, -NO_BAR, tally.materials, tally.notFiniteAt, materials},
          {"pixels of their pictures that are negative or not finite", shading.name,
           static_cast<double>(tally.negative), 0, -NO_BAR, tally.pictured, tally.negativeAt, materials / 4},
          {"pixels that they cover", shading.name, static_cast<double>(tally.covered), NO_BAR, 1, tally.materials, "",
           materials}};
}

}  // namespace telar::numerics
