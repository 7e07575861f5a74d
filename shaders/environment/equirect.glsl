// Texture coordinates of a unit direction in an equirectangular map whose row v = 1 is +Y and whose centre is +X.
// src: order of three r187
vec2 equirectUv(vec3 direction) {
  float u = atan(direction.z, direction.x) * 0.15915494309189535 + 0.5;
  float v = asin(clamp(direction.y, -1.0, 1.0)) * RECIPROCAL_PI + 0.5;
  return vec2(u, v);
}
