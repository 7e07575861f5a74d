#include "pass/surface/environment_uniforms.h"

#include <bit>
#include <vector>

#include "core/random.h"
#include "frame/sample_passes.h"
#include "pass/surface/surface_pass.h"

namespace telar::pass {
namespace {

/// @param rotation  of the environment, degrees
glm::mat3 viewToEnvironment(const frame::Camera& camera, double rotation) {
  return frame::environmentRotation(rotation) * glm::mat3(glm::transpose(glm::dmat3(camera.view)));
}

void setPrefilteredEnvironment(const gl::Program& program, const SurfaceInputs& in, const EnvironmentUnits& units) {
  program.set("environmentMap", static_cast<int>(units.radiance));
  if (in.environment && in.environment->atlas.faceSize > 0) {
    program.set("environmentMaxLod", static_cast<float>(in.environment->atlas.maxMip()));
    program.set("environmentAtlasTexel", in.environment->atlas.texel());
  } else {
    program.set("environmentMaxLod",
                in.environment ? static_cast<float>(ibl::maxLodOf(in.environment->prefiltered)) : 1.0f);
  }
  const double rotation = in.shot.environment.rotation;
  program.set("viewToEnvironment",
              viewToEnvironment(in.plan.camera, rotation - ibl::turnOfTexels(in.plan.frame.three, rotation)));
}

/// An order of the passes in which the first of them are spread evenly over all: bits reversed.
/// @param count  a power of two
int reversed(int pass, int count) {
  int out = 0;
  for (int bit = 1; bit < count; bit <<= 1, pass >>= 1) out = 2 * out + (pass & 1);
  return out;
}

/// The directions of the bright part for this pass. Those of one pass, of the first 2^k passes and of all passes are
/// each stratified.
void setBrightDirections(const gl::Program& program, const SurfaceInputs& in, int count, int passes) {
  const glm::mat3 toView = glm::mat3(glm::dmat3(in.plan.camera.view)) *
                           glm::transpose(frame::environmentRotation(in.shot.environment.rotation));
  std::vector<glm::vec3> directions;
  std::vector<glm::vec4> irradiances;
  const int first = reversed(in.samplePass, passes);
  for (const auto& bright : in.environment->bright.directions(count * passes, first, passes)) {
    directions.push_back(toView * bright.direction);
    irradiances.emplace_back(bright.irradiance * static_cast<float>(passes), bright.density);
  }
  program.set("brightCount", static_cast<int>(directions.size()));
  program.set("brightDirection", directions);
  program.set("brightIrradiance", irradiances);
  const double energy = in.environment->bright.energy();
  program.set("brightDensity", energy > 0 ? static_cast<float>(count * passes / energy) : 0.0f);
}

void setSampledEnvironment(const gl::Program& program, const shader::VariantKey& key, const SurfaceInputs& in,
                           const EnvironmentUnits& units) {
  program.set("environmentSource", static_cast<int>(units.radiance));
  program.set("environmentIrradianceMap", static_cast<int>(units.irradiance));
  program.set("environmentSourceSize", in.environment ? static_cast<float>(in.environment->radiance.size) : 1.0f);
  program.set("environmentIrradianceSize", in.environment ? static_cast<float>(in.environment->irradiance.size) : 1.0f);
  program.set("viewToEnvironment", viewToEnvironment(in.plan.camera, in.shot.environment.rotation));
  const int passes = frame::samplePassesOf(in.shot).count;
  const auto first = static_cast<std::uint32_t>(in.samplePass) * std::bit_ceil(unsigned{key.environmentSamples});
  program.set("environmentPoint", Random::sobolPoint(first));
  program.set("environmentPasses", passes);
  if (in.environment) setBrightDirections(program, in, key.brightDirections(), passes);
}

}  // namespace

void setEnvironment(const gl::Program& program, const shader::VariantKey& key, const SurfaceInputs& in,
                    const EnvironmentUnits& units) {
  program.set("environmentIntensity", in.environment ? static_cast<float>(in.shot.environment.intensity) : 0.0f);
  if (key.environmentSamples > 0) {
    setSampledEnvironment(program, key, in, units);
  } else {
    setPrefilteredEnvironment(program, in, units);
  }
}

}  // namespace telar::pass
