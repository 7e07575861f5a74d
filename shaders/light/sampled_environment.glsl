// Light of the environment by sampling the material itself: directions are drawn where its lobes reflect, and the environment
// is read as blurred as they lie apart, so that there is no noise. All lobes are drawn from together, and every direction
// counts for what all of them reflect of it. View space.
// src: Krivanek & Colbert 2008, "Real-time Shading with Filtered Importance Sampling"; Veach 1997, "Robust Monte Carlo Methods
//      for Light Transport Simulation", section 9.2: the lobes by the balance heuristic, the bright part by the power heuristic
uniform samplerCube environmentSource;     // RGB radiance, A luminance of its bright part; a texel of a level is the mean of
                                           // those of the level before
uniform float environmentSourceSize;       // texels on an edge of level 0
uniform samplerCube environmentIrradianceMap;  // by the direction that a surface faces: irradiance of it all / PI
uniform mat3 viewToEnvironment;
uniform int environmentPass;               // of environmentPasses over the picture, each with directions of its own
uniform int environmentPasses;
// Directions of the bright part, drawn in proportion to it (renderer/ibl/bright_directions.h).
uniform int brightCount;                             // of this pass, up to BRIGHT_DIRECTIONS
uniform vec3 brightDirection[BRIGHT_DIRECTIONS];     // view space
uniform vec4 brightIrradiance[BRIGHT_DIRECTIONS];    // A = their density there in all passes, per steradian
uniform float brightDensity;                         // the same for a luminance of 1

// Density of a light that is taken out of the map, so that it is not in its irradiance either.
const float COMPACT_DENSITY = 1.0e29;

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);  // of linear Rec.709

// Least part of the directions that a lobe gets: what the estimate of its albedo misses is still found.
const float LEAST_SHARE = 0.25;

// One GGX lobe to draw from.
struct DrawnLobe {
  mat3 frame;  // columns x, y, normal
  vec3 v;      // to the viewer, in the frame
  vec2 alpha;
};

// What a surface is drawn from: shares sum to 1.
struct DrawnLobes {
  mat3 cosineFrame;
  float cosineShare;
  DrawnLobe base;     // of a weave, its warp
  float baseShare;
#if WEAVE
  DrawnLobe weft;
  float weftShare;
#endif
  float behindShare;  // of a cosine lobe on the other side
#if SHEEN
  float sheenShare;
#if SHADING_FABRIC
  mat3 sheenFrame;    // x holds the viewer
  vec3 sheenLtc;
#endif
#endif
#if CLEARCOAT
  DrawnLobe coat;
  float coatShare;
#endif
};

// t  along x where the lobe is stretched; need not be square with n
DrawnLobe drawnLobe(vec3 n, vec3 t, vec2 alpha, vec3 v) {
  DrawnLobe lobe;
  vec3 across = t - n * dot(n, t);
  vec3 x = dot(across, across) > SQUARED_LENGTH_EPSILON ? normalize(across) : basisAbout(n)[0];
  lobe.frame = mat3(x, cross(n, x), n);
  lobe.v = v * lobe.frame;
  lobe.v.z = max(lobe.v.z, 1.0e-4);
  lobe.alpha = alpha;
  return lobe;
}

DrawnLobes drawnLobes(SurfaceInfo s) {
  DrawnLobes lobes;
  lobes.cosineFrame = basisAbout(s.n);
#if WEAVE
  lobes.base = drawnLobe(s.warp.n, s.warp.t, vec2(s.warp.alphaT, s.warp.alphaB), s.v);
  lobes.weft = drawnLobe(s.weft.n, s.weft.t, vec2(s.weft.alphaT, s.weft.alphaB), s.v);
#elif ANISOTROPY
  lobes.base = drawnLobe(s.n, s.t, vec2(max(s.alphaT, s.alpha), s.alpha), s.v);
#else
  lobes.base = drawnLobe(s.n, lobes.cosineFrame[0], vec2(s.alpha), s.v);
#endif
  float diffuse = max3(s.diffuse);
#if SHEEN
  float sheen = max3(s.sheenColor);
  lobes.sheenShare = sheen / (sheen + diffuse + 1.0e-4);
  diffuse += sheen;
#if SHADING_FABRIC
  lobes.sheenFrame = drawnLobe(s.n, s.v, vec2(1.0), s.v).frame;
  lobes.sheenLtc = sheenLtc(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
#endif
#endif
  lobes.behindShare = 0.0;
#if DIFFUSE_TRANSMISSION
  lobes.behindShare = s.diffuseTransmission * (1.0 - 2.0 * LEAST_SHARE);
#endif
  float specular = max3(F_Schlick(s.f0, s.f90, s.NoV));
  lobes.baseShare = clamp(specular / (specular + diffuse + 1.0e-4), LEAST_SHARE, 1.0 - LEAST_SHARE) * (1.0 - lobes.behindShare);
#if CLEARCOAT
  lobes.coat = drawnLobe(s.coatNormal, basisAbout(s.coatNormal)[0], vec2(alphaFromRoughness(s.clearcoatRoughness)), s.v);
  lobes.coatShare = s.clearcoat * LEAST_SHARE;
  lobes.baseShare *= 1.0 - lobes.coatShare;
  lobes.behindShare *= 1.0 - lobes.coatShare;
#endif
#if SHEEN
  float left = 1.0 - lobes.baseShare - lobes.behindShare;
#if CLEARCOAT
  left -= lobes.coatShare;
#endif
  lobes.sheenShare *= left;
#endif
  lobes.cosineShare = 1.0 - lobes.baseShare;
#if CLEARCOAT
  lobes.cosineShare -= lobes.coatShare;
#endif
  lobes.cosineShare -= lobes.behindShare;
#if SHEEN
  lobes.cosineShare -= lobes.sheenShare;
#endif
#if WEAVE
  lobes.weftShare = lobes.baseShare * s.weft.coverage / (s.warp.coverage + s.weft.coverage);
  lobes.baseShare -= lobes.weftShare;
#endif
  return lobes;
}

vec3 drawnReflection(DrawnLobe lobe, vec2 u) {
  vec3 h = sampleVisibleNormal(lobe.v, lobe.alpha, u);
  return lobe.frame * (2.0 * dot(lobe.v, h) * h - lobe.v);
}

// Off a lobe of the base. What leaning yarns send below the surface comes back mirrored, as in glossLobe().
vec3 drawnGloss(DrawnLobes lobes, DrawnLobe lobe, vec2 u) {
  vec3 l = drawnReflection(lobe, u);
#if WEAVE_MAP
  vec3 n = lobes.cosineFrame[2];
  l -= (2.0 * min(dot(n, l), 0.0)) * n;
#endif
  return l;
}

float glossDensity(DrawnLobes lobes, DrawnLobe lobe, vec3 l) {
  float density = pdfReflection(lobe.v, l * lobe.frame, lobe.alpha);
#if WEAVE_MAP
  vec3 n = lobes.cosineFrame[2];
  float cosine = dot(n, l);
  density += pdfReflection(lobe.v, (l - (2.0 * cosine) * n) * lobe.frame, lobe.alpha);
  if (cosine < 0.0) density = 0.0;
#endif
  return density;
}

#if SHEEN
// Fibres shine where the cosine is small: the lobe of fabric is drawn from itself, the others' from all directions alike.
vec3 drawnSheen(DrawnLobes lobes, vec2 u) {
#if SHADING_FABRIC
  return lobes.sheenFrame * sampleSheenLtc(lobes.sheenLtc, u);
#else
  return lobes.cosineFrame * sampleHemisphere(u);
#endif
}

float sheenDensity(DrawnLobes lobes, vec3 l) {
#if SHADING_FABRIC
  return sheenLtcCosine(vec3(1.0, lobes.sheenLtc.yz), l * lobes.sheenFrame);
#else
  return pdfHemisphere(dot(lobes.cosineFrame[2], l));
#endif
}
#endif

// u  [0, 1)^2; its x chooses the lobe
vec3 drawnDirection(DrawnLobes lobes, vec2 u) {
  if (u.x < lobes.baseShare) return drawnGloss(lobes, lobes.base, vec2(u.x / lobes.baseShare, u.y));
  u.x -= lobes.baseShare;
#if WEAVE
  if (u.x < lobes.weftShare) return drawnGloss(lobes, lobes.weft, vec2(u.x / lobes.weftShare, u.y));
  u.x -= lobes.weftShare;
#endif
#if CLEARCOAT
  if (u.x < lobes.coatShare) return drawnReflection(lobes.coat, vec2(u.x / lobes.coatShare, u.y));
  u.x -= lobes.coatShare;
#endif
#if DIFFUSE_TRANSMISSION
  if (u.x < lobes.behindShare) return -(lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.behindShare, u.y)));
  u.x -= lobes.behindShare;
#endif
#if SHEEN
  if (u.x < lobes.sheenShare) return drawnSheen(lobes, vec2(u.x / lobes.sheenShare, u.y));
  u.x -= lobes.sheenShare;
#endif
  return lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.cosineShare, u.y));
}

// Density of drawnDirection.
float drawnDensity(DrawnLobes lobes, vec3 l) {
  float sum = lobes.baseShare * glossDensity(lobes, lobes.base, l);
#if WEAVE
  sum += lobes.weftShare * glossDensity(lobes, lobes.weft, l);
#endif
#if CLEARCOAT
  sum += lobes.coatShare * pdfReflection(lobes.coat.v, l * lobes.coat.frame, lobes.coat.alpha);
#endif
#if DIFFUSE_TRANSMISSION
  sum += lobes.behindShare * pdfCosine(-dot(lobes.cosineFrame[2], l));
#endif
#if SHEEN
  sum += lobes.sheenShare * sheenDensity(lobes, l);
#endif
  return sum + lobes.cosineShare * pdfCosine(dot(lobes.cosineFrame[2], l));
}

// Sobol's points, [0, 1)^2: any aligned block of 2^k of them has one in every cell of any division into 2^k cells. So a
// pass fills the square evenly, and the passes together more finely.
vec2 sobolPoint(uint index) {
  uint x = 0u;
  uint y = 0u;
  uint inverse = 0x80000000u;
  uint direction = 0x80000000u;
  for (; index != 0u; index >>= 1u) {
    uint chosen = 0u - (index & 1u);
    x ^= inverse & chosen;
    y ^= direction & chosen;
    inverse >>= 1u;
    direction ^= direction >> 1u;
  }
  return vec2(uvec2(x, y) >> 8u) * 5.9604645e-8;
}

// Moves the points of a pixel against those of its neighbours, [0, 1)^2: what a few points miss is then spread over the
// pixels about, where it averages out, in place of bands.
// src: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2 by pixel
vec2 pixelShift() {
  return vec2(interleavedGradientNoise(gl_FragCoord.xy), fract(dot(gl_FragCoord.xy, vec2(0.7548776662, 0.5698402910))));
}

// Mean radiance, and luminance of the bright part, over a solid angle about a direction.
vec4 environmentMean(vec3 direction, float solidAngle) {
  vec3 d = viewToEnvironment * direction;
  vec3 size = abs(d);
  float nearest = max(max(size.x, size.y), size.z);
  // A texel of a cube's face covers 4 cos^3 / size^2. Less is taken together than lies between two directions: what is left of
  // the grain is finer than the blur would be wrong.
  float texels = 0.125 * solidAngle * environmentSourceSize * environmentSourceSize / (4.0 * nearest * nearest * nearest);
  return textureLod(environmentSource, d, 0.5 * log2(max(texels, 1.0)));
}

// Part that the first of two ways of drawing a direction counts for. The power makes little of the way that is seldom right:
// what is read of a small sun is blurred by as much as the directions of a wide lobe lie apart.
// own, other  densities, >= 0
float powerWeight(float own, float other) {
  float ratio = other / max(own, 1.0e-30);
  return 1.0 / (1.0 + ratio * ratio);
}

// Irradiance that was found on both sides of a surface, linear Rec.709.
struct Found {
  vec3 before;
#if DIFFUSE_TRANSMISSION
  vec3 behind;
#endif
};

Found addFound(Found sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
  sum.before += lightColor * max(cosine, 0.0);
#if DIFFUSE_TRANSMISSION
  sum.behind += lightColor * max(-cosine, 0.0);
#endif
  return sum;
}

// The irradiance of the whole map is known. What the directions missed of it, or found too much, is made good as light from
// everywhere: diffuse light has then no noise but that of where its lobe differs from the cosine.
// src: control variates, as Owen 2013, "Monte Carlo Theory, Methods and Examples", section 8.9
Reflected addMissed(Reflected sum, SurfaceInfo s, Found found) {
  float whole = PI * environmentIntensity;
  vec3 facing = viewToEnvironment * s.n;
  sum.diffuse += addDome(nothingReflected(), s, whole * textureLod(environmentIrradianceMap, facing, 0.0).rgb - found.before).diffuse;
#if DIFFUSE_TRANSMISSION
  sum = addBehind(sum, s, whole * textureLod(environmentIrradianceMap, -facing, 0.0).rgb - found.behind);
#endif
  return sum;
}

Reflected addSampledEnvironment(Reflected sum, SurfaceInfo s) {
  DrawnLobes lobes = drawnLobes(s);
  float count = float(ENVIRONMENT_SAMPLES);
  float all = count * float(environmentPasses);
  vec2 shift = pixelShift();
  Found found;
  found.before = vec3(0.0);
#if DIFFUSE_TRANSMISSION
  found.behind = vec3(0.0);
#endif
  for (int i = 0; i < ENVIRONMENT_SAMPLES; ++i) {
    vec2 u = fract(sobolPoint(uint(environmentPass * ENVIRONMENT_SAMPLES + i)) + shift);
    vec3 l = drawnDirection(lobes, u);
    float density = drawnDensity(lobes, l);
    if (density > 0.0) {
      vec4 light = environmentMean(l, 1.0 / (density * all));
      // The bright part counts for what it is not drawn by itself.
      float bright = min(light.a / max(dot(vec3(light), LUMINANCE), 1.0e-30), 1.0);
      float rest = 1.0 - bright * powerWeight(brightDensity * light.a, density * all);
      vec3 lightColor = vec3(light) * (rest * environmentIntensity / (density * count));
      sum = addPunctual(sum, s, l, lightColor);
      found = addFound(found, s, l, lightColor);
    }
  }
  for (int i = 0; i < brightCount; ++i) {
    vec3 l = brightDirection[i];
    float share = powerWeight(brightIrradiance[i].a, drawnDensity(lobes, l) * all);
    vec3 lightColor = vec3(brightIrradiance[i]) * (share * environmentIntensity);
    sum = addPunctual(sum, s, l, lightColor);
    if (brightIrradiance[i].a < COMPACT_DENSITY) found = addFound(found, s, l, lightColor);
  }
  return addMissed(sum, s, found);
}
