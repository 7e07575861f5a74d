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

// Radiance of the layers below the clearcoat, linear Rec.709; parameters as those of composedRadiance().
vec3 radianceBelowCoat(vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted) {
  vec3 radiance = diffuse + (direct.specular + indirect.specular);
  radiance += emitted;
#if SHEEN
  radiance += direct.sheen + indirect.sheen;
#endif
  return radiance;
}
