// Indirect light as far as the hemisphere above a surface is open: after Jimenez et al. 2016. Also compiled as C++, with every
// layer on.
#if SHADING_FABRIC && AMBIENT_VISIBILITY
Reflected visibleLight(Reflected indirect, SurfaceInfo s) {
  indirect.diffuse *= multiBounceVisibility(s.visibility, s.diffuse);
  vec3 l = dominantReflection(s.perceptualRoughness, s.n, s.v);
  indirect.specular *= specularVisibility(s.visibility, s.perceptualRoughness, dot(s.openDirection, l), dot(s.faceNormal, l));
#if SHEEN
  indirect.sheen *= s.visibility;
#endif
#if CLEARCOAT
  vec3 coat = dominantReflection(s.clearcoatRoughness, s.coatNormal, s.v);
  indirect.coat *= specularVisibility(s.visibility, s.clearcoatRoughness, dot(s.openDirection, coat), dot(s.faceNormal, coat));
#endif
  return indirect;
}
#endif
