// Light from rectangles and disks, by linearly transformed cosines. View space; colours are linear Rec.709 times intensity (nit).
#if RECT_LIGHTS + DISK_LIGHTS > 0
#if RECT_LIGHTS > 0
uniform vec3 rectPosition[RECT_LIGHTS];    // centres
uniform vec3 rectHalfWidth[RECT_LIGHTS];   // from the centre to the middle of an edge
uniform vec3 rectHalfHeight[RECT_LIGHTS];  // it shines towards cross(rectHalfHeight, rectHalfWidth)
uniform vec3 rectColor[RECT_LIGHTS];
#endif
#if DISK_LIGHTS > 0
uniform vec3 diskPosition[DISK_LIGHTS];  // centres
uniform vec3 diskX[DISK_LIGHTS];         // from the centre to the rim
uniform vec3 diskY[DISK_LIGHTS];         // square with it; the disk shines towards cross(diskY, diskX)
uniform vec3 diskColor[DISK_LIGHTS];
#endif
uniform sampler2D ltcInverseMap;  // RGBA = the entries that ltcInverse takes; for both see ltcCoordinates
uniform sampler2D ltcAlbedoMap;   // RG = scale and bias of f0

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
LtcLobe sheenLobe(mat3 frame, SurfaceInfo s) {
  vec3 ltc = sheenLtc(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
  return LtcLobe(mat3(ltc.y, 0.0, 0.0, 0.0, ltc.y, 0.0, ltc.z, 0.0, 1.0) * frame, s.sheenColor * ltc.x);
}
#endif

// As with three.js's rectangles, they have no part in iridescence, anisotropy and rough diffuse; sheen sees them on cloth and in the
// principled shadings.
Reflected addRectLight(Reflected sum, SurfaceInfo s) {
  mat3 frame = ltcFrame(s.n, s.v);
  LtcLobe base = ltcLobe(frame, s.perceptualRoughness, s.NoV, s.f0, s.f90);
#if SHADING_FABRIC
  // What is not reflected at once, and what is left for the diffuse lobe, spread as a cosine.
  base.albedo = glossReflectance(s);
  vec3 spread = s.diffuse * s.leaving + s.returning * s.albedo.x;
#if SHEEN
  LtcLobe sheen = sheenLobe(frame, s);
#endif
#elif SHADING_PRINCIPLED
  // Gloss and coat spread as the tables have it, the other lobes as a cosine; each of the albedo that the model gives it.
  float under = underCoatToViewer(s);
  base.albedo *= under * glossOfArea(s);
  vec3 spread = under * diffuseAlbedoTerm(s);
#if SHEEN
  vec3 fuzz = under * s.sheenColor * sheenAlbedoTerm(s);
#endif
#else
  vec3 spread = s.diffuse;
#endif
#if CLEARCOAT
  LtcLobe coat = ltcLobe(ltcFrame(s.coatNormal, s.v), s.clearcoatRoughness, s.clearcoatNoV, vec3(F0_DIELECTRIC), 1.0);
#if SHADING_PRINCIPLED
  coat.albedo = vec3(coatAlbedoTerm(s));
#endif
#endif
  vec3 p = -vViewPosition;
#if RECT_LIGHTS > 0
  for (int i = 0; i < RECT_LIGHTS; ++i) {
    vec3 a = rectPosition[i] + rectHalfWidth[i] - rectHalfHeight[i];
    vec3 b = rectPosition[i] - rectHalfWidth[i] - rectHalfHeight[i];
    vec3 c = rectPosition[i] - rectHalfWidth[i] + rectHalfHeight[i];
    vec3 d = rectPosition[i] + rectHalfWidth[i] + rectHalfHeight[i];
    if (dot(cross(b - a, d - a), p - a) < 0.0) continue;  // behind it
    a -= p;
    b -= p;
    c -= p;
    d -= p;
    sum.specular += rectColor[i] * base.albedo * ltcRectangle(base.toLobe, a, b, c, d);
#if SHADING_FABRIC && SHEEN
    sum.sheen += rectColor[i] * sheen.albedo * ltcRectangle(sheen.toLobe, a, b, c, d);
#endif
    float cosineLobe = ltcRectangle(frame, a, b, c, d);
    sum.diffuse += rectColor[i] * spread * cosineLobe;
#if SHADING_PRINCIPLED && SHEEN
    sum.sheen += rectColor[i] * fuzz * cosineLobe;
#endif
#if CLEARCOAT
    sum.coat += rectColor[i] * coat.albedo * ltcRectangle(coat.toLobe, a, b, c, d);
#endif
  }
#endif
#if DISK_LIGHTS > 0
  for (int i = 0; i < DISK_LIGHTS; ++i) {
    vec3 centre = diskPosition[i] - p;
    if (dot(cross(diskY[i], diskX[i]), centre) > 0.0) continue;  // behind it
    sum.specular += diskColor[i] * base.albedo * ltcDisk(base.toLobe, centre, diskX[i], diskY[i]);
#if SHADING_FABRIC && SHEEN
    sum.sheen += diskColor[i] * sheen.albedo * ltcDisk(sheen.toLobe, centre, diskX[i], diskY[i]);
#endif
    float cosineOfDisk = ltcDisk(frame, centre, diskX[i], diskY[i]);
    sum.diffuse += diskColor[i] * spread * cosineOfDisk;
#if SHADING_PRINCIPLED && SHEEN
    sum.sheen += diskColor[i] * fuzz * cosineOfDisk;
#endif
#if CLEARCOAT
    sum.coat += diskColor[i] * coat.albedo * ltcDisk(coat.toLobe, centre, diskX[i], diskY[i]);
#endif
  }
#endif
  return sum;
}
#endif
