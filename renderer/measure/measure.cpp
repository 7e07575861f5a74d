#include "telar/measure.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "frame/variant.h"
#include "measure/loops.h"

namespace telar {
namespace {

using json = nlohmann::ordered_json;
using measure::Loop;
using surface::Place;
using surface::Surface;

glm::dvec3 vec3(const json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}
json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

json listOf(const std::vector<glm::dvec3>& points) {
  json out = json::array();
  for (const glm::dvec3& p : points) out.push_back(list(p));
  return out;
}

json toJson(const Loop& loop) {
  return {{"length", loop.length()}, {"closed", loop.closed}, {"polyline", listOf(loop.points)}};
}

surface::SurfaceOptions optionsOf(const Scene& scene, const json& request) {
  surface::SurfaceOptions options;
  options.variant = frame::variantIndex(scene, request.at("variant").get<std::string>());
  options.join = request.at("join").get<double>();
  const json& part = request.at("part");
  if (part.is_null()) return options;
  PartQuery& query = options.part.emplace();
  if (part.at("kind") == "material") query.kind = PartQuery::Kind::kMaterial;
  const json& which = part.at("which");
  which.is_number() ? query.which = which.get<int>() : query.which = which.get<std::string>();
  return options;
}

/// A place, and the triangle that it was asked for by: where that is left out as a repeat, another than the one of the place.
struct Asked {
  Place place;
  surface::Face face;
  glm::dvec3 weights{0};  ///< of its corners
};

class Measure {
 public:
  Measure(const Scene& scene, const Surface& surface, const CancelToken& cancel)
      : scene_(scene), surface_(surface), cancel_(cancel) {}

  json points(const json& ask) const {
    std::vector<Place> places;
    json described = json::array();
    for (const json& point : ask.at("points")) {
      const std::string pointer = "/points/" + std::to_string(places.size());
      const Asked asked = askedOf(point, pointer);
      places.push_back(asked.place);
      described.push_back(describe(asked));
    }
    const bool closed = ask.at("closed").get<bool>(), overSurface = ask.at("along") == "surface";
    const auto ways = overSurface ? surfaceWays(places, closed) : straightWays(places, closed);
    json lengths = json::array();
    double sum = 0;
    std::vector<glm::dvec3> polyline{places.front().position};
    for (const measure::Path& way : ways) {
      lengths.push_back(way.length);
      sum += way.length;
      polyline.insert(polyline.end(), way.points.begin() + 1, way.points.end());
    }
    return {{"length", sum}, {"lengths", lengths}, {"points", described}, {"polyline", listOf(polyline)}};
  }

  json girth(const json& ask) const {
    const glm::dvec3 point = vec3(ask.at("point")), normal = glm::normalize(vec3(ask.at("normal")));
    std::vector<Loop> loops = measure::sectionOf(surface_, point, normal, cancel_);
    if (loops.empty()) throw Error("E_MEASURE", "the plane of the girth does not meet the surface").at("/girth");
    std::stable_sort(loops.begin(), loops.end(),
                     [&](const Loop& a, const Loop& b) { return a.distanceTo(point) < b.distanceTo(point); });
    json out = toJson(loops.front());
    if (ask.at("tight").get<bool>()) {
      if (!loops.front().closed) {
        throw Error("E_MEASURE",
                    "the section nearest to the point is open, so it cannot be drawn tight: the option join closes "
                    "gaps between parts")
            .at("/girth");
      }
      out = toJson(tightened(surface_, loops.front(), cancel_));
      out["section"] = loops.front().length();
    }
    out["others"] = json::array();
    for (std::size_t i = 1; i < loops.size(); ++i)
      out["others"].push_back({{"length", loops[i].length()}, {"closed", loops[i].closed}});
    return out;
  }

  json border() const {
    std::vector<Loop> loops = measure::borderOf(surface_, cancel_);
    if (loops.empty()) throw Error("E_MEASURE", "the part has no border: it is closed").at("/border");
    std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) { return a.length() > b.length(); });
    json out = {{"length", 0.0}, {"loops", json::array()}};
    double sum = 0;
    for (const Loop& loop : loops) out["loops"].push_back(toJson(loop)), sum += loop.length();
    out["length"] = sum;
    return out;
  }

 private:
  Asked askedOf(const json& point, const std::string& pointer) const {
    if (point.contains("position")) {
      const Place place = nearestPlace(surface_, vec3(point.at("position")), cancel_);
      return {place, surface_.faces[place.face], place.weights};
    }
    const std::uint32_t source = sourceOf(point, pointer);
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f) {
      const auto weights = weightsOf(point, surface_.faces[f], source);
      if (weights) return {placeAt(surface_, f, *weights), surface_.faces[f], *weights};
    }
    for (const auto& [face, first] : surface_.repeats) {
      const auto weights = weightsOf(point, face, source);
      if (!weights) continue;
      glm::dvec3 same(
          0);  // at the same corners of the face that stays, which may begin at another one or wind the other way
      for (int k = 0; k < 3; ++k)
        same[Surface::cornerOf(surface_.faces[first], face.points[static_cast<std::size_t>(k)])] = (*weights)[k];
      return {placeAt(surface_, first, same), face, *weights};
    }
    const char* what = point.contains("triangle") ? "triangle " : "vertex ";
    const json& index = point.contains("triangle") ? point.at("triangle") : point.at("vertex");
    throw Error("E_MEASURE", std::string("the surface has no ") + what + index.dump() + " there, or one without area")
        .at(pointer);
  }

  /// Where a point of the request lies in a face; none where that names another one.
  std::optional<glm::dvec3> weightsOf(const json& point, const surface::Face& face, std::uint32_t source) const {
    if (face.source != source) return std::nullopt;
    if (point.contains("triangle")) {
      if (face.triangle != point.at("triangle").get<std::uint32_t>()) return std::nullopt;
      return vec3(point.at("weights"));
    }
    for (int k = 0; k < 3; ++k) {
      if (vertexOf(face, k) != point.at("vertex").get<std::uint32_t>()) continue;
      glm::dvec3 weights(0);
      weights[k] = 1;
      return weights;
    }
    return std::nullopt;
  }

  std::uint32_t sourceOf(const json& point, const std::string& pointer) const {
    const json& wanted = point.at("node");
    for (std::uint32_t s = 0; s < surface_.sources.size(); ++s) {
      const surface::Source& source = surface_.sources[s];
      const Node& node = scene_.nodes[static_cast<std::size_t>(source.node)];
      const bool meant =
          wanted.is_number() ? node.file.node == wanted.get<int>() : node.name == wanted.get<std::string>();
      if (meant && source.primitive == point.at("primitive").get<int>()) return s;
    }
    throw Error("E_MEASURE", "the surface has no such node and primitive").at(pointer);
  }

  const Primitive& primitiveOf(const surface::Source& source) const {
    const Node& node = scene_.nodes[static_cast<std::size_t>(source.node)];
    return scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives[static_cast<std::size_t>(source.primitive)];
  }

  std::uint32_t vertexOf(const surface::Face& face, int k) const {
    const Primitive& primitive = primitiveOf(surface_.sources[face.source]);
    const std::size_t at = std::size_t{3} * face.triangle + static_cast<std::size_t>(k);
    return primitive.indices.empty() ? static_cast<std::uint32_t>(at) : primitive.indices[at];
  }

  json describe(const Asked& asked) const {
    const auto& [place, face, weights] = asked;
    const surface::Source& source = surface_.sources[face.source];
    const Node& node = scene_.nodes[static_cast<std::size_t>(source.node)];
    return {{"position", list(place.position)}, {"moved", place.distance},
            {"node", node.file.node},           {"nodeName", node.name},
            {"material", source.material},      {"primitive", source.primitive},
            {"triangle", face.triangle},        {"weights", list(weights)}};
  }

  template <class Way>
  static std::vector<measure::Path> waysBy(const std::vector<Place>& places, bool closed, const Way& way) {
    std::vector<measure::Path> ways;
    const std::size_t count = closed ? places.size() : places.size() - 1;
    for (std::size_t i = 0; i < count; ++i) ways.push_back(way(i, (i + 1) % places.size()));
    return ways;
  }

  static std::vector<measure::Path> straightWays(const std::vector<Place>& places, bool closed) {
    return waysBy(places, closed, [&](std::size_t i, std::size_t k) {
      const glm::dvec3 &a = places[i].position, &b = places[k].position;
      return measure::Path{glm::distance(a, b), {a, b}};
    });
  }

  std::vector<measure::Path> surfaceWays(const std::vector<Place>& places, bool closed) const {
    const std::vector<std::uint32_t> component = componentsOf(surface_);
    measure::Geodesic geodesic(surface_, cancel_);
    return waysBy(places, closed, [&](std::size_t i, std::size_t k) {
      const auto componentAt = [&](const Place& place) { return component[surface_.faces[place.face].points[0]]; };
      std::optional<measure::Path> way;
      if (componentAt(places[i]) == componentAt(places[k])) way = geodesic.between(places[i], places[k]);
      if (way) return *way;
      throw Error("E_MEASURE", "no way over the surface joins points " + std::to_string(i) + " and " +
                                   std::to_string(k) +
                                   ": they lie on parts that do not touch; the option join closes gaps between parts")
          .at("/points/" + std::to_string(k));
    });
  }

  const Scene& scene_;
  const Surface& surface_;
  const CancelToken& cancel_;
};

}  // namespace

std::string measureScene(const Scene& scene, std::string_view text, const CancelToken& cancel) {
  const json request = json::parse(text);
  const Surface surface = buildSurface(scene, optionsOf(scene, request), cancel);
  if (surface.faces.empty()) throw Error("E_MEASURE", "there is no surface to measure: nothing is drawn of triangles");
  const Measure measure(scene, surface, cancel);
  const json& ask = request.at("ask");
  const std::string kind = ask.at("kind").get<std::string>();
  const json out = kind == "points" ? measure.points(ask) : kind == "girth" ? measure.girth(ask) : measure.border();
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace telar
