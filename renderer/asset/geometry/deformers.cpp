#include "asset/geometry/deformers.h"

#include <algorithm>
#include <cmath>

#include "asset/check/pointer.h"
#include "asset/geometry/repair.h"

namespace telar::asset {
namespace {

constexpr const char* JOINTS = "JOINTS_0";
constexpr const char* WEIGHTS = "WEIGHTS_0";

/// Steps from 0 to 1 of a normalized integer; 0 for floats.
double stepsOf(int componentType) {
  if (componentType == COMPONENT_F32) return 0;
  return componentType == COMPONENT_U8 ? 255 : 65535;
}

/// Divided by the sum of their sizes and kept in the file's own precision, as GLTFLoader does.
/// @return whether the weights were finite
bool normalize(glm::vec4& weights, int componentType) {
  const double steps = stepsOf(componentType);
  const glm::dvec4 exact = steps == 0 ? glm::dvec4(weights) : glm::round(glm::dvec4(weights) * steps) / steps;
  const double sum = std::abs(exact.x) + std::abs(exact.y) + std::abs(exact.z) + std::abs(exact.w);
  if (!std::isfinite(sum) || sum == 0) {
    weights = {1, 0, 0, 0};
    return sum == 0;
  }
  const glm::dvec4 scaled = exact * (1 / sum);
  for (int k = 0; k < 4; ++k) {
    const double whole = steps == 0 ? scaled[k] : std::floor(scaled[k] * steps + 0.5);
    weights[k] = fromComponent(whole, componentType, true, Normalizing::kFetched);
  }
  return true;
}

}  // namespace

int DeformerReader::attribute(const std::string& name) const {
  const auto found = source_.attributes.find(name);
  return found == source_.attributes.end() ? -1 : found->second;
}

bool DeformerReader::anyTargetHas(const std::string& name) const {
  return std::any_of(source_.targets.begin(), source_.targets.end(),
                     [&](const auto& target) { return target.contains(name); });
}

void DeformerReader::checkTarget(const std::string& name, int accessor, const std::string& where) const {
  const unsigned components = accessors_.components(accessor);
  const auto& info = accessors_.info(accessor);
  const bool vector = info.type == TINYGLTF_TYPE_VEC3 || (info.type == TINYGLTF_TYPE_VEC4 && name == "COLOR_0");
  if (!vector || components < 3 || info.componentType == COMPONENT_U32) {
    fail("E_ACCESSOR", "the accessor has a type that this attribute of a morph target cannot have", where);
  }
  if (info.count != accessors_.count(attribute("POSITION"))) {
    fail("E_ACCESSOR",
         "the morph target moves " + std::to_string(info.count) + " vertices, the primitive has another number", where);
  }
}

void DeformerReader::check() const {
  for (std::size_t i = 0; i < source_.targets.size(); ++i) {
    for (const auto& [name, accessor] : source_.targets[i]) {
      if (name != "POSITION" && name != "NORMAL" && name != "COLOR_0") continue;
      checkTarget(name, accessor, where_ + pointer("targets", i, name));
    }
  }
  if (skinned()) checkSkin();
}

bool DeformerReader::skinned() const { return joints_ > 0 && attribute(JOINTS) >= 0 && attribute(WEIGHTS) >= 0; }

std::uint64_t DeformerReader::bytes() const {
  const std::uint64_t vertices = accessors_.count(attribute("POSITION"));
  std::uint64_t skin = 0, target = 0;
  if (skinned()) skin = sizeof(glm::vec4) + sizeof(glm::u16vec4);
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) target += anyTargetHas(name) ? sizeof(glm::vec4) : 0;
  return vertices * (skin + target * source_.targets.size());
}

void DeformerReader::checkSkin() const {
  for (const char* name : {JOINTS, WEIGHTS}) {
    const int accessor = attribute(name);
    const std::string where = where_ + pointer("attributes", name);
    const auto& info = accessors_.info(accessor);
    const bool integers = info.componentType == COMPONENT_U8 || info.componentType == COMPONENT_U16;
    if (name == JOINTS && (info.type != TINYGLTF_TYPE_VEC4 || !integers || info.normalized)) {
      fail("E_SKIN", "joint indices must be VEC4 of unsigned bytes or shorts", where);
    }
    const bool fractions = info.componentType == COMPONENT_F32 || (integers && info.normalized);
    if (name == WEIGHTS && (info.type != TINYGLTF_TYPE_VEC4 || !fractions)) {
      fail("E_SKIN", "skin weights must be VEC4 of floats or normalized unsigned integers", where);
    }
    if (info.count != accessors_.count(attribute("POSITION"))) {
      fail("E_ACCESSOR", "the accessor has another number of elements than POSITION", where);
    }
  }
}

void DeformerReader::readSkin(const StreamReader& stream, Deformers& out) const {
  const std::size_t vertices = accessors_.count(attribute("POSITION"));
  std::vector<glm::vec4> read(vertices);
  stream(JOINTS, floatsOf(read));
  out.joints.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    for (int k = 0; k < 4; ++k) {
      if (!(read[i][k] >= 0 && read[i][k] < static_cast<float>(joints_))) {
        fail("E_SKIN", "a vertex names a joint that the skin does not have", where_ + pointer("attributes", JOINTS));
      }
      out.joints[i][k] = static_cast<std::uint16_t>(read[i][k]);
    }
  }
  cancel_.check();
  stream(WEIGHTS, floatsOf(read));
  const int componentType = accessors_.info(attribute(WEIGHTS)).componentType;
  std::size_t unusable = 0;
  for (glm::vec4& weights : read) unusable += !normalize(weights, componentType);
  if (unusable > 0) {
    warnings_.add("W_NONFINITE",
                  std::to_string(unusable) + " vertices have skin weights that are not finite; they follow one joint",
                  where_);
  }
  out.weights = std::move(read);
  if (attribute("JOINTS_1") >= 0) {
    warnings_.add("W_SKIN", "only the first four joints of each vertex are applied, as three.js does", where_);
  }
}

/// An attribute that other targets have and this one lacks is the primitive's own, as GLTFLoader fills it in: it then
/// grows by itself.
MorphTarget DeformerReader::readTarget(const std::map<std::string, int>& target, const Primitive& base) const {
  MorphTarget out;
  const std::size_t vertices = base.positions.size();
  const auto readVectors = [&](const char* name, const std::vector<glm::vec3>& own) {
    const auto found = target.find(name);
    if (found == target.end()) return own;
    std::vector<glm::vec3> stream(vertices);
    accessors_.readFloats(found->second, floatsOf(stream));
    return stream;
  };
  if (anyTargetHas("POSITION")) out.positions = readVectors("POSITION", base.positions);
  if (anyTargetHas("NORMAL") && !base.normals.empty()) out.normals = readVectors("NORMAL", base.normals);
  if (!anyTargetHas("COLOR_0") || base.colors.empty()) return out;
  const auto found = target.find("COLOR_0");
  if (found == target.end()) {
    out.colors = base.colors;
  } else if (accessors_.components(found->second) == 4) {
    out.colors.resize(vertices);
    accessors_.readFloats(found->second, floatsOf(out.colors));
  } else {
    // three.js takes the alpha of an RGB target for 1, so that alpha grows with the weight.
    for (const glm::vec3& rgb : readVectors("COLOR_0", {})) out.colors.emplace_back(rgb, 1.0f);
  }
  if (!base.colorsHaveAlpha) {
    for (glm::vec4& color : out.colors) color.a = 0;
  }
  return out;
}

void DeformerReader::readTargets(const Primitive& base, Deformers& out) const {
  std::size_t unusable = 0;
  for (const auto& target : source_.targets) {
    cancel_.check();
    out.targets.push_back(readTarget(target, base));
    const auto& offsets = out.targets.back().positions;
    unusable += !std::all_of(offsets.begin(), offsets.end(), isFinite);
  }
  if (unusable > 0) {
    warnings_.add("W_NONFINITE",
                  std::to_string(unusable) + " morph targets move vertices to places that are not finite",
                  where_ + "/targets");
  }
  if (anyTargetHas("TANGENT") && !base.tangents.empty()) {
    warnings_.add("W_MORPH", "morph targets do not change tangents, as in three.js", where_ + "/targets");
  }
}

std::shared_ptr<const Deformers> DeformerReader::read(const Primitive& base, const StreamReader& stream) const {
  Deformers out;
  const bool skin = skinned() && base.topology == Topology::kTriangles;  // three.js skins nothing else
  if (skin) readSkin(stream, out);
  const bool morph = anyTargetHas("POSITION") || anyTargetHas("NORMAL") || anyTargetHas("COLOR_0");
  if (morph) readTargets(base, out);
  return skin || morph ? std::make_shared<const Deformers>(std::move(out)) : nullptr;
}

}  // namespace telar::asset
