// What a fragment reads of FabricLayers (renderer/include/telar/fabric.h).

// Whether the back of the cloth is seen. FLIP_SIDED draws back faces as if they were front faces.
bool seenFromBack() {
#if FLIP_SIDED
  return gl_FrontFacing;
#else
  return !gl_FrontFacing;
#endif
}

#if DIFFUSE_TRANSMISSION
// Colour of the light that comes through, linear Rec.709, and its share of the diffuse light.
vec4 diffuseTransmission() {
  vec4 through = vec4(diffuseTransmissionColorFactor, diffuseTransmissionFactor);
#if DIFFUSE_TRANSMISSION_COLOR_MAP
  through.rgb *= texture(diffuseTransmissionColorMap, vDiffuseTransmissionColorUv).rgb;
#endif
#if DIFFUSE_TRANSMISSION_MAP
  through.a *= texture(diffuseTransmissionMap, vDiffuseTransmissionUv).a;
#endif
  return through;
}
#endif

// What thin cloth has: the light that comes through, and how flat its diffuse lobe is.
void addThin(inout SurfaceInfo s) {
#if DIFFUSE_TRANSMISSION
  vec4 through = diffuseTransmission();
  s.transmittedColor = through.rgb;
  s.diffuseTransmission = saturate(through.a);
#endif
#if FLATNESS
  s.flatness = flatness;
#endif
}

#if BACK
// Base colour of the back, linear Rec.709.
vec3 backColor() {
#if BACK_COLOR_MAP
  return backColorFactor * texture(backColorMap, vBackColorUv).rgb;
#else
  return backColorFactor;
#endif
}
#endif

#if WEAVE_MAP
// The yarn on top at one point of a weave: cosine and sine of the angle by which it is turned counter-clockwise out of
// its own axis (warp v, weft u), sine of its slope along it; how far the texel is warp. Averages of mip levels are
// shorter where the yarns of a texel differ.
struct WeaveTexel {
  vec2 turn;
  float slope;
  float warp;
};

WeaveTexel weaveTexel() {
  vec4 texel = texture(weaveMap, vWeaveUv);
  return WeaveTexel(2.0 * texel.rg - 1.0, 2.0 * texel.b - 1.0, texel.a);
}

// Yarns that lie within one pixel: warp, weft; 0 where the file does not tell.
vec2 threadsPerPixel() {
  return threadsPerUv * max(abs(dFdx(vWeaveUv)), abs(dFdy(vWeaveUv)));
}
#endif
