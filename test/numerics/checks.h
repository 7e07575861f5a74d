#pragma once
#include "check.h"
#include "shadings.h"

/// Each check of one shading, and those of no shading.
namespace telar::numerics {

std::vector<Figure> checkGrid(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkRandom(const ShadingPromise& shading, Scale scale);
/// The shader on the GPU against the double-precision text.
std::vector<Figure> checkGpu(const ShadingPromise& shading, Scale scale);
/// The same with each term of a principled shading swapped alone.
std::vector<Figure> checkGpuTerms(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkReciprocity(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkFurnaceDirect(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkFurnaceEnvironment(const ShadingPromise& shading, Scale scale);
/// Woven cloth of any yarns from any side: under lights and under the environment, in double.
std::vector<Figure> checkWeaves(const ShadingPromise& shading, Scale scale);
/// Some of them drawn, with the prefiltered environment and with directions of it.
std::vector<Figure> checkWeavesDrawn(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkMonotone(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkGradients(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkFuzz(const ShadingPromise& shading, Scale scale);
/// Every extreme of light, surface and view, drawn.
std::vector<Figure> checkExtremes(const ShadingPromise& shading, Scale scale);
std::vector<Figure> checkDistributions(Scale scale);
std::vector<Figure> checkPdfs(Scale scale);

}  // namespace telar::numerics
