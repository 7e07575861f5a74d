// Only depth is kept. Of the alpha, three.js's depth material knows the texture alone.
precision highp float;
#if ALPHA_MASK
precision highp sampler2D;
uniform sampler2D baseColorMap;
uniform float alphaCutoff;
in vec2 vBaseColorUv;
#endif

void main() {
#if ALPHA_MASK
  if (texture(baseColorMap, vBaseColorUv).a < alphaCutoff) discard;
#endif
}
