// Depth alone, where a pixel takes no more samples.
precision highp float;

uniform sampler2D settledMap;  // R 1 = settled; row 0 is the top of the picture

void main() {
  ivec2 size = textureSize(settledMap, 0);
  if (texelFetch(settledMap, ivec2(int(gl_FragCoord.x), size.y - 1 - int(gl_FragCoord.y)), 0).r == 0.0) discard;
}
