#include "pass/surface/surface_programs.h"

#include "pass/plan/varyings.h"
#include "pass/surface/flat_uniforms.h"
#include "shader/library.h"

namespace telar::pass {
namespace {

std::string labelOf(const shader::VariantKey& key) {
  std::string label = "surface";
  for (const std::string& feature : key.features()) label += " " + feature;
  return label;
}

}  // namespace

double weightOf(const shader::VariantKey& key) {
  const shader::LightCounts& lights = key.lights;
  const int all = lights.point + lights.spot + lights.directional + lights.hemisphere + 4 * lights.area();
  return 1 + all * 0.25 + lights.shadows() * 0.5 + key.environmentSamples * 0.5;
}

shader::VariantKey capturedKey(shader::VariantKey key) {
  key.visibilityBuffer = false;
  key.captured = true;
  return key;
}

gl::Program programOf(const gl::Context& context, const shader::VariantKey& key) {
  shader::Defines defines = key.defines();
  defines.emplace_back("SAMPLE_MASK", context.capabilities().sampleMask);
  if (key.captured) {
    std::vector<std::string> outputs{"gl_Position"};
    for (const Varying& varying : varyingsOf(key)) outputs.push_back(varying.name);
    return gl::Program(context, labelOf(key), shader::assemble("surface.vert", defines),
                       "#version 300 es\nvoid main() {}\n", outputs);
  }
  if (key.visibilityBuffer) {
    StageTexts texts = withFlatUniforms(
        {shader::assemble("visibility/whole.vert", {}), withVaryings(shader::assemble("surface.frag", defines), key)});
    for (std::string* text : {&texts.vertex, &texts.fragment}) text->replace(0, text->find('\n'), "#version 320 es");
    return gl::Program(context, labelOf(key), texts.vertex, texts.fragment);
  }
  return gl::Program(context, labelOf(key), shader::assemble("surface.vert", defines),
                     shader::assemble(key.layers ? "layers/layers.frag" : "surface.frag", defines));
}

}  // namespace telar::pass
