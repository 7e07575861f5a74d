#include "surface/surface.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "telar/variant_material.h"

namespace telar::surface {
namespace {

/// Rounding of the file's floats: 24 bits hold an extent to 6e-8 of it, and a chain of nodes adds some of the same
/// size. On a garment of a metre this is a thousandth of a millimetre.
constexpr double WELD_OF_EXTENT = 1e-6;
constexpr std::size_t TRIANGLES_PER_CANCEL_CHECK = 1 << 14;

/// Points by place: one that lies nearer than the tolerance to an earlier one is that one.
class Welder {
 public:
  Welder(std::vector<glm::dvec3>& points, const glm::dvec3& origin, double tolerance)
      : points_(points), origin_(origin), tolerance_(tolerance) {}

  std::uint32_t add(const glm::dvec3& p) {
    // Of cells of twice the tolerance, eight hold all that is near.
    const glm::dvec3 cell = (p - origin_) / (2 * tolerance_), low = glm::floor(cell - 0.5);
    for (int corner = 0; corner < 8; ++corner) {
      const auto found = first_.find(keyOf(low + glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2)));
      for (std::uint32_t i = found == first_.end() ? NONE : found->second; i != NONE; i = next_[i]) {
        if (glm::distance(points_[i], p) <= tolerance_) return i;
      }
    }
    const auto index = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    const auto [slot, isNew] = first_.try_emplace(keyOf(glm::floor(cell)), index);
    next_.push_back(isNew ? NONE : slot->second);
    slot->second = index;
    return index;
  }

 private:
  static std::uint64_t keyOf(const glm::dvec3& cell) {
    std::uint64_t key = 0;
    for (int i = 0; i < 3; ++i)
      key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[i]))) * 0x9E3779B97F4A7C15u;
    return key ^ key >> 29;
  }

  std::vector<glm::dvec3>& points_;
  glm::dvec3 origin_;
  double tolerance_;
  std::unordered_map<std::uint64_t, std::uint32_t> first_;
  std::vector<std::uint32_t> next_;
};

bool isMeant(const PartQuery& query, int index, const std::string& name) {
  if (const int* wanted = std::get_if<int>(&query.which)) return index == *wanted;
  return name == std::get<std::string>(query.which);
}

/// Leaves out faces of three points that an earlier face has: what is doubled has no border and no way around, and ways over it
/// branch at each edge.
void dropRepeated(Surface& surface, const CancelToken& cancel) {
  std::vector<Face>& faces = surface.faces;
  struct Key {
    std::array<std::uint32_t, 3> points;
    std::uint32_t face;
  };
  std::vector<Key> keys;
  keys.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    keys.push_back({faces[f].points, f});
    std::sort(keys.back().points.begin(), keys.back().points.end());
  }
  cancel.check();
  std::sort(keys.begin(), keys.end(),
            [](const Key& p, const Key& q) { return std::tie(p.points, p.face) < std::tie(q.points, q.face); });
  cancel.check();
  std::vector<std::uint32_t> first(faces.size(), NONE), kept(faces.size(), NONE);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].points != keys[i - 1].points) continue;
    const std::uint32_t before = keys[i - 1].face;
    first[keys[i].face] = first[before] == NONE ? before : first[before];
  }
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (first[f] != NONE) {
      surface.repeats.push_back({faces[f], kept[first[f]]});
    } else {
      kept[f] = count;
      faces[count++] = faces[f];
    }
  }
  faces.resize(count);
}

/// A primitive in one place.
struct Placed {
  Source source;
  const Primitive* primitive;
  glm::dmat4 world;

  std::size_t vertices() const {
    return primitive->indices.empty() ? primitive->positions.size() : primitive->indices.size();
  }
  std::uint32_t vertex(std::size_t i) const {
    return primitive->indices.empty() ? static_cast<std::uint32_t>(i) : primitive->indices[i];
  }
  glm::dvec3 point(std::uint32_t vertex) const {
    return glm::dvec3(world * glm::dvec4(glm::dvec3(primitive->positions[vertex]), 1.0));
  }
};

class Builder {
 public:
  Builder(const Scene& scene, const SurfaceOptions& options, const CancelToken& cancel)
      : scene_(scene), options_(options), cancel_(cancel) {}

  Surface build() {
    collect();
    for (const Placed& placed : placed_) {
      cancel_.check();
      for (const glm::dvec3& p : corners(placed)) surface_.bounds.add(p);
    }
    if (surface_.bounds.empty()) return std::move(surface_);
    const double extent = surface_.bounds.diagonal();
    surface_.tolerance = std::max({options_.join, extent * WELD_OF_EXTENT, std::numeric_limits<double>::min()});
    Welder welder(surface_.points, surface_.bounds.min, surface_.tolerance);
    for (const Placed& placed : placed_) {
      surface_.sources.push_back(placed.source);
      placed.primitive->topology == Topology::kTriangles ? addFaces(placed, welder) : addLines(placed);
    }
    dropRepeated(surface_, cancel_);
    connect(surface_, cancel_);
    return std::move(surface_);
  }

 private:
  void collect() {
    std::vector<char> within(scene_.nodes.size(), options_.part ? 0 : 1);
    bool found = !options_.part;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      cancel_.check();
      const Node& node = scene_.nodes[i];
      if (options_.part && options_.part->kind == PartQuery::Kind::kNode) {
        const bool parentIs = node.parent >= 0 && within[static_cast<std::size_t>(node.parent)];
        within[i] = parentIs || isMeant(*options_.part, node.file.node, node.name) ? 1 : 0;
      }
      if (node.mesh >= 0) found |= place(static_cast<int>(i), within[i]);
    }
    if (!found) throw noSuchPart(*options_.part).at("/part");
  }

  /// @return whether any of it is of the part
  bool place(int nodeIndex, bool within) {
    const Node& node = scene_.nodes[static_cast<std::size_t>(nodeIndex)];
    const auto& primitives = scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    bool any = false;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const int material = materialIndex(node, primitives[p], options_.variant);
      if (!(within || wears(material)) || primitives[p].topology == Topology::kPoints) continue;
      any = true;
      if (options_.isMeant && !options_.isMeant(node, materialIndex(primitives[p], options_.variant))) continue;
      const std::size_t places = node.places();
      count(primitives[p], places);
      for (std::size_t i = 0; i < places; ++i) {
        const glm::dmat4 world = node.instances ? node.world * glm::dmat4(node.instances->matrices[i]) : node.world;
        placed_.push_back({{nodeIndex, static_cast<int>(p), node.instances ? static_cast<int>(i) : -1, material},
                           &primitives[p],
                           world});
      }
    }
    return any;
  }

  void count(const Primitive& primitive, std::size_t places) {
    const std::size_t vertices = primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size();
    const std::size_t triangles = vertices / 3;
    triangles_ += static_cast<double>(triangles) * static_cast<double>(places);
    const auto max = static_cast<double>(options_.maxTriangles);
    if (triangles_ > max) {
      throw Error("L_TRIANGLES",
                  "more triangles than a surface to measure or to draw in lines may have: name a part of the model")
          .withLimit("L_TRIANGLES", max, triangles_);
    }
  }

  bool wears(int material) const {
    if (!options_.part || options_.part->kind != PartQuery::Kind::kMaterial || material < 0) return false;
    return isMeant(*options_.part, material, scene_.materials[static_cast<std::size_t>(material)].name);
  }

  static std::array<glm::dvec3, 8> corners(const Placed& placed) {
    std::array<glm::dvec3, 8> out = placed.primitive->bounds.corners();
    for (glm::dvec3& corner : out) corner = glm::dvec3(placed.world * glm::dvec4(corner, 1.0));
    return out;
  }

  void addFaces(const Placed& placed, Welder& welder) {
    std::vector<std::uint32_t> welded(placed.primitive->positions.size(), NONE);
    const auto source = static_cast<std::uint32_t>(surface_.sources.size() - 1);
    for (std::size_t t = 0; t + 2 < placed.vertices(); t += 3) {
      if (t / 3 % TRIANGLES_PER_CANCEL_CHECK == 0) cancel_.check();
      Face face{{}, {}, source, static_cast<std::uint32_t>(t / 3)};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = placed.vertex(t + k);
        if (welded[vertex] == NONE) welded[vertex] = welder.add(placed.point(vertex));
        face.points[k] = welded[vertex];
      }
      const auto& [a, b, c] = face.points;
      if (a != b && b != c && c != a) surface_.faces.push_back(face);
    }
  }

  void addLines(const Placed& placed) {
    const std::size_t count = placed.vertices();
    const bool apart = placed.primitive->topology == Topology::kLines;
    const auto source = static_cast<std::uint32_t>(surface_.sources.size() - 1);
    for (std::size_t i = 0; i < count; i += apart ? 2 : count) {
      Line line{{}, source};
      for (std::size_t k = i; k < std::min(count, apart ? i + 2 : count); ++k)
        line.points.push_back(placed.point(placed.vertex(k)));
      if (placed.primitive->topology == Topology::kLineLoop) line.points.push_back(line.points.front());
      surface_.lines.push_back(std::move(line));
    }
  }

  const Scene& scene_;
  const SurfaceOptions& options_;
  const CancelToken& cancel_;
  double triangles_ = 0;
  std::vector<Placed> placed_;
  Surface surface_;
};

}  // namespace

bool isOfPart(const Scene& scene, const Source& source, const PartQuery& part) {
  if (part.kind == PartQuery::Kind::kMaterial) {
    return source.material >= 0 &&
           isMeant(part, source.material, scene.materials[static_cast<std::size_t>(source.material)].name);
  }
  for (int i = source.node; i >= 0; i = scene.nodes[static_cast<std::size_t>(i)].parent) {
    const Node& node = scene.nodes[static_cast<std::size_t>(i)];
    if (isMeant(part, node.file.node, node.name)) return true;
  }
  return false;
}

Error noSuchPart(const PartQuery& part) {
  const std::string kind = part.kind == PartQuery::Kind::kNode ? "node " : "material ";
  const int* index = std::get_if<int>(&part.which);
  const std::string name = index ? std::to_string(*index) : telar::quoted(std::get<std::string>(part.which));
  return {"E_MEASURE", "the model draws no such part: " + kind + name};
}

Surface buildSurface(const Scene& scene, const SurfaceOptions& options, const CancelToken& cancel) {
  return Builder(scene, options, cancel).build();
}

}  // namespace telar::surface
