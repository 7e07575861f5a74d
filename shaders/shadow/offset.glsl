// To which side of a surface a point moves before it is compared with a shadow map. three.js moves it along the normal: where that
// faces away from the light, into the shadow of the surface itself. A sheet that is seen from both sides, or lets light through, is lit
// from there too.

// world  offset  metres along the normal
vec4 offsetToLight(vec4 world, vec3 offset, vec3 toLight) {
#if DOUBLE_SIDED || DIFFUSE_TRANSMISSION
  if (dot(offset, toLight) < 0.0) offset = -offset;
#endif
  return world + vec4(offset, 0.0);
}

// Direction to a spot or a directional light, of any length.
// matrix  world to map coordinates: it takes the light's place, or its direction as a point without a place, to depth -infinity
vec3 toFlatLight(mat4 matrix, vec4 world) {
  vec4 light = inverse(matrix) * vec4(0.0, 0.0, -1.0, 0.0);
  return light.xyz - world.xyz * light.w;
}
