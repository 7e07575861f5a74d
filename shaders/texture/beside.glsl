// A map beside the source, over the same square: its level 0 is read.
// BESIDE 0: there is none. A software GL would look it up all the same.
// BESIDE_FITS 1: it has as many texels as the source, and so have others; 0: of any size.
#if BESIDE
uniform sampler2D besideMap;
#endif

// At a texel of the source.   count  texels of the source
vec4 besideTexel(sampler2D map, ivec2 at, ivec2 count) {
#if BESIDE_FITS
  return texelFetch(map, at, 0);
#else
  return textureLod(map, (vec2(at) + 0.5) / vec2(count), 0.0);
#endif
}
