// Light that arrives from one direction: point, spot and directional lights. View space; colours are linear Rec.709
// times intensity (candela, candela, lux).
#if POINT_LIGHTS > 0
uniform vec3 pointPosition[POINT_LIGHTS];
uniform vec3 pointColor[POINT_LIGHTS];
uniform float pointRange[POINT_LIGHTS];
#endif
#if SPOT_LIGHTS > 0
uniform vec3 spotPosition[SPOT_LIGHTS];
uniform vec3 spotDirection[SPOT_LIGHTS];  // from the target to the light
uniform vec3 spotColor[SPOT_LIGHTS];
uniform float spotRange[SPOT_LIGHTS];
uniform float spotOuterCos[SPOT_LIGHTS];
uniform float spotInnerCos[SPOT_LIGHTS];
#endif
#if DIRECTIONAL_LIGHTS > 0
uniform vec3 directionalDirection[DIRECTIONAL_LIGHTS];  // to the light
uniform vec3 directionalColor[DIRECTIONAL_LIGHTS];
#endif

struct Reflected {
  vec3 diffuse;
  vec3 specular;
};

#if POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS > 0
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 compensation, vec3 l, vec3 lightColor) {
  float NoL = saturate(dot(s.n, l));
  vec3 h = halfVector(s.n, l, s.v);
  float NoH = saturate(dot(s.n, h));
  float LoH = saturate(dot(s.v, h));
  vec3 irradiance = NoL * lightColor;
  sum.specular += irradiance * Fr_GGX(s.f0, 1.0, s.alpha, s.NoV, NoL, NoH, LoH) * compensation;
  // What the dielectric interface reflects does not reach the diffuse lobe.
  sum.diffuse += irradiance * Fd_Lambert(s.diffuse) * (1.0 - F_Schlick(vec3(F0_DIELECTRIC), 1.0, LoH));
  return sum;
}

Reflected punctualLight(SurfaceInfo s) {
  Reflected sum = Reflected(vec3(0.0), vec3(0.0));
  vec3 compensation = directCompensation(s.f0, s.dfg);
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    vec3 toLight = pointPosition[i] + vViewPosition;
    vec3 color = pointColor[i] * distanceAttenuation(length(toLight), pointRange[i]);
    sum = addPunctual(sum, s, compensation, safeNormalize(toLight, s.n), color);
  }
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) {
    vec3 toLight = spotPosition[i] + vViewPosition;
    vec3 l = safeNormalize(toLight, s.n);
    float cone = spotAttenuation(spotOuterCos[i], spotInnerCos[i], dot(l, spotDirection[i]));
    if (cone > 0.0) {
      vec3 color = spotColor[i] * cone * distanceAttenuation(length(toLight), spotRange[i]);
      sum = addPunctual(sum, s, compensation, l, color);
    }
  }
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS; ++i) {
    sum = addPunctual(sum, s, compensation, directionalDirection[i], directionalColor[i]);
  }
#endif
  return sum;
}
#endif
