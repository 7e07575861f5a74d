// How far a sampler is from level 0 of a map of so many texels, which alone has edges; 0 where it magnifies.
float sampledLevel(vec2 uv, vec2 texels) {
  vec2 dx = dFdx(uv) * texels;
  vec2 dy = dFdy(uv) * texels;
  return 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0));
}
