#include "checks.h"

namespace telar::numerics {

std::vector<Check> allChecks() {
  std::vector<Check> list;
  const auto ofEach = [&list](const char* topic, const char* name, auto run) {
    for (const ShadingPromise& shading : shadingPromises()) {
      list.push_back(
          {topic, std::string(name) + " " + shading.name, [=, &shading](Scale scale) { return run(shading, scale); }});
    }
  };
  ofEach("Every point", "grid", checkGrid);
  ofEach("Every point", "random", checkRandom);
  ofEach("GPU against double", "gpu", checkGpu);
  for (const ShadingPromise& shading : shadingPromises()) {
    if (!isPrincipled(shading.model)) continue;
    list.push_back({"GPU against double", std::string("gpu-terms ") + shading.name,
                    [&shading](Scale scale) { return checkGpuTerms(shading, scale); }});
  }
  ofEach("Reciprocity", "reciprocity", checkReciprocity);
  ofEach("White furnace", "furnace-direct", checkFurnaceDirect);
  ofEach("White furnace", "furnace-environment", checkFurnaceEnvironment);
  for (const ShadingPromise& shading : shadingPromises()) {
    if (!shading.weaves) continue;
    const std::string of = std::string(" ") + shading.name;
    list.push_back({"Woven cloth", "weaves" + of, [&shading](Scale scale) { return checkWeaves(shading, scale); }});
    list.push_back(
        {"Woven cloth", "weaves-drawn" + of, [&shading](Scale scale) { return checkWeavesDrawn(shading, scale); }});
  }
  ofEach("Smoothness", "monotone", checkMonotone);
  ofEach("Smoothness", "gradients", checkGradients);
  ofEach("Extremes, drawn", "extremes", checkExtremes);
  ofEach("Random materials, drawn", "fuzz", checkFuzz);
  list.push_back({"Normalisation", "distributions", checkDistributions});
  list.push_back({"Normalisation", "pdfs", checkPdfs});
  return list;
}

}  // namespace telar::numerics
