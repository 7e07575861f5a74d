// The shading normal of a fragment and the frame that normal maps and stretched highlights stand in, view space.

#define TANGENT_FRAME (NORMAL_MAP || CLEARCOAT_NORMAL_MAP || ANISOTROPY || WEAVE)

#if TANGENT_FRAME
// Tangent frame from screen-space derivatives: the gradients of u and v on the surface, by one scale so that the longer is of
// unit length, and n. Not orthonormal. Where u and v do not change, the gradients are 0.
// p  view-space position      n  unit normal      uv  texture coordinates
// src: Schueler 2013, "Followup: Normal Mapping Without Precomputed Tangents"
mat3 derivativeFrame(vec3 p, vec3 n, vec2 uv) {
  // Columns: gradients of the screen's x and y on the surface, times the area that a pixel covers there.
  mat2x3 ofScreen = mat2x3(cross(dFdy(p), n), cross(n, dFdx(p)));
  vec3 ofU = ofScreen * vec2(dFdx(uv.x), dFdy(uv.x));
  vec3 ofV = ofScreen * vec2(dFdx(uv.y), dFdy(uv.y));
  float longest2 = max(dot(ofU, ofU), dot(ofV, ofV));
  float unit = longest2 > 0.0 ? inversesqrt(longest2) : 0.0;
  return mat3(ofU * unit, ofV * unit, n);
}

// The tangents of the vertices where there are any, else derivatives of the coordinates of one texture. A tangent without length
// counts as none: normalize() would give NaN for it, and so for the whole triangle.
mat3 tangentFrame(vec3 n, vec2 uv, float faceDirection) {
#if TANGENT
  mat3 frame = mat3(normalize(vTangent), normalize(vBitangent), n);
  if (!(dot(vTangent, vTangent) > 0.0 && dot(vBitangent, vBitangent) > 0.0)) {
    frame = derivativeFrame(-vViewPosition, n, uv);
    frame[1] = -frame[1];  // vertex tangents have the texture's v upwards
  }
#else
  mat3 frame = derivativeFrame(-vViewPosition, n, uv);
#endif
#if DOUBLE_SIDED
  frame[0] *= faceDirection;
  frame[1] *= faceDirection;
#endif
  return frame;
}

#if NORMAL_VARIANCE
// Colour of a plain normal map for a texel of a map of relief (texture/relief_level.frag).
vec3 plainNormalTexel(vec4 texel) { return 0.5 + 0.5 * texel.rgb; }

#if NORMAL_HOLES
// A map of relief where a share of the texel is there: holes lie flat in it (texture/relief.glsl).
vec4 withoutHoles(vec4 texel, float share) {
  share = max(share, 0.02);
  return (texel - (1.0 - share) * vec4(0.0, 0.0, 1.0, 1.0)) / share;
}
#endif

// Normals::relief. The rounding of half floats is taken off, so that one texel alone has none.
vec2 reliefOf(vec4 texel, vec2 scale) {
  float scale2 = 0.5 * dot(scale, scale);
  float length2 = min(dot(texel.rgb, texel.rgb) * (1.0 + 1.0 / 512.0), 1.0);
  float lean2 = (1.0 / max(length2, 1.0e-4) - 1.0) * scale2;
  float mean2 = dot(texel.rg, texel.rg) / max(texel.b * texel.b, 1.0e-4);
  float squares = 0.25 * (1.0 / max(texel.a, 1.0e-3) - 1.0) * (1.0 - 1.0 / 256.0);
  return vec2(1.0 - inversesqrt(1.0 + lean2), max(squares - mean2, 0.0) * scale2);
}
#endif

#if FACETS
// Polished maps are read from a finer level, by this bias. Between texels as large as a pixel the sampler averages over two pixels,
// between texels half as large over one. The half level beyond that was tried: it does not flicker more than the exact picture.
const float FACET_LOD_BIAS = -1.5;

// Texels along the longer side of a pixel up to which facets are shaded place by place; where there are twice as many, none is.
const float FACET_TEXELS = 12.0;

// Share of the facets' variance that is kept there. A pixel shows a few facets, and most of the variance of a level is between its
// texels, which are shaded one by one.
const float FACET_VARIANCE_KEPT = 0.4;

// Splits what a pixel has of a polished normal map into flat facets and edges. Where a texel has no flat part, its one lobe is that of
// its edges.
// texel  of texture/facets.glsl      averaged  how far it is of a level above the first, [0, 1]: between texels of the first one the
//        slopes run on, and do not vary
// src: Han et al. 2007, "Frequency Domain Normal Map Filtering": a mixture of lobes for what a pixel has of a normal map
Normals withFacets(Normals normals, mat3 frame, vec4 texel, float averaged, vec2 scale) {
  float scale2 = 0.5 * dot(scale, scale);
  float share = max(texel.b, FACET_SHARE_MIN);  // but for rounding, no mean is below it
  vec2 slope = texel.rg / share;
  float slope2 = texel.a / share;
  normals.shading = safeNormalize(frame * vec3(slope * scale, 1.0), frame[2]);
  normals.relief.y = max(slope2 - dot(slope, slope), 0.0) * (scale2 * averaged);
  normals.edgeShare = edgeShare(share, slope2) * averaged;
  normals.relief.x = normals.edgeShare * (1.0 - inversesqrt(1.0 + pow2(EDGE_ALPHA)));
  return normals;
}
#endif

// A texel without a direction leaves the surface as it is.
vec3 mappedNormal(mat3 frame, vec3 texel, vec2 scale) {
  vec3 n = texel * 2.0 - 1.0;
  n.xy *= scale;
  n = frame * n;
  return dot(n, n) > 0.0 ? normalize(n) : frame[2];
}
#endif

// Between vertices with opposite normals there is a normal of no length. The direction to the viewer stands in for it.
vec3 unitNormal(vec3 n) {
  return dot(n, n) > 0.0 ? normalize(n) : viewDirection();
}

Normals shadingNormals() {
  float faceDirection = frontFacing() ? 1.0 : -1.0;
  Normals normals;
#if FLAT_SHADED
  normals.geometric = unitNormal(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
#else
  normals.geometric = unitNormal(vNormal);
#if DOUBLE_SIDED
  normals.geometric *= faceDirection;
#endif
#endif
  normals.shading = normals.geometric;
#if NORMAL_VARIANCE
  normals.relief = vec2(0.0);
  normals.reliefAxis = vec3(0.0);
#if CLEARCOAT
  normals.coatRelief = vec2(0.0);
#endif
#endif
#if NORMAL_MAP
  mat3 frame = tangentFrame(normals.geometric, vNormalUv, faceDirection);
#if NORMAL_VARIANCE
#if FACETS
  vec2 across = dFdx(vNormalUv) * normalMapSize();
  vec2 down = dFdy(vNormalUv) * normalMapSize();
  float texels2 = max(dot(across, across), dot(down, down));
  normals = withFacets(normals, frame, normalTexel(FACET_LOD_BIAS), saturate((texels2 * exp2(2.0 * FACET_LOD_BIAS) - 1.0) / 3.0), normalScale);
  normals.facetsTold = saturate(2.0 - sqrt(texels2) / FACET_TEXELS);
  normals.relief.y *= mix(1.0, FACET_VARIANCE_KEPT, normals.facetsTold);
#else
#if NORMAL_HOLES
  vec4 varied = withoutHoles(normalTexel(), shareThere());
#else
  vec4 varied = normalTexel();
#endif
  normals.relief = reliefOf(varied, normalScale);
  normals.reliefAxis = safeNormalize(frame * vec3(reliefAxis * normalScale, 0.0), vec3(0.0)) * length(reliefAxis);
#if YARN_RELIEF
  normals.meanSlope = vec2(varied) / max(varied.b, 1.0e-2);
#endif
  normals.shading = mappedNormal(frame, plainNormalTexel(varied), normalScale);
#endif
#else
  normals.shading = mappedNormal(frame, normalTexel().xyz, normalScale);
#endif
#elif WEAVE_MAP
  mat3 frame = tangentFrame(normals.geometric, vWeaveUv, faceDirection);
#elif (ANISOTROPY || WEAVE) && CLEARCOAT_NORMAL_MAP
  mat3 frame = tangentFrame(normals.geometric, vClearcoatNormalUv, faceDirection);
#elif ANISOTROPY || WEAVE
  mat3 frame = tangentFrame(normals.geometric, vUv0, faceDirection);
#endif
#if ANISOTROPY || WEAVE
  // three.js divides by 0 here; a stretched highlight needs some direction.
  normals.frame = dot(frame[0], frame[0]) > 0.0 && dot(frame[1], frame[1]) > 0.0 ? frame : basisAbout(normals.geometric);
#endif
#if WEAVE
#if TANGENT
  normals.upward = 1.0;
#else
  normals.upward = -1.0;  // derivatives follow the texture's rows, which run downwards
#endif
#endif
#if CLEARCOAT
  normals.coat = normals.geometric;
#if CLEARCOAT_NORMAL_MAP
  mat3 coatFrame = tangentFrame(normals.geometric, vClearcoatNormalUv, faceDirection);
#if NORMAL_VARIANCE
  vec4 variedCoat = coatNormalTexel();
  normals.coatRelief = reliefOf(variedCoat, clearcoatNormalScale);
  normals.coat = mappedNormal(coatFrame, plainNormalTexel(variedCoat), clearcoatNormalScale);
#else
  normals.coat = mappedNormal(coatFrame, coatNormalTexel().xyz, clearcoatNormalScale);
#endif
#endif
#endif
  return normals;
}
