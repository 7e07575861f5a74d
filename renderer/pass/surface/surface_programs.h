#pragma once
#include "gl/program.h"
#include "shader/variant_key.h"

namespace telar::pass {

/// Of the program that runs the vertex stage for one that reads varyings from a map.
shader::VariantKey capturedKey(shader::VariantKey key);

/// @throws Error{X_SHADER}
gl::Program programOf(const gl::Context& context, const shader::VariantKey& key);

/// Cost of a fragment, in plain ones: each light, shadow and direction of the environment adds to it.
double weightOf(const shader::VariantKey& key);

}  // namespace telar::pass
