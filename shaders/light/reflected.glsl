// No light at all.
Reflected nothingReflected() {
  Reflected nothing;
  nothing.diffuse = nothing.specular = vec3(0.0);
#if SHEEN
  nothing.sheen = vec3(0.0);
#endif
#if CLEARCOAT
  nothing.coat = vec3(0.0);
#endif
  return nothing;
}
