// Light from one direction off a polished normal map whose texels are not much smaller than the pixel: at a grid of places within
// it, each facet and each edge by itself, which makes glints. At a place the normal turns towards those beside it, and the lobe is as
// wide as that, so that between two places nothing is missed.
// src: Yan et al. 2016, "Position-Normal Distributions for Efficient Rendering of Specular Microstructure", for lobes that are as
//      wide as the normal turns

// Places. Half as many flicker three times as much.
const float FACET_COLUMNS = 4.0;
const float FACET_ROWS = 8.0;        // along the side of the pixel that is longer on the map
const float FACET_ROWS_MORE = 12.0;  // where it is FACET_STRETCHED times as long
const float FACET_STRETCHED = 1.6;

vec3 facetNormal(SurfaceInfo s, mat3 frame, vec2 uv) {
  vec4 texel = sharpNormalTexel(uv);
  vec2 slope = vec2(texel) / max(texel.b, FACET_SHARE_MIN);
  return normalFacing(safeNormalize(frame * vec3(slope * normalScale, 1.0), frame[2]), s.v);
}

// Of all lights that addLight() has had.
vec3 facetLight(SurfaceInfo s) {
  mat3 frame = tangentFrame(s.geometricNormal, vNormalUv, frontFacing() ? 1.0 : -1.0);
  vec2 across = dFdx(vNormalUv);
  vec2 down = dFdy(vNormalUv);
  vec2 size = normalMapSize();
  vec2 acrossTexels = across * size;
  vec2 downTexels = down * size;
  float stretched = dot(downTexels, downTexels) / max(dot(acrossTexels, acrossTexels), 1.0e-20);
  if (stretched < 1.0) {
    vec2 longer = across;
    across = down;
    down = longer;
    stretched = 1.0 / max(stretched, 1.0e-20);
  }
  float rows = stretched > pow2(FACET_STRETCHED) ? FACET_ROWS_MORE : FACET_ROWS;
  across /= FACET_COLUMNS;
  down /= rows;
  vec2 uv = vNormalUv - (0.5 * FACET_COLUMNS + 0.5) * across - (0.5 * rows + 0.5) * down;
  float share = s.facetsTold / (FACET_COLUMNS * rows);
  if (share == 0.0) rows = 0.0;

  float alpha2 = pow4(s.glossRoughness);
  vec3 halfways[FACET_LIGHTS];
  for (int k = 0; k < FACET_LIGHTS; ++k) {
    vec3 h = halfVector(s.n, facetLightDirection[k], s.v);
    halfways[k] = h;
    facetLightColor[k] *= mix(s.f0, vec3(s.f90), F_SchlickWeight5(dot(s.v, h)));
  }
  // The row before: n4 lies beside the place.
  vec3 n4 = facetNormal(s, frame, uv + across);
  vec3 n3 = facetNormal(s, frame, uv + 2.0 * across);
  vec3 n2 = facetNormal(s, frame, uv + 3.0 * across);
  vec3 n1 = facetNormal(s, frame, uv + 4.0 * across);
  vec3 sum = vec3(0.0);
  for (float j = 0.5; j < rows; ++j) {
    uv += down;
    vec3 last = facetNormal(s, frame, uv);
    for (float i = 1.0; i < min(rows, FACET_COLUMNS) + 0.5; ++i) {  // no constant: unrolled it would compile for longer
      vec3 n = facetNormal(s, frame, uv + i * across);
      for (int k = 0; k < FACET_LIGHTS; ++k) {
        sum += facetLightColor[k] * facetCellLobe(s.geometricNormal, n, alpha2, n - last, n - n4, s.v, facetLightDirection[k], halfways[k]);
      }
      n4 = n3;
      n3 = n2;
      n2 = n1;
      n1 = last = n;
    }
  }
  return sum * share;
}
