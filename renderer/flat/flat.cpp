#include "telar/flat.h"

#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "flat/flat.h"
#include "flat/ink.h"
#include "frame/camera.h"
#include "frame/variant.h"

namespace telar {
namespace {

using json = nlohmann::ordered_json;

PartQuery partOf(const json& part) {
  PartQuery query;
  if (part.at("kind") == "material") query.kind = PartQuery::Kind::kMaterial;
  const json& which = part.at("which");
  which.is_number() ? query.which = which.get<int>() : query.which = which.get<std::string>();
  return query;
}

/// Which sources are of the parts.
/// @param pointer  names the list where one is not there
std::vector<char> stitchedOf(const Scene& scene, const surface::Surface& surface, const std::vector<PartQuery>& parts,
                             const char* pointer) {
  std::vector<char> stitched(surface.sources.size());
  for (const PartQuery& part : parts) {
    bool found = false;
    for (std::size_t i = 0; i < surface.sources.size(); ++i) {
      const bool meant = surface::isOfPart(scene, surface.sources[i], part);
      found |= meant;
      if (meant) stitched[i] = 1;
    }
    if (!found) throw surface::noSuchPart(part).at(pointer);
  }
  return stitched;
}

flat::FlatOptions optionsOf(const Scene& scene, const surface::Surface& surface, const json& request) {
  flat::FlatOptions options;
  options.creaseAngle = request.at("creaseAngle").get<double>();
  options.foldDepth = request.at("foldDepth").get<double>();
  options.foldLength = request.at("foldLength").get<double>();
  options.tolerance = request.at("tolerance").get<double>();
  std::vector<PartQuery> stitched;
  for (const json& part : request.at("stitched")) stitched.push_back(partOf(part));
  options.stitched = stitchedOf(scene, surface, stitched, "/stitched");
  return options;
}

/// Thousandths of a pixel: finer than any printer, and a third of the text.
double rounded(double pixels) { return std::round(pixels * 1000) / 1000; }

}  // namespace

std::string drawFlat(const Scene& scene, const Shot& shot, std::string_view text, const CancelToken& cancel) {
  const json request = json::parse(text);
  surface::SurfaceOptions what;
  what.variant = frame::variantIndex(scene, shot.variant);
  what.join = request.at("join").get<double>();
  if (!request.at("part").is_null()) what.part = partOf(request.at("part"));
  const surface::Surface surface = buildSurface(scene, what, cancel);
  const flat::FlatOptions options = optionsOf(scene, surface, request);
  const flat::View view(surface, shot, cancel);
  json out = {{"strokes", json::array()}};
  for (const flat::Stroke& stroke : strokesOf(visiblePieces(surface, view, options, cancel), options, cancel)) {
    json points = json::array();
    for (const glm::dvec2& p : stroke.points) points.push_back({rounded(p.x), rounded(p.y)});
    out["strokes"].push_back({{"kind", flat::KIND_NAMES[static_cast<std::size_t>(stroke.kind)]},
                              {"closed", stroke.closed},
                              {"points", points}});
  }
  const glm::dmat4 toPixel = frame::worldToPixel(frame::cameraOf(shot), shot.width, shot.height);
  out["worldToPixel"] = std::vector<double>(glm::value_ptr(toPixel), glm::value_ptr(toPixel) + 16);
  out["triangles"] = surface.faces.size();
  return out.dump();
}

LayerImage drawLines(const Scene& scene, const Shot& shot, const CancelToken& cancel) {
  surface::SurfaceOptions what;
  what.variant = frame::variantIndex(scene, shot.variant);
  what.join = shot.flat.join;
  const surface::Surface surface = buildSurface(scene, what, cancel);
  flat::FlatOptions options{shot.flat.creaseAngle, shot.flat.foldDepth, shot.flat.foldLength * shot.height,
                            shot.flat.tolerance};
  options.stitched = stitchedOf(scene, surface, shot.flat.stitched, "/flat/stitched");
  const flat::View view(surface, shot, cancel);
  const auto strokes = strokesOf(visiblePieces(surface, view, options, cancel), options, cancel);
  constexpr double INCH_MM = 25.4, SCREEN_PPI = 96;
  const double pixels = (shot.output.ppi > 0 ? shot.output.ppi : SCREEN_PPI) / INCH_MM;
  const shot::Flat::Weights& w = shot.flat.weights;
  flat::Paper paper(shot.width, shot.height);
  for (const flat::Stroke& stroke : strokes) {
    cancel.check();
    const double weight =
        std::array{w.silhouette, w.contour, w.seam, w.stitch, w.crease}[static_cast<std::size_t>(stroke.kind)] * pixels;
    paper.draw(stroke, weight);
  }
  return {Layer::kLine, paper.brightness()};
}

Frame flatFrame(const LayerImage& lines, const Shot& shot) {
  Frame frame{
      static_cast<std::uint32_t>(shot.width), static_cast<std::uint32_t>(shot.height), framePixelType(shot.output), {}};
  const bool coloured = shot.background.type == Shot::Background::Type::kColor;
  const bool floats = frame.type == PixelType::kRgbaF32;
  const auto shown = [&](float linear) {
    return floats ? linear : linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
  };
  const glm::vec3 linear = coloured ? glm::clamp(shot.background.color, 0.0f, floats ? 65504.0f : 1.0f) : glm::vec3(0);
  const glm::vec3 behind(shown(linear.r), shown(linear.g), shown(linear.b));
  frame.pixels.resize(lines.pixels.size() * (floats ? sizeof(glm::vec4) : 4));
  for (std::size_t i = 0; i < lines.pixels.size(); ++i) {
    const glm::vec4 pixel(behind * lines.pixels[i], coloured ? 1 : 1 - lines.pixels[i]);
    if (floats) std::memcpy(&frame.pixels[i * sizeof pixel], &pixel, sizeof pixel);
    for (int c = 0; c < 4 && !floats; ++c)
      frame.pixels[i * 4 + static_cast<std::size_t>(c)] = static_cast<std::byte>(std::lround(pixel[c] * 255));
  }
  return frame;
}

std::string describeFlat(const Shot& shot, double milliseconds) {
  const glm::dmat4 toPixel = frame::worldToPixel(frame::cameraOf(shot), shot.width, shot.height);
  return json{{"features", json::array()},
              {"programs", json::array()},
              {"passes", {"flat"}},
              {"samples", 1},
              {"drawCalls", 0},
              {"programsCompiled", 0},
              {"environmentSource", nullptr},
              {"worldToPixel", std::vector<double>(glm::value_ptr(toPixel), glm::value_ptr(toPixel) + 16)},
              {"ms", {{"draw", milliseconds}}}}
      .dump();
}

}  // namespace telar
