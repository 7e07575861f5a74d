// Light from one direction off a polished normal map whose texels are not much smaller than the pixel: each facet and each edge by
// itself, which makes glints. A place lies between four texels, and the lobe is as wide as the normal turns there, so that nothing
// between texels is missed. Places stay where they are on the cloth: glints flicker less where it moves.
// src: Yan et al. 2016, "Position-Normal Distributions for Efficient Rendering of Specular Microstructure", for lobes that are as
//      wide as the normal turns

// Places along the sides of a pixel, and up to half as many more. Where it has more texels, some are left out.
const float FACET_COLUMNS = 4.0;
const float FACET_ROWS = 8.0;  // along the side that is longer on the map

// Least cosine to a light's halfway direction of what counts as place: what lies farther off mirrors nothing.
const float FACET_COSINE_MIN = 0.3;

// A pixel on the map, [places]: a box of its area and second moments with two sides along the map's rows. X is across the rows' run,
// Y along the longer side.
struct FacetBox {
  vec2 middle;
  vec2 size;
  float shear;  // of x, as y grows
};

FacetBox facetBox(vec2 middle, vec2 across, vec2 down) {
  FacetBox box;
  float yy = max(across.y * across.y + down.y * down.y, 1.0e-20);
  box.middle = middle;
  box.size.y = sqrt(yy);
  box.size.x = max(abs(across.x * down.y - across.y * down.x) / box.size.y, 1.0e-10);
  box.shear = (across.x * across.y + down.x * down.y) / yy;
  return box;
}

// Where the sampler finds texels beyond the map.
// period  as normalMapPeriod
vec2 facetIndex(vec2 at, float size, float period) {
  at = period > 0.0 ? at - period * size * floor((at + 0.5) / (period * size)) : clamp(at, 0.0, size - 1.0);
  return clamp(min(at, 2.0 * size - 1.0 - at), 0.0, size - 1.0);  // far out the floor is rounded, too
}

vec3 facetTexel(float column, float row, bool turned) {
  return vec3(sharpNormalTexel(turned ? ivec2(row, column) : ivec2(column, row)));
}

// XY the slope about a direction, between two texels; ZW by how much it turns from the upper side of the place to the lower.
// y  of the middle of the place, from the one texel to the other      height  of the place, as a part of that
vec4 facetSlope(mat3 toDirection, vec3 upper, vec3 lower, float y, float height) {
  upper = toDirection * upper;
  lower = toDirection * lower;
  vec2 slope = upper.xy / max(upper.z, FACET_COSINE_MIN);
  vec2 turn = lower.xy / max(lower.z, FACET_COSINE_MIN) - slope;
  return vec4(slope + turn * y, turn * height);
}

// Adds that of all lights that addLight() and addSun() have had.
void addFacetLight(inout Reflected direct, inout Reflected suns, SurfaceInfo s) {
  if (s.facetsTold == 0.0 || facetLights == 0) return;
  mat3 frame = tangentFrame(s.geometricNormal, vNormalUv, frontFacing() ? 1.0 : -1.0);
  frame[0] *= normalScale.x;
  frame[1] *= normalScale.y;
  float alpha2 = pow4(s.glossRoughness);
  mat3 toHalfway[FACET_LIGHTS];
  float mirrored[FACET_LIGHTS];
  vec4 before[FACET_LIGHTS];
  for (int k = 0; k < FACET_LIGHTS; ++k) {
    bool isLit = k < facetLights;
    vec3 l = isLit ? facetLightDirection[k] : s.v;
    vec3 h = halfVector(s.n, l, s.v);
    float VoH = saturate(dot(s.v, h));
    toHalfway[k] = transpose(basisAbout(h)) * frame;
    // What mirrors has its normal there: shadowing and Fresnel are the same at all places.
    float visible = V_SmithGGXCosine(sqrt(alpha2), VoH, VoH) * bumpTerminator(bumpAlpha2(s.geometricNormal, h), dot(s.geometricNormal, l));
    facetLightColor[k] = (isLit ? facetLightColor[k] : vec3(0.0)) * visible * mix(s.f0, vec3(s.f90), F_SchlickWeight5(VoH));
    mirrored[k] = 0.0;
    before[k] = vec4(0.0);
  }

  vec2 size = normalMapSize();
  vec2 period = normalMapPeriod;
  vec2 middle = vNormalUv * size - 0.5;
  vec2 across = dFdx(vNormalUv) * size;
  vec2 down = dFdy(vNormalUv) * size;
  bool turned = across.x * across.x + down.x * down.x > across.y * across.y + down.y * down.y;
  FacetBox box = facetBox(turned ? middle.yx : middle, turned ? across.yx : across, turned ? down.yx : down);
  if (turned) {
    size = size.yx;
    period = period.yx;
  }
  vec2 stride = max(floor(box.size / vec2(FACET_COLUMNS, FACET_ROWS) + 0.5), 1.0);
  box.middle /= stride;
  box.size /= stride;
  box.shear *= stride.y / stride.x;

  float top = box.middle.y - 0.5 * box.size.y;
  float bottom = box.middle.y + 0.5 * box.size.y;
  // Counted from 0: far out on the map, adding 1 may change nothing.
  float rowCount = min(ceil(bottom) - floor(top), 2.0 * FACET_ROWS);
  for (float row = 0.0; row < rowCount; ++row) {
    float j = floor(top) + row;
    float low = max(j, top);
    float high = min(j + 1.0, bottom);
    float height = high - low;
    float y = 0.5 * (low + high);
    float left = box.middle.x + box.shear * (y - box.middle.y) - 0.5 * box.size.x;
    float right = left + box.size.x;
    y -= j;
    vec2 rows = facetIndex(vec2(j, j + 1.0) * stride.y, size.y, period.y);
    float columnCount = min(ceil(right) - floor(left), 2.0 * FACET_COLUMNS);
    for (float count = 0.0; count <= columnCount; ++count) {
      float i = floor(left) + count - 1.0;
      float column = facetIndex(vec2((i + 1.0) * stride.x), size.x, period.x).x;
      vec3 upper = facetTexel(column, rows.x, turned);
      vec3 lower = facetTexel(column, rows.y, turned);
      float from = max(i, left);
      float to = min(i + 1.0, right);
      float width = max(to - from, 0.0);
      float x = 0.5 * (from + to) - i;
      for (int k = 0; k < FACET_LIGHTS; ++k) {
        vec4 after = facetSlope(toHalfway[k], upper, lower, y, height);
        vec4 between = mix(before[k], after, x);
        if (count > 0.0) mirrored[k] += width * height * facetCellDistribution(alpha2, between.xy, (after.xy - before[k].xy) * width, between.zw);
        before[k] = after;
      }
    }
  }
  vec3 sum = vec3(0.0);
  vec3 ofSuns = vec3(0.0);
  for (int k = 0; k < FACET_LIGHTS; ++k) {
    vec3 light = facetLightColor[k] * mirrored[k];
    if (facetLightIsSun[k]) ofSuns += light;
    else sum += light;
  }
  float perPlace = s.facetsTold / (box.size.x * box.size.y);
  direct.specular += sum * perPlace;
  suns.specular += ofSuns * perPlace;
}
