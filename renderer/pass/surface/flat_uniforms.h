#pragma once
#include <string>

namespace telar::pass {

/// A program of few vertices.
struct StageTexts {
  std::string vertex, fragment;
};

/// The same program whose vertex stage hands the uniforms of the fragments on, as flat varyings: llvmpipe (Mesa 22.3)
/// loads a uniform lane by lane, some 25 instructions a float, and a flat varying by one. Arrays, 4 x 4 matrices and
/// what goes beyond MOST_HANDED floats stay uniforms of the fragments. gl::Program::set() finds each by its name.
/// @param texts  the vertex stage begins with its #version line
StageTexts withFlatUniforms(StageTexts texts);

/// Floats: 28 of the 31 vectors that GLs have.
constexpr int MOST_HANDED = 112;

}  // namespace telar::pass
