// One quantity of the shading in place of the colour. RGB holds it; A is 1 where the material has it, so that nothing is
// blended with it, else all are 0. The quantities are rows of js/shot/table/debug_quantities.mjs.
uniform int debugOutput;  // one of the DEBUG_ numbers

#if !UNLIT
vec3 debugSum(SurfaceInfo s, Reflected reflected) {
  vec3 sum = reflected.diffuse + reflected.specular;
#if SHEEN
  sum += reflected.sheen;
#endif
#if CLEARCOAT
  sum += reflected.coat * s.clearcoat;
#endif
  return sum;
}

// Cloth has a table of its own in place of three's.
vec2 debugDfg(SurfaceInfo s) {
#if SHADING_FABRIC
  return s.albedo.base;
#else
  return s.dfg;
#endif
}
#endif

#include "debug_quantities.glsl"
