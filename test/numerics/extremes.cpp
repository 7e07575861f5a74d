// Every extreme of light, surface and view, drawn.
#include "checks.h"
#include "extreme_rows.h"

namespace telar::numerics {

std::vector<Figure> checkExtremes(const ShadingPromise& shading, Scale scale) {
  const auto renderer = makeRenderer();
  const auto shadings = shadingPromises().size(), own = static_cast<std::size_t>(shading.model);
  std::vector<Figure> out;
  std::size_t index = 0;
  for (ExtremeRow& row : extremeRows(shading.model)) {
    // The tests draw each row with one shading.
    if (scale != Scale::kFull && index++ % shadings != own % shadings) continue;
    const Frame shown = drawn(*renderer, row.scene, row.shot, row.environment);
    const BadPixels picture = badPixels(shown);
    row.shot.debugOutput = DebugOutput::kLinear;
    const BadPixels raw = badPixels(drawn(*renderer, row.scene, row.shot, row.environment));
    const std::uint64_t bad = picture.notFinite + picture.negative + raw.notFinite;
    out.push_back({row.name + ": pixels not finite or negative", shading.name, static_cast<double>(bad), 0, -NO_BAR,
                   shown.width * shown.height,
                   bad ? "pixel " + std::to_string(raw.notFinite ? raw.first : picture.first) : "",
                   shown.width * shown.height});
    if (row.measure)
      out.push_back({row.name + ": largest value", shading.name, row.measure(shown), row.high, row.low,
                     shown.width * shown.height, "", shown.width * shown.height});
  }
  return out;
}

}  // namespace telar::numerics
