// The slots of the principled shadings: each function gives the term that is chosen for its slot (js/docs/shading.md). In
// GLSL the choice is a number known to the preprocessor, and terms that are not chosen are not in the program; in C++ it
// travels in SurfaceInfo.
#if !ALL_TERMS
#define CHOSEN(slot, number) number
#endif

// Parameters: glTF's as the model has them.
SurfaceInfo withParameters(SurfaceInfo s) {
  s.f90 = 1.0;
#if ALL_TERMS || PARAMETERS_TERM == PARAMETERS_THREE_R115
  if (CHOSEN(parameters, PARAMETERS_TERM) == PARAMETERS_THREE_R115) {
    // It knew the index of the dielectric by its reflectivity and no colour of it.
    float reflectivity = sqrt(saturate(luminanceDisney(s.f0Dielectric) / 0.16));
    s.f0 = specularF0R115(s.baseColor, reflectivity, s.metallic);
    s.perceptualRoughness = roughnessR115(s.perceptualRoughness);
#if CLEARCOAT
    s.clearcoatRoughness = roughnessR115(s.clearcoatRoughness);
#endif
  }
#endif
#if ALL_TERMS || PARAMETERS_TERM == PARAMETERS_DISNEY_2012
  if (CHOSEN(parameters, PARAMETERS_TERM) == PARAMETERS_DISNEY_2012) {
    s.f0 = specularF0FromGltf(s.baseColor, s.metallic, s.f0Dielectric);
    s.perceptualRoughness = saturate(s.perceptualRoughness);
  }
#endif
  s.alpha = max(pow2(s.perceptualRoughness), 0.001);
  return s;
}

// Distribution: its widths ...
SurfaceInfo withWidths(SurfaceInfo s) {
#if ANISOTROPY
#if ALL_TERMS || DISTRIBUTION_TERM == DISTRIBUTION_GGX
  if (CHOSEN(distribution, DISTRIBUTION_TERM) == DISTRIBUTION_GGX) {
    s.alphaT = s.alpha;
    s.anisotropyStrength = 0.0;  // nor does the environment see any
  }
#endif
#if ALL_TERMS || DISTRIBUTION_TERM == DISTRIBUTION_GTR2_ANISOTROPIC
  if (CHOSEN(distribution, DISTRIBUTION_TERM) == DISTRIBUTION_GTR2_ANISOTROPIC) {
    vec2 widths = alphasDisney(s.perceptualRoughness, anisotropicFromGltf(s.perceptualRoughness, s.anisotropyStrength));
    s.alphaT = widths.x;
    s.alpha = widths.y;
  }
#endif
#endif
  return s;
}

// ... and D, [1/sr].
float distributionTerm(SurfaceInfo s, vec3 h, float NoH) {
#if ALL_TERMS || DISTRIBUTION_TERM == DISTRIBUTION_GTR2_ANISOTROPIC
  if (CHOSEN(distribution, DISTRIBUTION_TERM) == DISTRIBUTION_GTR2_ANISOTROPIC) {
#if ANISOTROPY
    return D_GGXAnisotropic(s.alphaT, s.alpha, NoH, dot(s.t, h), dot(s.b, h));
#else
    vec3 x = cross(s.n, h);
    return D_GGXRobust(s.alpha, NoH, dot(x, x));
#endif
  }
#endif
  return D_GGX(s.alpha, NoH);
}

// Visibility.
float visibilityTerm(SurfaceInfo s, vec3 l, float NoL) {
#if ANISOTROPY
  if (CHOSEN(visibility, VISIBILITY_TERM) == VISIBILITY_SMITH_SEPARABLE) {
    return G1_SmithAnisotropic(s.alphaT, s.alpha, NoL, dot(s.t, l), dot(s.b, l)) *
           G1_SmithAnisotropic(s.alphaT, s.alpha, s.NoV, dot(s.t, s.v), dot(s.b, s.v));
  }
  if (CHOSEN(distribution, DISTRIBUTION_TERM) == DISTRIBUTION_GTR2_ANISOTROPIC) {
    return V_SmithGGXCorrelatedAnisotropic(s.alphaT, s.alpha, s.NoV, NoL, dot(s.t, s.v), dot(s.b, s.v), dot(s.t, l), dot(s.b, l));
  }
#else
  if (CHOSEN(visibility, VISIBILITY_TERM) == VISIBILITY_SMITH_SEPARABLE) {
    return G1_SmithAnisotropic(s.alpha, s.alpha, NoL, sqrt(max(1.0 - pow2(NoL), 0.0)), 0.0) *
           G1_SmithAnisotropic(s.alpha, s.alpha, s.NoV, sqrt(max(1.0 - pow2(s.NoV), 0.0)), 0.0);
  }
#endif
  return V_SmithGGXCorrelated(s.alpha, s.NoV, NoL);
}

// Fresnel, linear Rec.709.
vec3 fresnelTerm(SurfaceInfo s, float LoH) {
  if (CHOSEN(fresnel, FRESNEL_TERM) == FRESNEL_SCHLICK) return mix(s.f0, vec3(1.0), F_SchlickWeight5(LoH));
  return F_Schlick(s.f0, 1.0, LoH);
}

float flatnessOf(SurfaceInfo s) {
#if FLATNESS
  return s.flatness;
#else
  return 0.0;
#endif
}

// Share of the diffuse light that goes through a thin surface.
float throughShare(SurfaceInfo s) {
#if DIFFUSE_TRANSMISSION
  return s.diffuseTransmission;
#else
  return 0.0;
#endif
}

// Diffuse lobe, [1/sr], linear Rec.709.
vec3 diffuseTerm(SurfaceInfo s, float NoL, float LoH, float LoV) {
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_DISNEY_2012
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_DISNEY_2012) {
    float factor = Fd_Burley(s.perceptualRoughness, s.NoV, NoL, LoH);
#if FLATNESS
    factor = mix(factor, Fd_HanrahanKrueger(s.perceptualRoughness, s.NoV, NoL, LoH), s.flatness);
#endif
    return s.diffuse * (RECIPROCAL_PI * factor);
  }
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_FROSTBITE
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_FROSTBITE) {
    return s.diffuse * (RECIPROCAL_PI * Fd_BurleyRenormalised(s.perceptualRoughness, s.NoV, NoL, LoH));
  }
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_EON
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_EON) return Fd_EON(s.diffuse, s.perceptualRoughness, s.NoV, NoL, LoV);
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_DISNEY_2015_THIN
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_DISNEY_2015_THIN) {
    vec2 factors = Fd_DisneyThin(s.perceptualRoughness, throughShare(s), flatnessOf(s), s.NoV, NoL, LoH);
    return s.diffuse * (RECIPROCAL_PI * factors.x);
  }
#endif
  return Fd_Lambert(s.diffuse);
}

#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_DISNEY_2012 || DIFFUSE_TERM == DIFFUSE_DISNEY_2015_THIN
// Directional albedo of Burley's diffuse lobe, flattened, [0, about 1.5].
float disneyAlbedo(SurfaceInfo s) {
  float factor = burleyAlbedo(s.perceptualRoughness, s.NoV);
#if FLATNESS
  factor = mix(factor, hanrahanKruegerAlbedo(s.perceptualRoughness, s.NoV), s.flatness);
#endif
  return factor;
}
#endif

// Directional albedo of the diffuse lobe, linear Rec.709: what light from everywhere finds.
vec3 diffuseAlbedoTerm(SurfaceInfo s) {
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_DISNEY_2012
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_DISNEY_2012) return s.diffuse * disneyAlbedo(s);
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_FROSTBITE
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_FROSTBITE) {
    return s.diffuse * burleyRenormalisedAlbedo(s.perceptualRoughness, s.NoV);
  }
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_EON
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_EON) return eonAlbedo(s.diffuse, s.perceptualRoughness, s.NoV);
#endif
#if ALL_TERMS || DIFFUSE_TERM == DIFFUSE_DISNEY_2015_THIN
  // Its unflattened lobe multiplies out to that of 2012.
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_DISNEY_2015_THIN) return s.diffuse * ((1.0 - throughShare(s)) * disneyAlbedo(s));
#endif
  return s.diffuse;
}

// Albedo of the diffuse lobe for light from the other side, linear Rec.709.
vec3 transmittedAlbedoTerm(SurfaceInfo s) {
#if DIFFUSE_TRANSMISSION
  if (CHOSEN(diffuse, DIFFUSE_TERM) == DIFFUSE_DISNEY_2015_THIN) {
    return s.transmittedColor * (s.diffuseTransmission * (1.0 - s.metallic));
  }
#endif
  return vec3(0.0);
}

#if SHEEN
// Sheen: what is the same for every light ...
SurfaceInfo withSheenTerm(SurfaceInfo s) {
#if ALL_TERMS || SHEEN_TERM == SHEEN_DISNEY_2012
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_DISNEY_2012) {
    s.sheenColor = sheenFromGltf(s.baseColor, s.sheenColor) * (1.0 - s.metallic);
  }
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_ZELTNER
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_ZELTNER) s.sheenLtc = sheenLtc(s.sheenRoughness, s.NoV);
#endif
  return s;
}

// ... and the lobe times NoL, per unit of sheen colour, [1/sr].
float sheenCosineTerm(SurfaceInfo s, vec3 l, float NoL, float NoH, float LoH) {
#if ALL_TERMS || SHEEN_TERM == SHEEN_DISNEY_2012
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_DISNEY_2012) return F_SchlickWeight5(LoH) * NoL;
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_ASHIKHMIN_VELVET
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_ASHIKHMIN_VELVET) {
    return D_Ashikhmin(pow2(s.sheenRoughness), NoH) * V_Neubelt(s.NoV, NoL) * NoL;
  }
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_CHARLIE_ESTEVEZ_KULLA
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_CHARLIE_ESTEVEZ_KULLA) {
    float alpha = pow2(s.sheenRoughness);
    return D_Charlie(alpha, NoH) * V_CharlieSoftened(alpha, s.NoV, NoL) * NoL;
  }
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_ZELTNER
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_ZELTNER) {
    // The lobe is the same on both sides of the plane of n and v: two of the three axes will do.
    float along = dot(l, safeNormalize(s.v - s.n * dot(s.n, s.v), vec3(0.0)));
    return sheenLtcCosine(s.sheenLtc, vec3(along, sqrt(max(1.0 - pow2(along) - pow2(NoL), 0.0)), NoL));
  }
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_UNCHARTED_4
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_UNCHARTED_4) return fuzzUncharted4(s.sheenRoughness, s.NoV) * (RECIPROCAL_PI * NoL);
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_CHARLIE_NEUBELT
  return Fr_SheenR115(vec3(1.0), max(s.perceptualRoughness, SHEEN_ROUGHNESS_MIN), s.NoV, NoL, NoH).x * NoL;
#else
  return 0.0;
#endif
}

// Its directional albedo, per unit of sheen colour.
float sheenAlbedoTerm(SurfaceInfo s) {
#if ALL_TERMS || SHEEN_TERM == SHEEN_DISNEY_2012
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_DISNEY_2012) return sheenAlbedoDisney(s.NoV);
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_ASHIKHMIN_VELVET
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_ASHIKHMIN_VELVET) return sheenAlbedoVelvet(s.sheenRoughness, s.NoV);
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_CHARLIE_ESTEVEZ_KULLA
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_CHARLIE_ESTEVEZ_KULLA) return sheenAlbedoEstevezKulla(s.sheenRoughness, s.NoV);
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_ZELTNER
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_ZELTNER) return s.sheenLtc.x;
#endif
#if ALL_TERMS || SHEEN_TERM == SHEEN_UNCHARTED_4
  if (CHOSEN(sheen, SHEEN_TERM) == SHEEN_UNCHARTED_4) return fuzzUncharted4(s.sheenRoughness, s.NoV);
#endif
  return sheenAlbedoR115(s.perceptualRoughness, s.NoV);
}
#endif

#if CLEARCOAT
// Coat: roughness that its lobe has ...
SurfaceInfo withCoatTerm(SurfaceInfo s) {
#if ALL_TERMS || CLEARCOAT_TERM == CLEARCOAT_DISNEY_2012
  if (CHOSEN(clearcoat, CLEARCOAT_TERM) == CLEARCOAT_DISNEY_2012) {
    s.clearcoatRoughness = sqrt(mix(0.1, 0.001, glossFromGltf(s.clearcoatRoughness)));
  }
#endif
  return s;
}

// ... the lobe per unit of its weight, [1/sr] ...
float coatTerm(SurfaceInfo s, float NoL, float NoH, float LoH) {
#if ALL_TERMS || CLEARCOAT_TERM == CLEARCOAT_DISNEY_2012
  if (CHOSEN(clearcoat, CLEARCOAT_TERM) == CLEARCOAT_DISNEY_2012) {
    return Fr_ClearcoatDisney(1.0, glossFromGltf(s.clearcoatRoughness), s.clearcoatNoV, NoL, NoH, LoH);
  }
#endif
  return Fr_GGX(vec3(F0_DIELECTRIC), 1.0, max(pow2(s.clearcoatRoughness), 0.001), s.clearcoatNoV, NoL, NoH, LoH).x;
}

// ... and its directional albedo.
float coatAlbedoTerm(SurfaceInfo s) {
#if ALL_TERMS || CLEARCOAT_TERM == CLEARCOAT_DISNEY_2012
  if (CHOSEN(clearcoat, CLEARCOAT_TERM) == CLEARCOAT_DISNEY_2012) {
    return clearcoatAlbedoDisney(glossFromGltf(s.clearcoatRoughness), s.clearcoatNoV);
  }
#endif
  return F0_DIELECTRIC * s.coatDfg.x + s.coatDfg.y;
}
#endif

// Environment BRDF: (A, B) of the split sum with Smith's correlated visibility.
// table  the same as the table holds it
vec2 environmentTerm(SurfaceInfo s, float perceptualRoughness, float NoV, vec2 table) {
#if ALL_TERMS || ENVIRONMENT_TERM == ENVIRONMENT_KARIS
  if (CHOSEN(environment, ENVIRONMENT_TERM) == ENVIRONMENT_KARIS) return dfgKaris(perceptualRoughness, NoV);
#endif
#if ALL_TERMS || ENVIRONMENT_TERM == ENVIRONMENT_LAZAROV
  if (CHOSEN(environment, ENVIRONMENT_TERM) == ENVIRONMENT_LAZAROV) return dfgLazarov(perceptualRoughness, NoV);
#endif
  return table;
}

// Scattering: how the split sum becomes what the interface sends back.
Scattering scatteringTerm(SurfaceInfo s) {
#if ALL_TERMS || SCATTERING_TERM == SCATTERING_FDEZ_AGUERA
  if (CHOSEN(scattering, SCATTERING_TERM) == SCATTERING_FDEZ_AGUERA) {
    return multipleScatteringR115(s.f0, s.perceptualRoughness, s.NoV, s.dfg);
  }
#endif
  return Scattering(max(s.f0 * s.dfg.x + s.dfg.y, 0.0), vec3(0.0));
}
