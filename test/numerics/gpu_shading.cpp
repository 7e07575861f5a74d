// The text of a shading as the fragment shader has it, run on the GPU into float targets, against double precision.
#include <algorithm>
#include <array>
#include <sstream>

#include "brdf/gpu_probe.h"
#include "checks.h"
#include "evaluate.h"
#include "precision.h"
#include "shader/variant_key.h"
#include "shading_terms.h"
#include "surface_point.h"
#include "worst.h"

namespace telar::numerics {
namespace {

/// Whether a file knows neither uniforms nor textures.
bool isPure(const std::string& file) {
  return file.rfind("brdf/", 0) == 0 || file.rfind("shading/", 0) == 0 || file == "material/input_types.glsl" ||
         file == "material/surface_types.glsl" || file == "light/reflected.glsl";
}

/// The text of a file with the pure files that it includes in their place; of one that is not pure its directives
/// alone.
std::string pureText(const std::string& file) {
  std::istringstream in(shader::embeddedFiles().at(file));
  constexpr std::string_view INCLUDE = "#include \"";
  std::string text;
  for (std::string line; std::getline(in, line) && line != "out vec4 fragmentColor;";) {
    if (line.rfind(INCLUDE, 0) == 0) {
      const std::string included = line.substr(INCLUDE.size(), line.rfind('"') - INCLUDE.size());
      if (isPure(included)) text += pureText(included);
    } else if (isPure(file) || line.rfind("#", 0) == 0) {
      text += line + "\n";
    }
  }
  return text;
}

/// Lines of surface.frag that bring in the shading text, with what they include in their place.
std::string shadingText() { return pureText("surface.frag"); }

/// One program: what it has compiled in, and which points it may shade.
struct Variant {
  const char* name;
  bool sheen, coat, stretched, film, roughDiffuse;
  bool thin = false, woven = false;
};

constexpr Variant VARIANTS[] = {
    {"base", false, false, false, false, false},
    {"sheen", true, false, false, false, false},
    {"every layer", true, true, true, true, true},
    {"thin sheet, yarns", true, false, false, false, false, true, true},
};

std::string definesOf(const Variant& variant, ShadingModel model, const ShadingTerms& terms) {
  shader::VariantKey key;
  key.shading = model;
  if (isPrincipled(model)) key.terms = terms;
  key.sheen = variant.sheen;
  key.clearcoat = variant.coat;
  key.anisotropy = variant.stretched;
  key.iridescence = variant.film;
  key.diffuseRoughness = variant.roughDiffuse;
  key.flatness = key.diffuseTransmission = variant.thin;
  key.weave = variant.woven && model == ShadingModel::kFabric;
  std::string text;
  for (const auto& [name, value] : key.defines()) text += "#define " + name + " " + std::to_string(value) + "\n";
  return text;
}

/// A point of the grid without what the program lacks.
SurfacePoint pointFor(ShadingModel model, const Variant& variant, std::uint64_t index) {
  // The upper half of the grid has every layer: woven cloth among them.
  SurfacePoint p = gridPoint(model, variant.woven ? gridSize() / 2 + index / 2 : index);
  if (!variant.sheen) p.info.sheenColor = glm::vec3(0);
  if (!variant.coat) p.info.clearcoat = 0;
  if (!variant.stretched) p.info.anisotropyStrength = 0, p.info.alphaT = p.info.alpha;
  if (!variant.film) p.info.iridescence = 0;
  if (!variant.roughDiffuse) p.info.diffuseRoughness = 0;
  if (!variant.thin) p.info.flatness = p.info.diffuseTransmission = 0;
  if (!variant.woven) p.info.warp.coverage = p.info.weft.coverage = 0;
  return p;
}

constexpr std::size_t roundedUp(std::size_t count) { return (count + 3) / 4 * 4; }

struct Sample {
  std::uint64_t point;
  SurfacePoint surface;
};

struct Errors {
  std::array<Worst, 3> byWidth;
  std::uint64_t notFinite = 0, notFiniteAt = 0, count = 0, woven = 0;
};

void compare(const ShadingPromise& shading, const std::vector<Sample>& samples, const std::vector<float>& result,
             Errors& errors) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const SurfacePoint& p = samples[i].surface;
    const glm::dvec3 expected = Shaded<double>(shading.model, inDouble(p.info)).direct(glm::dvec3(p.l));
    const glm::vec3 actual(result[i * 4], result[i * 4 + 1], result[i * 4 + 2]);
    ++errors.count;
    if (!isFinite(actual) || least(actual) < 0) {
      ++errors.notFinite;
      errors.notFiniteAt = samples[i].point;
      continue;
    }
    errors.woven += hasYarns(p);
    errors.byWidth[static_cast<std::size_t>(widthOf(shading, p))].see(relativeError(actual, expected),
                                                                      samples[i].point);
  }
}

Errors measure(test::GpuProbe& probe, const Variant& variant, const ShadingPromise& shading, const ShadingTerms& terms,
               std::uint64_t batches) {
  const std::size_t columns = roundedUp(numberCount() + 3), light = numberCount();
  const std::string l = "vec3(p[" + std::to_string(light) + "], p[" + std::to_string(light + 1) + "], p[" +
                        std::to_string(light + 2) + "])";
  const gl::Program program = probe.compile(
      definesOf(variant, shading.model, terms) + shadingText(),
      "composedRadiance(s, lit.diffuse, lit, nothingReflected(), vec3(0.0))",
      "SurfaceInfo s;\n" + glslReader(0) +
          "s = preparedSurface(s);\nReflected lit = addPunctual(nothingReflected(), s, " + l + ", vec3(1.0));");
  const std::uint64_t wanted = batches * test::GpuProbe::ROWS;
  Errors errors;
  for (std::uint64_t first = 0; first < wanted; first += test::GpuProbe::ROWS) {
    std::vector<float> rows(test::GpuProbe::ROWS * columns, 0.0f);
    std::vector<Sample> samples;
    for (std::uint64_t i = 0; i < test::GpuProbe::ROWS; ++i) {
      const std::uint64_t index = (first + i) * (gridSize() / wanted + 1) % gridSize();
      samples.push_back({index, pointFor(shading.model, variant, index)});
      samples.back().surface.info.terms = terms;
      std::vector<float> numbers = numbersOf(samples.back().surface.info);
      for (int axis = 0; axis < 3; ++axis) numbers.push_back(samples.back().surface.l[axis]);
      std::copy(numbers.begin(), numbers.end(), rows.begin() + static_cast<std::ptrdiff_t>(i * columns));
    }
    compare(shading, samples, probe.run(program, rows), errors);
  }
  return errors;
}

}  // namespace

std::vector<Figure> checkGpu(const ShadingPromise& shading, Scale scale) {
  test::GpuProbe probe(Backend::kEglSurfaceless, roundedUp(numberCount() + 3));
  std::vector<Figure> out;
  constexpr std::uint64_t FULL = 250;  // batches: the whole grid
  for (const Variant& variant : VARIANTS) {
    const Errors errors = measure(probe, variant, shading, termsOf(shading.model), countOf(scale, 2, FULL));
    const auto add = [&](const std::string& what, double measured, double bar, std::uint64_t point) {
      out.push_back({what + ", " + variant.name, shading.name, measured, bar, -NO_BAR, errors.count,
                     measured > 0 ? "grid point " + std::to_string(point) + ": " +
                                        describe(pointFor(shading.model, variant, point))
                                  : "",
                     FULL * test::GpuProbe::ROWS});
    };
    add("points not finite or negative", static_cast<double>(errors.notFinite), 0, errors.notFiniteAt);
    if (shading.weaves && variant.woven) {
      add("points that show yarns", static_cast<double>(errors.woven), NO_BAR, 0);
      out.back().low = static_cast<double>(errors.count / 4);
      out.back().where.clear();
    }
    for (const Width width : {Width::kSmooth, Width::kRough, Width::kThinFuzz}) {
      const Worst& worst = errors.byWidth[static_cast<std::size_t>(width)];
      if (width == Width::kThinFuzz && (shading.robust || !variant.sheen)) continue;
      add(std::string("relative error, ") + nameOf(width), worst.value, errorBar(shading, width), worst.point);
    }
  }
  return out;
}

namespace {

/// With what the terms of thin cloth read.
constexpr Variant THIN_CLOTH{"every layer", true, true, true, true, true, true};

struct Slot {
  const char* name;
  int ShadingTerms::*member;
  std::vector<const char*> terms;
};

const std::vector<Slot>& termSlots() {
#define TELAR_SLOT(define, member, ...) {#member, &ShadingTerms::member, {__VA_ARGS__}},
  static const std::vector<Slot> slots{TELAR_SHADING_SLOTS(TELAR_SLOT)};
#undef TELAR_SLOT
  return slots;
}

}  // namespace

std::vector<Figure> checkGpuTerms(const ShadingPromise& shading, Scale scale) {
  std::vector<Figure> out;
  constexpr std::uint64_t FULL = 25;  // batches a term
  test::GpuProbe probe(Backend::kEglSurfaceless, roundedUp(numberCount() + 3));
  for (const Slot& slot : termSlots()) {
    const auto figureOf = [&](const std::string& what, double bar) {
      return Figure{what + ", other terms of " + slot.name, shading.name, 0, bar};
    };
    Figure bad = figureOf("points not finite or negative", 0);
    Figure relative[] = {figureOf("relative error, roughness < 0.2", shading.smoothError),
                         figureOf("relative error, roughness >= 0.2", shading.roughError)};
    for (std::size_t term = 0; term < slot.terms.size(); ++term) {
      ShadingTerms terms = termsOf(shading.model);
      if (terms.*slot.member == static_cast<int>(term)) continue;
      terms.*slot.member = static_cast<int>(term);
      const Errors errors = measure(probe, THIN_CLOTH, shading, terms, countOf(scale, 1, FULL));
      const auto see = [&](Figure& figure, double measured, std::uint64_t point) {
        figure.points += errors.count;
        figure.full += FULL * test::GpuProbe::ROWS;
        if (measured <= figure.measured) return;
        figure.measured = measured;
        figure.where = std::string(slot.terms[term]) + ", grid point " + std::to_string(point) + ": " +
                       describe(pointFor(shading.model, THIN_CLOTH, point));
      };
      see(bad, static_cast<double>(errors.notFinite), errors.notFiniteAt);
      for (const Width width : {Width::kSmooth, Width::kRough}) {
        const Worst& worst = errors.byWidth[static_cast<std::size_t>(width)];
        see(relative[width == Width::kRough], worst.value, worst.point);
      }
    }
    out.insert(out.end(), {bad, relative[0], relative[1]});
  }
  return out;
}

}  // namespace telar::numerics
