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

// Light that leaves the surface towards the viewer, by lobe, linear Rec.709.
struct Reflected {
  vec3 diffuse;
  vec3 specular;
#if SHEEN
  vec3 sheen;
#endif
#if CLEARCOAT
  vec3 coat;
#endif
};

Reflected nothingReflected() {
  Reflected nothing;
  nothing.diffuse = nothing.specular = vec3(0.0);
#if SHEEN
  nothing.sheen = vec3(0.0);
#endif
#if CLEARCOAT
  nothing.coat = vec3(0.0);
#endif
  return nothing;
}

#if POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS > 0
// GGX lobe of the base layer, [1/sr].
vec3 specularLobe(SurfaceInfo s, vec3 l, vec3 h, float NoL, float NoH, float LoH) {
#if ANISOTROPY || IRIDESCENCE
  vec3 fresnel = F_Schlick(s.f0, s.f90, LoH);
#if IRIDESCENCE
  fresnel = mix(fresnel, s.filmFresnel, s.iridescence);
#endif
#if ANISOTROPY
  float alphaT = max(s.alphaT, s.alpha);
  float visibility = V_SmithGGXCorrelatedAnisotropic(alphaT, s.alpha, s.NoV, NoL, dot(s.t, s.v), dot(s.b, s.v), dot(s.t, l), dot(s.b, l));
  float distribution = D_GGXAnisotropic(alphaT, s.alpha, NoH, dot(s.t, h), dot(s.b, h));
#else
  float visibility = V_SmithGGXCorrelated(s.alpha, s.NoV, NoL);
  float distribution = D_GGX(s.alpha, NoH);
#endif
  return fresnel * (visibility * distribution);
#else
  return Fr_GGX(s.f0, s.f90, s.alpha, s.NoV, NoL, NoH, LoH);
#endif
}

Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 compensation, vec3 l, vec3 lightColor) {
  float NoL = saturate(dot(s.n, l));
  vec3 h = halfVector(s.n, l, s.v);
  float NoH = saturate(dot(s.n, h));
  float LoH = saturate(dot(s.v, h));
  vec3 irradiance = NoL * lightColor;
#if CLEARCOAT
  float coatNoL = saturate(dot(s.coatNormal, l));
  float coatNoH = saturate(dot(s.coatNormal, h));
  sum.coat += coatNoL * lightColor *
              Fr_GGX(vec3(F0_DIELECTRIC), 1.0, alphaFromRoughness(s.clearcoatRoughness), s.clearcoatNoV, coatNoL, coatNoH, LoH);
#endif
#if SHEEN
  sum.sheen += irradiance * Fr_Sheen(s.sheenColor, s.sheenRoughness, s.NoV, NoL, NoH);
  irradiance *= 1.0 - max3(s.sheenColor) * max(sheenAlbedo(s.sheenRoughness, s.NoV), sheenAlbedo(s.sheenRoughness, NoL));
#endif
  sum.specular += irradiance * specularLobe(s, l, h, NoL, NoH, LoH) * compensation;
  // What the dielectric interface reflects does not reach the diffuse lobe.
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = Fd_EON(s.baseColor, s.diffuseRoughness, s.NoV, NoL, dot(l, s.v)) * (1.0 - s.metallic);
#else
  vec3 diffuse = Fd_Lambert(s.diffuse);
#endif
  sum.diffuse += irradiance * diffuse * (1.0 - F_Schlick(s.f0Dielectric, s.f90, LoH));
  return sum;
}

// To a light on the shaded point itself: none, so that it gives nothing, as it does to the points around.
const vec3 NO_DIRECTION = vec3(0.0);

Reflected punctualLight(SurfaceInfo s) {
  Reflected sum = nothingReflected();
  vec3 compensation = directCompensation(s.f0, s.dfg);
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    vec3 toLight = pointPosition[i] + vViewPosition;
    vec3 color = pointColor[i] * distanceAttenuation(length(toLight), pointRange[i]);
    sum = addPunctual(sum, s, compensation, safeNormalize(toLight, NO_DIRECTION), color);
  }
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) {
    vec3 toLight = spotPosition[i] + vViewPosition;
    vec3 l = safeNormalize(toLight, NO_DIRECTION);
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
