#pragma once
#include "gl/program.h"
#include "shader/variant_key.h"

namespace telar::pass {

struct SurfaceInputs;

/// Texture units of what surfaces read of an environment.
struct EnvironmentUnits {
  GLuint radiance, irradiance;
};

/// Uniforms of a program that is lit by an environment, prefiltered or sampled. The program is in use. An environment
/// that is not there gives no light.
void setEnvironment(const gl::Program& program, const shader::VariantKey& key, const SurfaceInputs& in,
                    const EnvironmentUnits& units);

}  // namespace telar::pass
