// How the lobes of one surface add up in the principled shadings, by terms that can be swapped: three.js r115 as listings
// 6.1 to 6.13 of the thesis that telar grew from have it, and Burley 2012. No uniforms and no textures: also compiled as C++
// (renderer/brdf/shading.h), with every layer on. principled_terms.glsl comes before it.

// Whether the lobes cover one another; else they are summed as they are.
bool isLayered(SurfaceInfo s) {
  return CHOSEN(layering, LAYERING_TERM) == LAYERING_THREE_R115;
}

// The surface as the model has it, with what every light needs of it again.
// s  perceptual roughnesses as authored: no floor, no geometric roughness
SurfaceInfo preparedSurface(SurfaceInfo s) {
  s = withParameters(s);
  s.dfg = environmentTerm(s, s.perceptualRoughness, s.NoV, s.dfg);
#if ALL_TERMS || VISIBILITY_TERM == VISIBILITY_SMITH_SEPARABLE
  if (CHOSEN(visibility, VISIBILITY_TERM) == VISIBILITY_SMITH_SEPARABLE) {
    s.dfg *= separableShare(s.perceptualRoughness, s.NoV);
  }
#endif
#if CLEARCOAT
  s = withCoatTerm(s);
  s.coatDfg = environmentTerm(s, s.clearcoatRoughness, s.clearcoatNoV, s.coatDfg);
#endif
#if SHEEN
  s = withSheenTerm(s);
#endif
  return withWidths(s);
}

// Share of the light that the coat leaves to what lies beneath it.
// cosine  at the coat: NoL for a light, NoV for the environment
float underCoat(SurfaceInfo s, float cosine) {
#if CLEARCOAT
  if (isLayered(s)) return 1.0 - s.clearcoat * clearcoatDHR(s.clearcoatRoughness, cosine);
#endif
  return 1.0;
}

// The same for light that comes from anywhere.
float underCoatToViewer(SurfaceInfo s) {
#if CLEARCOAT
  return underCoat(s, s.clearcoatNoV);
#else
  return 1.0;
#endif
}

// What is left of the gloss of correlated Smith under an area light.
float glossOfArea(SurfaceInfo s) {
#if SHEEN
  if (isLayered(s) && max3(s.sheenColor) > 0.0) return 0.0;  // the sheen stands in its place
#endif
  if (CHOSEN(visibility, VISIBILITY_TERM) == VISIBILITY_SMITH_SEPARABLE) {
    return separableShare(s.perceptualRoughness, s.NoV).x;
  }
  return 1.0;
}

// Adds the light of one direction.
// l  unit, to the light; of length 0 it gives nothing      lightColor  irradiance on a surface that faces it, linear Rec.709
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
  float NoL = saturate(cosine);
  vec3 h = halfVector(s.n, l, s.v);
  float NoH = saturate(dot(s.n, h));
  float LoH = saturate(dot(s.v, h));
  vec3 color = lightColor;
#if CLEARCOAT
  float coatNoL = saturate(dot(s.coatNormal, l));
  float coatNoH = saturate(dot(s.coatNormal, h));
  sum.coat += coatNoL * color * coatTerm(s, coatNoL, coatNoH, LoH);
  color *= underCoat(s, coatNoL);
#endif
  vec3 irradiance = NoL * color;
  bool hasGloss = NoL > 0.0;  // D has no value at h = -n
#if SHEEN
  if (max3(s.sheenColor) > 0.0) {
    sum.sheen += color * s.sheenColor * sheenCosineTerm(s, l, NoL, NoH, LoH);
    hasGloss = hasGloss && !isLayered(s);  // the sheen stands in its place
  }
#endif
  if (hasGloss) sum.specular += irradiance * fresnelTerm(s, LoH) * (visibilityTerm(s, l, NoL) * distributionTerm(s, h, NoH));
  sum.diffuse += irradiance * diffuseTerm(s, NoL, LoH, dot(l, s.v));
  sum.diffuse += lightColor * transmittedAlbedoTerm(s) * (RECIPROCAL_PI * saturate(-cosine));
  return sum;
}

#if SHEEN
// Adds the sheen of light without a direction: three.js r115 had none.
Reflected addSheenOfDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  if (!isLayered(s)) sum.sheen += irradiance * s.sheenColor * (RECIPROCAL_PI * sheenAlbedoTerm(s));
  return sum;
}
#endif

// Light of ambient and hemisphere lights: it has no direction, and only the diffuse lobe and the sheen see it.
// irradiance  linear Rec.709
Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
#if SHEEN
  sum = addSheenOfDome(sum, s, irradiance);
#endif
  sum.diffuse += irradiance * RECIPROCAL_PI * diffuseAlbedoTerm(s);
  return sum;
}

#if DIFFUSE_TRANSMISSION
// Adds light without a direction that comes through from the other side.
// irradiance  there, linear Rec.709
Reflected addBehind(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  sum.diffuse += irradiance * RECIPROCAL_PI * transmittedAlbedoTerm(s);
  return sum;
}
#endif

// Adds what the surface reflects of the prefiltered environment. The coat of r115 takes its share of single scattering only.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
  Scattering scattering = scatteringTerm(s);
  vec3 single = incident.radiance * scattering.single;
#if CLEARCOAT
  sum.coat += incident.coatRadiance * coatAlbedoTerm(s);
  single *= underCoatToViewer(s);
#endif
#if SHEEN
  sum = addSheenOfDome(sum, s, incident.environmentIrradiance);
#endif
  sum.specular += single + scattering.multiple * meanRadiance;
  vec3 diffuse = diffuseAlbedoTerm(s);
  if (CHOSEN(scattering, SCATTERING_TERM) == SCATTERING_FDEZ_AGUERA) diffuse *= diffuseShare(scattering);
  sum.diffuse += diffuse * meanRadiance;
  return sum;
}

// Radiance that leaves towards the viewer, linear Rec.709.
// diffuse  of both, or what is seen through a transmissive surface in its place      emitted  linear Rec.709
vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted) {
  vec3 radiance = radianceBelowCoat(diffuse, direct, indirect, emitted);
#if CLEARCOAT
  radiance += (direct.coat + indirect.coat) * s.clearcoat;
#endif
  return radiance;
}
