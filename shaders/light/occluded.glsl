#if OCCLUSION_MAP
// Ambient light times the baked occlusion.
Reflected occluded(Reflected indirect, SurfaceInfo s) {
  float occlusion = diffuseOcclusion(occlusionTexel(), occlusionStrength);
  indirect.diffuse *= occlusion;
#if THREE_LAYER_OCCLUSION_TERM == THREE_LAYER_OCCLUSION_OCCLUDED
#if CLEARCOAT
  indirect.coat *= occlusion;
#endif
#if SHEEN
  indirect.sheen *= occlusion;
#endif
#endif
#if ENVIRONMENT
  indirect.specular *= specularOcclusion(s.perceptualRoughness, occlusion, s.NoV);
#endif
  return indirect;
}
#endif
