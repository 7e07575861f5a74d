#include "ibl/atlas_prefilter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "ibl/cube.h"
#include "shader/library.h"

namespace telar::ibl {
namespace {

constexpr int TAPS = 20;  // of environment/atlas_blur.frag
constexpr double TAP_DEVIATIONS = 3;
constexpr int SAMPLE_BITS = 8;  // log2 of the samples of the GGX chain
constexpr double SAMPLES = 1 << SAMPLE_BITS;

/// Names: a term's number moves when there is a newer one.
struct Names {
#define TELAR_TERM_NAMES(define, member, ...) \
  [[maybe_unused]] static constexpr std::string_view member[] = {__VA_ARGS__};
  TELAR_THREE_SLOTS(TELAR_TERM_NAMES)
#undef TELAR_TERM_NAMES
};

/// Standard deviation of the levels of the least size but the first, rad: after the GGX lobe.
constexpr double ROUGHER_SIGMA[] = {0.125, 0.215, 0.35, 0.446, 0.526, 0.582};

/// An axis through each pair of opposite corners of a dodecahedron: they spread evenly.
const glm::dvec3& poleOf(int number) {
  constexpr double P = std::numbers::phi, Q = 1 / P;
  static const std::array<glm::dvec3, 10> poles{{{1, 1, 1},
                                                 {-1, 1, 1},
                                                 {1, 1, -1},
                                                 {-1, 1, -1},
                                                 {0, P, Q},
                                                 {0, P, -Q},
                                                 {Q, 0, P},
                                                 {-Q, 0, P},
                                                 {P, Q, 0},
                                                 {-P, Q, 0}}};
  return poles[static_cast<std::size_t>(number) % poles.size()];
}

/// Two atlases, of which a pass reads one and draws the other, and what every pass shares.
class Chain {
 public:
  Chain(const gl::Context& context, const ImageF& map, const ThreeTerms& three, const CancelToken& cancel)
      : context_(context),
        three_(three),
        cancel_(cancel),
        result_(createAtlas(context, static_cast<int>(std::bit_floor(std::max(map.width / 4, 1u))))),
        between_(createAtlas(context, result_.faceSize)) {
    drawSharpest(map);
  }

  void blur() {
    const gl::Program program = compile("environment/atlas_blur.frag");
    gl::DrawCost cost(TAPS / 16.0);
    start(program);
    const bool fromEnd = three_.prefilter == ThreeTerms::THREE_PREFILTER_BLUR_FROM_END;
    constexpr int POLES = 10;
    for (int level = 1; level < result_.levels(); ++level) {
      const double before = sigmaOf(level - 1), sigma = sigmaOf(level);
      // The list read from its end, beginning where the last level takes the end's first.
      const int number = fromEnd ? POLES - 1 - (result_.levels() - level - 1) % POLES : level - 1;
      program.set("pole", glm::vec3(poleOf(number)));
      const double added = std::sqrt(sigma * sigma - before * before);
      blurPass(program, cost, {result_, level - 1}, {between_, level}, added, true);
      blurPass(program, cost, {between_, level}, {result_, level}, added, false);
    }
  }

  void reflect() {
    const gl::Program program = compile("environment/atlas_ggx.frag");
    gl::DrawCost cost(SAMPLES / 16), copyCost;
    start(program);
    const double last = result_.levels() - 1;
    for (int level = 1; level < result_.levels(); ++level) {
      const double r = level / last, before = (level - 1) / last;
      // Less than the lobes' widths ask for: the reads between two levels widen them too.
      const double width = three_.prefilter == ThreeTerms::THREE_PREFILTER_GGX_CHAIN_FLOOR ? 0.05 + r * 0.95 : r * 1.25;
      program.set("perceptualRoughness", static_cast<float>(std::sqrt(r * r - before * before) * width));
      pass(program, cost, {result_, level - 1}, {between_, level});
      program.set("perceptualRoughness", 0.0f);
      pass(program, copyCost, {between_, level}, {result_, level});
    }
  }

  Atlas take() { return std::move(result_); }

 private:
  struct Level {
    const Atlas& atlas;
    int number;
  };

  gl::Program compile(const char* fragment) const {
    const shader::Defines defines{{"THREE_PREFILTER_TERM", three_.prefilter},
                                  {"THREE_SAMPLER_PRECISION_TERM", three_.samplerPrecision},
                                  {"SAMPLE_BITS", SAMPLE_BITS}};
    return {context_, fragment, shader::assemble("environment/atlas_tiles.vert", defines),
            shader::assemble(fragment, defines)};
  }

  void drawSharpest(const ImageF& map) {
    const gl::Functions& gl = context_.gl();
    const gl::Program program = compile("environment/atlas_sharpest.frag");
    program.use();
    program.set("equirectMap", 0);
    gl.ActiveTexture(GL_TEXTURE0);
    const gl::Texture equirect = uploadEquirect(gl, map);
    gl::DrawCost cost;
    renderTiles(context_, cost, result_, 0, cancel_);
  }

  void start(const gl::Program& program) const {
    program.use();
    program.set("sourceAtlas", 0);
    program.set("atlasTexel", result_.texel());
    program.set("atlasMaxMip", static_cast<float>(result_.maxMip()));
  }

  double sigmaOf(int level) const {
    const int rougher = result_.levels() - static_cast<int>(std::size(ROUGHER_SIGMA));
    if (level >= rougher) return ROUGHER_SIGMA[level - rougher];
    return level == 0 ? 0 : 1.0 / result_.edgeOf(level);
  }

  void blurPass(const gl::Program& program, gl::DrawCost& cost, Level from, Level to, double sigma,
                bool aroundPole) const {
    const double step = std::numbers::pi / (2 * (result_.edgeOf(from.number) - 1)), deviation = sigma / step;
    const int count = std::min(1 + static_cast<int>(TAP_DEVIATIONS * deviation), TAPS);
    std::vector<double> gauss(TAPS);
    double sum = 0;
    for (int tap = 0; tap < TAPS; ++tap) {
      const double x = tap / deviation;
      gauss[static_cast<std::size_t>(tap)] = std::exp(-x * x / 2);
      if (tap < count) sum += gauss[static_cast<std::size_t>(tap)] * (tap == 0 ? 1 : 2);
    }
    std::vector<float> weights;
    weights.reserve(gauss.size());
    for (const double weight : gauss) weights.push_back(static_cast<float>(weight / sum));
    program.set("tapWeight", std::span<const float>(weights));
    program.set("tapCount", count);
    program.set("tapStep", static_cast<float>(step));
    program.set("aroundPole", aroundPole ? 1 : 0);
    pass(program, cost, from, to);
  }

  void pass(const gl::Program& program, gl::DrawCost& cost, Level from, Level to) const {
    const gl::Functions& gl = context_.gl();
    program.set("sourceMip", static_cast<float>(from.atlas.mipOf(from.number)));
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, from.atlas.texture.get());
    renderTiles(context_, cost, to.atlas, to.number, cancel_);
  }

  const gl::Context& context_;
  const ThreeTerms& three_;
  const CancelToken& cancel_;
  Atlas result_, between_;
};

}  // namespace

std::string atlasName(const ThreeTerms& three) {
  const auto at = [](auto& names, int number) { return std::string(names[number]); };
  return at(Names::prefilter, three.prefilter) + " " + at(Names::samplerPrecision, three.samplerPrecision);
}

Atlas prefilterAtlas(const gl::Context& context, const ImageF& map, const ThreeTerms& three,
                     const CancelToken& cancel) {
  Chain chain(context, map, three, cancel);
  const bool blurred = three.prefilter == ThreeTerms::THREE_PREFILTER_BLUR ||
                       three.prefilter == ThreeTerms::THREE_PREFILTER_BLUR_FROM_END;
  blurred ? chain.blur() : chain.reflect();
  context.check("environment prefilter");
  return chain.take();
}

}  // namespace telar::ibl
