#include "telar/swatch.h"

#include <array>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "core/sha256.h"
#include "frame/variant.h"
#include "swatch/worn_texels.h"

namespace telar {
namespace {

using json = nlohmann::json;

/// Quads of a side: a fold has some twenty.
constexpr int QUADS = 64;
/// Folds of a draped square, and how deep the deepest is: parts of its side. A row of arc length s stands at
/// z = depth cos(2 pi FOLDS s): what is steeper than 1 has no length left to run sideways.
constexpr double FOLDS = 2.5, DEPTH = 0.055;
static_assert(2 * std::numbers::pi * FOLDS * DEPTH < 1);

surface::SurfaceOptions optionsOf(const Scene& scene, const json& request) {
  surface::SurfaceOptions options;
  options.variant = frame::variantIndex(scene, request.at("variant").get<std::string>());
  PartQuery& query = options.part.emplace();
  if (request.at("part").at("kind") == "material") query.kind = PartQuery::Kind::kMaterial;
  const json& which = request.at("part").at("which");
  which.is_number() ? query.which = which.get<int>() : query.which = which.get<std::string>();
  return options;
}

/// Place of a square of side 1 about the origin: s and t from its lower left corner.
glm::dvec3 flat(double s, double t) { return {s - 0.5, t - 0.5, 0}; }

/// The same, hung: the way along a row from its middle is the integral of the root of 1 - (dz/ds)^2 (Simpson's rule).
glm::dvec3 hung(double s, double t) {
  const double depth = DEPTH * (1 - t), k = 2 * std::numbers::pi * FOLDS;
  const auto run = [&](double at) { return std::sqrt(1 - std::pow(depth * k * std::sin(k * at), 2)); };
  constexpr int STEPS = 32;
  const double from = 0.5, step = (s - from) / STEPS;
  double x = 0;
  for (int i = 0; i < STEPS; ++i) {
    const double a = from + i * step;
    x += step / 6 * (run(a) + 4 * run(a + step / 2) + run(a + step));
  }
  return {x, t - 0.5, depth * std::cos(k * s)};
}

/// @param middle  what the middle of the square shows, by set of texture coordinates
Primitive squareOf(const swatch::Worn& worn, const std::array<glm::dvec2, 2>& middle, double size, bool draped) {
  Primitive out;
  const auto place = [&](double s, double t) { return size * (draped ? hung(s, t) : flat(s, t)); };
  const glm::vec4 color(worn.color / worn.area);
  const bool colored = color != glm::vec4(1);
  for (int j = 0; j <= QUADS; ++j) {
    for (int i = 0; i <= QUADS; ++i) {
      const double s = double{1} * i / QUADS, t = double{1} * j / QUADS, h = 1e-4;
      out.positions.emplace_back(place(s, t));
      out.bounds.add(glm::dvec3(out.positions.back()));
      out.normals.emplace_back(
          glm::normalize(glm::cross(place(s + h, t) - place(s - h, t), place(s, t + h) - place(s, t - h))));
      for (std::size_t set = 0; set < 2; ++set) {
        const auto& coordinates = worn.coordinates[set];
        const glm::dvec2 density = coordinates.density() * size;
        const double across = coordinates.turned < 0 ? -density.x : density.x;
        if (coordinates.area > 0)
          out.uvs[set].emplace_back(middle[set] + glm::dvec2(across * (s - 0.5), density.y * (0.5 - t)));
      }
      if (colored) out.colors.push_back(color);
    }
  }
  out.colorsHaveAlpha = color.a != 1;
  for (int j = 0; j < QUADS; ++j) {
    for (int i = 0; i < QUADS; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (QUADS + 1) + i), b = a + 1, c = a + QUADS + 1, d = c + 1;
      for (const std::uint32_t index : {a, b, d, a, d, c}) out.indices.push_back(index);
    }
  }
  out.material = worn.material;
  return out;
}

/// @pre it has one
const Material& materialOf(const Scene& scene, const swatch::Worn& worn) {
  return scene.materials[static_cast<std::size_t>(worn.material)];
}

/// The material's base colour as a whole. @param tile  whether the garment wears all of its texture
std::optional<glm::dvec3> colorOf(const Scene& scene, const surface::Surface& surface, const swatch::Worn& worn,
                                  bool tile, const CancelToken& cancel) {
  if (worn.material < 0) return std::nullopt;
  const Material& material = materialOf(scene, worn);
  if (tile) return meanTileColor(scene, worn);
  const glm::dvec4 vertices = worn.color / worn.area;
  // Colours of vertices count by what covers there.
  if (material.baseColorTexture || (!isOpaque(material) && vertices != glm::dvec4(1)))
    return meanWornColor(scene, surface, worn, cancel);
  return glm::dvec3(material.baseColorFactor) * glm::dvec3(vertices);
}

/// A scene of one primitive that shares all but geometry with the model.
std::shared_ptr<const Scene> sceneOf(const std::shared_ptr<const Scene>& model, Primitive primitive,
                                     std::string_view request) {
  const std::shared_ptr<const Scene>& source = model->model ? model->model : model;
  auto out = std::make_shared<Scene>(*source);
  out->model = source;
  Sha256 hash;
  hash.add(source->sha256);
  hash.add(request);
  out->sha256 = hash.hex();
  out->bounds = primitive.bounds;
  out->vertexCount = primitive.positions.size();
  out->triangleCount = primitive.indices.size() / 3;
  out->drawCount = 1;
  out->meshes.push_back({"swatch", std::vector<Primitive>{std::move(primitive)}});
  Node node;
  node.name = "swatch";
  node.mesh = static_cast<int>(out->meshes.size()) - 1;
  out->nodes = {node};
  // What the garment's own folds shade is no part of the cloth.
  for (Material& material : out->materials) material.occlusionTexture = {};
  out->lights.clear();
  out->cameras.clear();
  out->motion.reset();
  out->warnings.clear();
  out->fileWarnings = 0;
  return out;
}

}  // namespace

Swatch swatchOf(const std::shared_ptr<const Scene>& model, std::string_view text, const CancelToken& cancel) {
  const json request = json::parse(text);
  try {
    const surface::SurfaceOptions options = optionsOf(*model, request);
    const surface::Surface surface = buildSurface(*model, options, cancel);
    if (surface.faces.empty()) throw surface::noSuchPart(*options.part).at("/part");
    const swatch::Worn worn = swatch::mostWorn(*model, surface, cancel);
    const double size = request.at("size").get<double>();
    const bool draped = request.at("draped").get<bool>();
    // The middle of the square shows the middle of the texture, where that repeats on it or is worn.
    std::array<glm::dvec2, 2> middle{glm::dvec2(0.5), glm::dvec2(0.5)};
    Primitive square = squareOf(worn, middle, size, draped);
    const TextureRef texture = worn.material < 0 ? TextureRef{} : materialOf(*model, worn).baseColorTexture;
    const bool tile = texture && wearsATile(*model, surface, worn, cancel);
    if (texture && !tile) {
      middle = wornPlace(*model, surface, worn, static_cast<std::size_t>(texture.texCoord), cancel);
      square = squareOf(worn, middle, size, draped);
    }
    Swatch out;
    // A sheet asks for both, and the flat one tells: the texels are looked at once.
    if (!draped) out.meanBaseColor = colorOf(*model, surface, worn, tile, cancel);
    out.scene = sceneOf(model, std::move(square), text);
    return out;
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory for a swatch");
  }
}

}  // namespace telar
