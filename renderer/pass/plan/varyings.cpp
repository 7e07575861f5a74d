#include "pass/plan/varyings.h"

#include <algorithm>
#include <cctype>

#include "telar/error.h"

namespace telar::pass {
namespace {

constexpr std::string_view DECLARATION = "void readVaryings();\n";

/// "normalMap" to "vNormalUv".
std::string uvName(const TextureSlot& slot) {
  std::string name = slot.sampler;
  name.resize(name.size() - std::string_view("Map").size());
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return "v" + name + "Uv";
}

std::string component(std::size_t i) { return "t" + std::to_string(i / 4) + "." + "xyzw"[i % 4]; }

/// A vector of components from i on.
std::string vectorAt(std::size_t& i, int components) {
  std::string out = "vec" + std::to_string(components) + "(";
  for (int c = 0; c < components; ++c) out += (c > 0 ? ", " : "") + component(i++);
  return out + ")";
}

}  // namespace

std::vector<Varying> varyingsOf(const shader::VariantKey& key) {
  std::vector<Varying> out{{"vViewPosition", 3}};
  if (!key.flatShaded && !key.unlit) {
    out.push_back({"vNormal", 3});
    if (key.tangent) {
      out.push_back({"vTangent", 3});
      out.push_back({"vBitangent", 3});
    }
  }
  if (key.vertexColor) out.push_back({"vColor", 4});
  if (key.tangentFrameUv0) out.push_back({"vUv0", 2});
  if (key.ambientVisibility) {
    out.push_back({"vVisibility", 4});
    if (key.ambientVisibilityBack) out.push_back({"vVisibilityBack", 4});
  }
  std::vector<std::size_t> varyingOf;  // of each map
  for (const TextureSlot& slot : TEXTURE_SLOTS) {
    if (!(key.*slot.map)) continue;
    const std::size_t map = varyingOf.size();
    if (map < key.uvOf.size() && key.uvOf[map] < map) {
      varyingOf.push_back(varyingOf[key.uvOf[map]]);
      out[varyingOf.back()].same.push_back(uvName(slot));
    } else {
      varyingOf.push_back(out.size());
      out.push_back({uvName(slot), 2});
    }
  }
  const int flat = key.lights.spotShadows + key.lights.directionalShadows, cube = key.lights.pointShadows;
  if (flat > 0) out.push_back({"vFlatShadowCoord", 4 * flat, flat});
  if (cube > 0) out.push_back({"vCubeShadowCoord", 4 * cube, cube});
  return out;
}

std::size_t uvComponent(const shader::VariantKey& key, const TextureSlot& slot) {
  const std::string name = uvName(slot);
  std::size_t at = 0;
  for (const Varying& varying : varyingsOf(key)) {
    if (varying.name == name || std::ranges::find(varying.same, name) != varying.same.end()) return at;
    at += static_cast<std::size_t>(varying.components);
  }
  throw Error("X_SHADER", "no varying has the coordinates of " + std::string(slot.sampler));
}

std::vector<std::uint8_t> sharedUvs(const Material& material, const shader::VariantKey& key) {
  std::vector<const TextureSlot*> slots;
  for (const TextureSlot& slot : TEXTURE_SLOTS) {
    if (key.*slot.map) slots.push_back(&slot);
  }
  std::vector<std::uint8_t> out;
  for (const TextureSlot* slot : slots) {
    const auto isSame = [&](const TextureSlot* other) {
      return key.*slot->uv1 == key.*other->uv1 &&
             slot->texture(material).uvTransform == other->texture(material).uvTransform;
    };
    out.push_back(static_cast<std::uint8_t>(std::ranges::find_if(slots, isSame) - slots.begin()));
  }
  return out;
}

std::size_t factsOf(const shader::VariantKey& key) {
  if (key.environmentSamples > 0 || key.lights.shadows() > 0) return 3;
  return key.shading != ShadingModel::kThree || key.doubleSided || key.back || key.bump ? 1 : 0;
}

std::size_t componentsOf(const std::vector<Varying>& varyings) {
  std::size_t count = 0;
  for (const Varying& varying : varyings) count += static_cast<std::size_t>(varying.components);
  return count;
}

std::size_t texelsOf(const shader::VariantKey& key) { return (componentsOf(varyingsOf(key)) + factsOf(key) + 3) / 4; }

std::string withVaryings(std::string source, const shader::VariantKey& key) {
  const std::vector<Varying> varyings = varyingsOf(key);
  const std::size_t texels = texelsOf(key);
  std::string text = "void readVaryings() {\n";
  for (std::size_t i = 0; i < texels; ++i)
    text += "  vec4 t" + std::to_string(i) + " = varyingTexel(" + std::to_string(i) + ");\n";
  std::size_t at = 0;
  for (const Varying& varying : varyings) {
    if (varying.elements == 0) text += "  " + varying.name + " = " + vectorAt(at, varying.components) + ";\n";
    for (const std::string& other : varying.same) text += "  " + other + " = " + varying.name + ";\n";
    for (int i = 0; i < varying.elements; ++i)
      text += "  " + varying.name + "[" + std::to_string(i) +
              "] = " + vectorAt(at, varying.components / varying.elements) + ";\n";
  }
  const std::size_t facts = factsOf(key);
  if (facts > 0) text += "  triangleFront = " + component(at++) + " > 0.0;\n";
  if (facts > 1) text += "  trianglePixel = " + vectorAt(at, 2) + ";\n";
  text += "}\n";
  const std::size_t place = source.find(DECLARATION);
  if (place == std::string::npos) throw Error("X_SHADER", "surface.frag does not read varyings");
  return source.replace(place, DECLARATION.size(), text);
}

}  // namespace telar::pass
