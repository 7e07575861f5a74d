// The shading normal of a fragment, view space.

struct Normals {
  vec3 geometric;  // interpolated (or of the flat face), turned to the viewer on double-sided surfaces
  vec3 shading;    // after the normal map
};

#if NORMAL_MAP && !TANGENT
// Tangent frame from screen-space derivatives; not orthonormal, both axes share one scale.
// p  view-space position      n  unit normal      uv  texture coordinates
// src: Mikkelsen 2020, "Surface Gradient-Based Bump Mapping Framework" by way of Schueler 2013, "Normal Mapping Without
//      Precomputed Tangents"; order of three r187
mat3 derivativeFrame(vec3 p, vec3 n, vec2 uv) {
  vec3 q0 = dFdx(p);
  vec3 q1 = dFdy(p);
  vec2 st0 = dFdx(uv);
  vec2 st1 = dFdy(uv);
  vec3 q1perp = cross(q1, n);
  vec3 q0perp = cross(n, q0);
  vec3 t = q1perp * st0.x + q0perp * st1.x;
  vec3 b = q1perp * st0.y + q0perp * st1.y;
  float det = max(dot(t, t), dot(b, b));
  float scale = det == 0.0 ? 0.0 : inversesqrt(det);
  return mat3(t * scale, b * scale, n);
}
#endif

Normals shadingNormals() {
  float faceDirection = gl_FrontFacing ? 1.0 : -1.0;
#if FLAT_SHADED
  vec3 n = normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
#else
  vec3 n = normalize(vNormal);
#if DOUBLE_SIDED
  n *= faceDirection;
#endif
#endif
#if NORMAL_MAP
#if TANGENT && !FLAT_SHADED
  mat3 tbn = mat3(normalize(vTangent), normalize(vBitangent), n);
#else
  mat3 tbn = derivativeFrame(-vViewPosition, n, vNormalUv);
#endif
#if DOUBLE_SIDED
  tbn[0] *= faceDirection;
  tbn[1] *= faceDirection;
#endif
  vec3 texel = texture(normalMap, vNormalUv).xyz * 2.0 - 1.0;
  texel.xy *= normalScale;
  return Normals(n, normalize(tbn * texel));
#else
  return Normals(n, n);
#endif
}
