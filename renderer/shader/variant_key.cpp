#include "shader/variant_key.h"

namespace telar::shader {

Defines VariantKey::defines() const {
  Defines list;
#define TELAR_FEATURE_DEFINE(glsl, member, name) list.emplace_back(#glsl, member ? 1 : 0);
  TELAR_SURFACE_FEATURES(TELAR_FEATURE_DEFINE)
#undef TELAR_FEATURE_DEFINE
  list.emplace_back("POINT_LIGHTS", lights.point);
  list.emplace_back("SPOT_LIGHTS", lights.spot);
  list.emplace_back("DIRECTIONAL_LIGHTS", lights.directional);
  list.emplace_back("SUNS", lights.suns);
  list.emplace_back("HEMISPHERE_LIGHTS", lights.hemisphere);
  list.emplace_back("RECT_LIGHTS", lights.rect);
  list.emplace_back("DISK_LIGHTS", lights.disk);
  list.emplace_back("CUBE_SHADOWS", lights.pointShadows);
  list.emplace_back("SPOT_SHADOWS", lights.spotShadows);
  list.emplace_back("FLAT_SHADOWS", lights.spotShadows + lights.directionalShadows);
  list.emplace_back("SHADING_THREE", shading == ShadingModel::kThree);
  list.emplace_back("SHADING_PRINCIPLED", isPrincipled(shading));
  list.emplace_back("SHADING_FABRIC", shading == ShadingModel::kFabric);
  list.emplace_back("ALL_TERMS", 0);
#define TELAR_SHADING_DEFINE(glsl, member, ...) list.emplace_back(#glsl "_TERM", terms.member);
  TELAR_SHADING_SLOTS(TELAR_SHADING_DEFINE)
#undef TELAR_SHADING_DEFINE
#define TELAR_THREE_DEFINE(glsl, member, ...) list.emplace_back(#glsl "_TERM", three.member);
  TELAR_THREE_SLOTS(TELAR_THREE_DEFINE)
#undef TELAR_THREE_DEFINE
  list.emplace_back("FULL_DETAIL", fullDetail);
  list.emplace_back("OWN_PLACES", ownPlaces);
  list.emplace_back("ENVIRONMENT_SAMPLES", environmentSamples);
  list.emplace_back("BRIGHT_DIRECTIONS", brightDirections());
  list.emplace_back("TONE_MAPPING", static_cast<int>(toneMapping));
  return list;
}

std::vector<std::string> VariantKey::features() const {
  std::vector<std::string> list;
#define TELAR_FEATURE_NAME(define, member, name) \
  if (member && name[0] != '\0') list.emplace_back(name);
  TELAR_SURFACE_FEATURES(TELAR_FEATURE_NAME)
#undef TELAR_FEATURE_NAME
  const auto count = [&list](int n, const char* what) {
    if (n > 0) list.push_back(std::to_string(n) + " " + what + (n > 1 ? "s" : ""));
  };
  count(lights.point, "point-light");
  count(lights.spot, "spot-light");
  count(lights.directional - lights.suns, "directional-light");
  count(lights.suns, "sun");
  count(lights.hemisphere, "hemisphere-light");
  count(lights.rect, "rect-light");
  count(lights.disk, "disk-light");
  count(lights.pointShadows, "point-shadow");
  count(lights.spotShadows, "spot-shadow");
  count(lights.directionalShadows, "directional-shadow");
  count(environmentSamples, "environment-sample");
  if (toneMapping != ToneMapping::kNone) {
    list.push_back("tone-mapping-" + std::string(namesOf(toneMapping)[static_cast<std::size_t>(toneMapping)]));
  }
  return list;
}

}  // namespace telar::shader
