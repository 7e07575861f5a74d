#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "shot/json_path.h"
#include "shot/visit_rows.inc"
#include "telar/error.h"
#include "telar/part_opacities.h"
#include "telar/shot.h"

namespace telar {
namespace {

using shot::JsonPath;

/// Reads the keys of a struct of telar/shot/, by their types: visitRows() names them.
class Reader {
 public:
  explicit Reader(const JsonPath& json) : json_(json) {}

  template <class Member>
  void operator()(std::string_view key, Member& member) const {
    read(json_.at(key), member);
  }
  void operator()(std::string_view key, int& member, int min, int max) const {
    member = json_.at(key).integer(min, max);
  }
  void operator()(std::string_view key, int& member, std::initializer_list<int> values) const {
    member = json_.at(key).oneOf(values);
  }
  template <class Members>
  void within(std::string_view key, const Members& members) const {
    members(Reader(json_.at(key)));
  }

 private:
  static void read(const JsonPath& json, double& to) { to = json.number(); }
  static void read(const JsonPath& json, bool& to) { to = json.boolean(); }
  static void read(const JsonPath& json, std::string& to) { to = json.string(); }
  static void read(const JsonPath& json, glm::dvec2& to) { to = json.vec2(); }
  static void read(const JsonPath& json, glm::dvec3& to) { to = json.vec3(); }
  static void read(const JsonPath& json, glm::vec3& to) { to = json.color(); }
  static void read(const JsonPath& json, std::optional<double>& to) {
    if (!json.isNull()) to = json.number();
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  static void read(const JsonPath& json, Enum& to) { to = static_cast<Enum>(json.choice(namesOf(Enum()))); }

  const JsonPath& json_;
};

template <class Row>
Row readRow(const JsonPath& json) {
  Row row;
  visitRows(row, Reader(json));
  return row;
}

template <class Row>
std::optional<Row> readOptional(const JsonPath& json) {
  if (json.isNull()) return std::nullopt;
  return readRow<Row>(json);
}

/// Factor on radiance of a lens with shutter and ISO: 1 / (1.2 * 2^EV100), EV100 = log2(N^2 / t * 100 / S).
/// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering", section 5.1.2
double exposureOf(const std::optional<Shot::Lens>& lens) {
  if (!lens || !lens->shutter || !lens->iso) return 1;
  return *lens->shutter * *lens->iso / (120 * lens->aperture * lens->aperture);
}

Shot::Environment readEnvironment(const JsonPath& json) {
  using Source = Shot::Environment::Source;
  Shot::Environment environment{readRow<shot::Environment>(json)};
  const JsonPath map = json.at("map");
  if (map.isObject()) {
    map.at("bytes").number();  // the bytes themselves travel beside the JSON
    environment.source = Source::kBytes;
    return environment;
  }
  const std::string name = map.string();
  environment.source = name == "none" ? Source::kNone : name == "studio" ? Source::kStudio : Source::kPath;
  if (environment.source == Source::kPath) environment.path = name;
  return environment;
}

Shot::Background readBackground(const JsonPath& json) {
  using Type = Shot::Background::Type;
  Shot::Background background;
  if (json.isArray()) {
    background.type = Type::kColor;
    background.color = json.color();
  } else if (json.isObject()) {
    background = {readRow<shot::EnvironmentBackground>(json), Type::kEnvironment};
  } else {
    const std::array<std::string_view, 2> names{"transparent", "environment"};
    background.type = std::array{Type::kTransparent, Type::kEnvironment}[json.choice(names)];
  }
  return background;
}

std::optional<Shot::Ground> readGround(const JsonPath& json) {
  if (json.isObject()) return readRow<Shot::Ground>(json);
  json.choice(std::array<std::string_view, 1>{"none"});
  return std::nullopt;
}

void readQuality(const JsonPath& json, Shot& shot) {
  if (json.has("preset") && json.at("preset").string() == "reference") {
    shot.samples = 1;
    shot.reference = readRow<Shot::Reference>(json);
    shot.noise = shot.reference->noise;
  } else {
    visitRows(static_cast<shot::RasterQuality&>(shot), Reader(json));
    shot.isHigh = json.has("preset") && json.at("preset").string() == "high";
  }
}

std::vector<std::string_view> keysOf(std::span<const std::pair<std::string_view, ShadingModel>> rows) {
  std::vector<std::string_view> keys;
  for (const auto& [key, shading] : rows) keys.push_back(key);
  return keys;
}

/// A name, or a base with every slot: a principled shading, or a release of three.js.
void readShading(const JsonPath& json, Shot& shot) {
  if (!json.isObject()) {
    shot.shading = WHOLE_SHADINGS[json.choice(keysOf(WHOLE_SHADINGS))].second;
    return;
  }
  std::vector bases(PRINCIPLED_SHADINGS.begin(), PRINCIPLED_SHADINGS.end());
  bases.emplace_back("three", ShadingModel::kThree);
  shot.shading = bases[json.at("base").choice(keysOf(bases))].second;
  if (shot.shading == ShadingModel::kThree) {
#define TELAR_THREE_READ(define, member, ...) \
  shot.three.member = static_cast<int>(json.at(#member).choice(std::initializer_list<std::string_view>{__VA_ARGS__}));
    TELAR_THREE_SLOTS(TELAR_THREE_READ)
#undef TELAR_THREE_READ
    return;
  }
#define TELAR_SHADING_READ(define, member, ...) \
  shot.terms.member = static_cast<int>(json.at(#member).choice(std::initializer_list<std::string_view>{__VA_ARGS__}));
  TELAR_SHADING_SLOTS(TELAR_SHADING_READ)
#undef TELAR_SHADING_READ
}

std::vector<Layer> readLayers(const JsonPath& json) {
  std::vector<std::string_view> names{"beauty"};
  for (const std::string_view name : namesOf(Layer())) names.push_back(name);
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (const std::size_t chosen = json.at(i).choice(names)) layers.push_back(static_cast<Layer>(chosen - 1));
  }
  return layers;
}

/// {node} or {material}, by index or name.
PartQuery readPart(const JsonPath& json) {
  PartQuery part;
  if (!json.has("node")) part.kind = PartQuery::Kind::kMaterial;
  const JsonPath which = json.at(part.kind == PartQuery::Kind::kNode ? "node" : "material");
  which.isString() ? part.which = which.string() : part.which = which.integer(0, std::numeric_limits<int>::max());
  return part;
}

Shot::Flat readFlat(const JsonPath& json) {
  Shot::Flat flat{readRow<shot::Flat>(json), {}};
  const JsonPath stitched = json.at("stitched");
  for (std::size_t i = 0; i < stitched.size(); ++i) flat.stitched.push_back(readPart(stitched.at(i)));
  return flat;
}

std::vector<Shot::Ghost> readGhosts(const JsonPath& json) {
  std::vector<Shot::Ghost> ghosts;
  for (std::size_t i = 0; i < json.size(); ++i)
    ghosts.push_back({readPart(json.at(i)), static_cast<float>(json.at(i).at("opacity").number())});
  return ghosts;
}

nlohmann::json parsed(std::string_view text) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception&) {
    throw Error("E_SHOT", "the shot is not JSON: pass what resolveShot returns");
  }
}

Shot readShot(const JsonPath& json) {
  Shot shot;
  const Reader keys(json);
  visitRows(static_cast<shot::Values&>(shot), keys);
  visitRows(static_cast<shot::Size&>(shot), Reader(json.at("size")));
  shot.camera = readRow<Shot::Camera>(json.at("camera"));
  shot.lens = readOptional<Shot::Lens>(json.at("lens"));
  shot.exposure *= exposureOf(shot.lens);
  shot.environment = readEnvironment(json.at("environment"));
  const JsonPath lights = json.at("lights");
  for (std::size_t i = 0; i < lights.size(); ++i) shot.lights.push_back(readRow<Shot::Light>(lights.at(i)));
  shot.background = readBackground(json.at("background"));
  shot.ground = readGround(json.at("ground"));
  readShading(json.at("shading"), shot);
  readQuality(json.at("quality"), shot);
  shot.pose = readOptional<Pose>(json.at("pose"));
  shot.flat = readFlat(json.at("flat"));
  shot.layers = readLayers(json.at("layers"));
  shot.ghost = readGhosts(json.at("ghost"));
  shot.output = readRow<OutputOptions>(json.at("output"));
  if (json.has("debugOutput")) keys("debugOutput", shot.debugOutput);
  return shot;
}

}  // namespace

Shot parseShot(std::string_view resolvedJson) {
  const nlohmann::json root = parsed(resolvedJson);
  return readShot(JsonPath(root));
}

std::vector<Shot::Ghost> parseGhosts(std::string_view json) {
  const nlohmann::json root = parsed(json);
  return readGhosts(JsonPath(root));
}

}  // namespace telar
