// One mip level of moments of a normal map's texels. Included after momentsOfTexel().
// FROM_IMAGE 1: level 0, of the normal map's own texels; 0: a smaller one, of its moments.
uniform sampler2D sourceMap;

out vec4 fragmentColor;

void main() {
  vec4 texel = texelFetch(sourceMap, ivec2(gl_FragCoord.xy), 0);
#if FROM_IMAGE
  fragmentColor = momentsOfTexel(texel.rgb, gl_FragCoord.xy / vec2(textureSize(sourceMap, 0)));
#else
  fragmentColor = texel;
#endif
}
