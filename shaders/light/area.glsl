// Light from rectangles and disks, by linearly transformed cosines. View space; colours are linear Rec.709 times intensity (nit).
#if RECT_LIGHTS + DISK_LIGHTS > 0
struct AreaLight {
  vec3 centre;
  vec3 alongX;  // from the centre to the middle of an edge, or to the rim; it shines towards cross(alongY, alongX)
  vec3 alongY;
  vec3 color;
  bool isDisk;
};

#include "light/area_inputs.glsl"

// A lobe as the tables hold it.
struct LtcLobe {
  mat3 toLobe;
  vec3 albedo;
};

LtcLobe ltcLobe(mat3 frame, float perceptualRoughness, float NoV, vec3 f0, float f90) {
  vec2 uv = ltcCoordinates(perceptualRoughness, NoV);
  return LtcLobe(ltcInverse(texture(ltcInverseMap, uv)) * frame, ltcAlbedo(f0, f90, texture(ltcAlbedoMap, uv).rg));
}

#if SHADING_FABRIC && SHEEN
// The sheen lobe of cloth is a linearly transformed cosine by itself.
LtcLobe sheenLtcLobe(mat3 frame, SurfaceInfo s) {
  vec3 ltc = sheenLtc(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
  return LtcLobe(mat3(ltc.y, 0.0, 0.0, 0.0, ltc.y, 0.0, ltc.z, 0.0, 1.0) * frame, s.sheenColor * ltc.x);
}
#endif

// The lobes of a surface under an area light, each with its own form factor.
struct AreaLobes {
  mat3 frame;   // of the cosine lobe
  vec3 spread;  // albedo of the cosine lobe
  LtcLobe base;
#if SHADING_FABRIC && FACETS
  LtcLobe edges;
#endif
#if SHADING_FABRIC && SHEEN
  LtcLobe sheen;
#elif SHADING_PRINCIPLED && SHEEN
  vec3 fuzz;    // albedo of the sheen, a cosine lobe too
#endif
#if CLEARCOAT && THREE_RECT_COAT_TERM == THREE_RECT_COAT_OWN_LOBE
  LtcLobe coat;
#endif
};

AreaLobes areaLobes(SurfaceInfo s) {
  AreaLobes lobes;
  lobes.frame = ltcFrame(s.n, s.v);
  lobes.base = ltcLobe(lobes.frame, s.perceptualRoughness, s.NoV, s.f0, s.f90);
#if THREE_RECT_F90_TERM == THREE_RECT_F90_ONE
  lobes.base.albedo = ltcAlbedoToWhite(s.f0, texture(ltcAlbedoMap, ltcCoordinates(s.perceptualRoughness, s.NoV)).rg);
#endif
#if SHADING_FABRIC
  // Multiple scattering and the diffuse lobe both leave as a cosine lobe.
  lobes.base.albedo = glossReflectance(s);
  lobes.spread = s.diffuse * s.leaving + glossReturn(s);
#if FACETS
  lobes.edges = ltcLobe(ltcFrame(s.edges.n, s.v), sqrt(EDGE_ALPHA), s.edges.NoV, s.f0, s.f90);
  lobes.edges.albedo = s.edges.reflectance;
#endif
#if SHEEN
  lobes.sheen = sheenLtcLobe(lobes.frame, s);
#endif
#elif SHADING_PRINCIPLED
  // The tables hold the specular and the clearcoat lobe. The others are cosine lobes. Each has the albedo of its model.
  float under = underCoatToViewer(s);
  lobes.base.albedo *= under * glossOfArea(s);
  lobes.spread = under * diffuseAlbedoTerm(s);
#if SHEEN
  lobes.fuzz = under * s.sheenColor * sheenAlbedoTerm(s);
#endif
#else
  lobes.spread = s.diffuse;
#endif
#if CLEARCOAT && THREE_RECT_COAT_TERM == THREE_RECT_COAT_OWN_LOBE
  lobes.coat = ltcLobe(ltcFrame(s.coatNormal, s.v), s.clearcoatRoughness, s.clearcoatNoV, vec3(F0_DIELECTRIC), 1.0);
#if SHADING_PRINCIPLED
  lobes.coat.albedo = vec3(coatAlbedoTerm(s));
#endif
#endif
  return lobes;
}

// Form factor of a light for the surface at p.
float formFactor(mat3 toLobe, AreaLight light, vec3 p) {
#if DISK_LIGHTS > 0
  if (light.isDisk) return ltcDisk(toLobe, light.centre - p, light.alongX, light.alongY);
#endif
  vec3 a = light.centre + light.alongX - light.alongY;
  vec3 b = light.centre - light.alongX - light.alongY;
  vec3 c = light.centre - light.alongX + light.alongY;
  vec3 d = light.centre + light.alongX + light.alongY;
  return ltcRectangle(toLobe, a - p, b - p, c - p, d - p);
}

Reflected addArea(Reflected sum, AreaLobes lobes, AreaLight light, vec3 p) {
  sum.specular += light.color * lobes.base.albedo * formFactor(lobes.base.toLobe, light, p);
#if SHADING_FABRIC && FACETS
  sum.specular += light.color * lobes.edges.albedo * formFactor(lobes.edges.toLobe, light, p);
#endif
#if SHADING_FABRIC && SHEEN
  sum.sheen += light.color * lobes.sheen.albedo * formFactor(lobes.sheen.toLobe, light, p);
#endif
  float cosineLobe = formFactor(lobes.frame, light, p);
  sum.diffuse += light.color * lobes.spread * cosineLobe;
#if SHADING_PRINCIPLED && SHEEN
  sum.sheen += light.color * lobes.fuzz * cosineLobe;
#endif
#if CLEARCOAT && THREE_RECT_COAT_TERM == THREE_RECT_COAT_OWN_LOBE
  sum.coat += light.color * lobes.coat.albedo * formFactor(lobes.coat.toLobe, light, p);
#endif
  return sum;
}

// As in three.js, area lights leave out iridescence, anisotropy and rough diffuse. Sheen reflects them in the shading "fabric" and
// in the principled shadings.
Reflected addAreaLight(Reflected sum, SurfaceInfo s) {
  AreaLobes lobes = areaLobes(s);
  vec3 p = -vViewPosition;
#if RECT_LIGHTS > 0
  for (int i = 0; i < RECT_LIGHTS; ++i) {
    AreaLight light = rectLight(i);
    vec3 a = light.centre + light.alongX - light.alongY;
    vec3 b = light.centre - light.alongX - light.alongY;
    vec3 d = light.centre + light.alongX + light.alongY;
    if (dot(cross(b - a, d - a), p - a) < 0.0) continue;  // behind it, as three r187 tells
    sum = addArea(sum, lobes, light, p);
  }
#endif
#if DISK_LIGHTS > 0
  for (int i = 0; i < DISK_LIGHTS; ++i) {
    AreaLight light = AreaLight(diskPosition[i], diskX[i], diskY[i], diskColor[i], true);
    if (dot(cross(light.alongY, light.alongX), light.centre - p) > 0.0) continue;  // behind it
    sum = addArea(sum, lobes, light, p);
  }
#endif
  return sum;
}
#endif
