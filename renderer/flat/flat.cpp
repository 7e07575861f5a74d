#include "telar/flat.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include "flat/flat.h"
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

flat::FlatOptions optionsOf(const Scene& scene, const surface::Surface& surface, const json& request) {
  flat::FlatOptions options;
  options.creaseAngle = request.at("creaseAngle").get<double>();
  options.foldDepth = request.at("foldDepth").get<double>();
  options.foldLength = request.at("foldLength").get<double>();
  options.tolerance = request.at("tolerance").get<double>();
  options.stitched.assign(surface.sources.size(), 0);
  for (const json& part : request.at("stitched")) {
    const PartQuery query = partOf(part);
    bool found = false;
    for (std::size_t i = 0; i < surface.sources.size(); ++i) {
      const bool meant = surface::isOfPart(scene, surface.sources[i], query);
      found |= meant;
      if (meant) options.stitched[i] = 1;
    }
    if (!found) throw surface::noSuchPart(query).at("/stitched");
  }
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

}  // namespace telar
