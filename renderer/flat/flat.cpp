#include "telar/flat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "flat/flat.h"
#include "flat/ink.h"
#include "frame/camera.h"
#include "frame/variant.h"
#include "telar/half.h"
#include "telar/part_opacities.h"
#include "telar/variant_material.h"

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

/// Whether a scene draws a part in any way, be it left out of a shot.
bool draws(const Scene& scene, const PartQuery& part, int variant) {
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (surface::isOfPart(scene, {static_cast<int>(n), 0, -1, materialIndex(node, primitive, variant)}, part))
        return true;
    }
  }
  return false;
}

/// Which sources are of the parts.
/// @param pointer  names the list where one is not there
std::vector<char> stitchedOf(const Scene& scene, const surface::Surface& surface, const std::vector<PartQuery>& parts,
                             int variant, const char* pointer) {
  std::vector<char> stitched(surface.sources.size());
  for (const PartQuery& part : parts) {
    bool found = false;
    for (std::size_t i = 0; i < surface.sources.size(); ++i) {
      const bool meant = surface::isOfPart(scene, surface.sources[i], part);
      found |= meant;
      if (meant) stitched[i] = 1;
    }
    if (!found && !draws(scene, part, variant)) throw surface::noSuchPart(part).at(pointer);
  }
  return stitched;
}

struct Request {
  flat::FlatOptions options;
  std::vector<PartQuery> stitched;
  const char* pointer;  ///< of `stitched`
};

Request requestOf(const json& request) {
  Request out{{}, {}, "/stitched"};
  flat::FlatOptions& options = out.options;
  options.creaseAngle = request.at("creaseAngle").get<double>();
  options.foldDepth = request.at("foldDepth").get<double>();
  options.foldLength = request.at("foldLength").get<double>();
  options.tolerance = request.at("tolerance").get<double>();
  for (const json& part : request.at("stitched")) out.stitched.push_back(partOf(part));
  return out;
}

/// The visible lines of what a shot's ghosts leave, and of what is seen through those of them that are translucent.
struct Drawing {
  std::vector<flat::Stroke> strokes;
  std::size_t triangles = 0;
};

Drawing drawingOf(const Scene& scene, const Shot& shot, surface::SurfaceOptions what, Request request,
                  const CancelToken& cancel) {
  const PartOpacities opacities(scene, shot.ghost);
  std::vector<flat::Piece> pieces;
  Drawing out;
  std::uint32_t nodes = 0;
  const auto add = [&](bool within) {
    const surface::Surface surface = buildSurface(scene, what, cancel);
    request.options.stitched = stitchedOf(scene, surface, request.stitched, what.variant, request.pointer);
    const flat::View view(surface, shot, cancel);
    std::uint32_t next = nodes;
    for (flat::Piece piece : visiblePieces(surface, view, request.options, cancel)) {
      // What is seen through a part ends within the outline of that part.
      if (within && piece.kind == flat::Kind::kSilhouette) piece.kind = flat::Kind::kContour;
      piece.from += nodes, piece.to += nodes;
      next = std::max({next, piece.from + 1, piece.to + 1});
      pieces.push_back(piece);
    }
    nodes = next;
    out.triangles += surface.faces.size();
  };
  const auto opacityOf = [&](const Node& node, int material) { return opacities.of(node, material); };
  if (!shot.ghost.empty()) what.isMeant = [&](const Node& node, int m) { return opacityOf(node, m) > 0; };
  add(false);
  const bool sheer = std::any_of(shot.ghost.begin(), shot.ghost.end(),
                                 [](const Shot::Ghost& ghost) { return ghost.opacity > 0 && ghost.opacity < 1; });
  if (sheer) {
    what.isMeant = [&](const Node& node, int m) { return opacityOf(node, m) == 1; };
    add(true);
  }
  out.strokes = strokesOf(pieces, request.options, cancel);
  return out;
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
  const Drawing drawing = drawingOf(scene, shot, what, requestOf(request), cancel);
  json out = {{"strokes", json::array()}};
  for (const flat::Stroke& stroke : drawing.strokes) {
    json points = json::array();
    for (const glm::dvec2& p : stroke.points) points.push_back({rounded(p.x), rounded(p.y)});
    out["strokes"].push_back({{"kind", flat::KIND_NAMES[static_cast<std::size_t>(stroke.kind)]},
                              {"closed", stroke.closed},
                              {"points", points}});
  }
  const glm::dmat4 toPixel = frame::worldToPixel(frame::cameraOf(shot), shot.width, shot.height);
  out["worldToPixel"] = std::vector<double>(glm::value_ptr(toPixel), glm::value_ptr(toPixel) + 16);
  out["triangles"] = drawing.triangles;
  return out.dump();
}

LayerImage drawLines(const Scene& scene, const Shot& shot, const CancelToken& cancel) {
  surface::SurfaceOptions what;
  what.variant = frame::variantIndex(scene, shot.variant);
  what.join = shot.flat.join;
  const flat::FlatOptions options{shot.flat.creaseAngle, shot.flat.foldDepth, shot.flat.foldLength * shot.height,
                                  shot.flat.tolerance};
  const Drawing drawing = drawingOf(scene, shot, what, {options, shot.flat.stitched, "/flat/stitched"}, cancel);
  constexpr double INCH_MM = 25.4, SCREEN_PPI = 96;
  const double pixels = (shot.output.ppi > 0 ? shot.output.ppi : SCREEN_PPI) / INCH_MM;
  const shot::Flat::Weights& w = shot.flat.weights;
  flat::Paper paper(shot.width, shot.height);
  for (const flat::Stroke& stroke : drawing.strokes) {
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
  const glm::vec3 linear = coloured ? glm::clamp(shot.background.color, 0.0f, floats ? HALF_MAX : 1.0f) : glm::vec3(0);
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
