// One quantity of the shading in place of the colour. RGB holds it; A is 1 where the material has it, so that nothing is
// blended with it, else all are 0.
uniform int debugOutput;  // position in telar::DebugOutput

// What every material has.
vec4 debugColor(vec4 baseColor, vec3 radiance) {
  switch (debugOutput) {
    case 2: return vec4(baseColor.rgb, 1.0);
    case 3: return vec4(vec3(baseColor.a), 1.0);
    case 14: return vec4(radiance, 1.0);
    case 15: return vec4(outputColor(radiance, 1.0).rgb, 1.0);
  }
  return vec4(0.0);
}

#if !UNLIT
vec3 debugSum(SurfaceInfo s, Reflected reflected) {
  vec3 sum = reflected.diffuse + reflected.specular;
#if SHEEN
  sum += reflected.sheen;
#endif
#if CLEARCOAT
  sum += reflected.coat * s.clearcoat;
#endif
  return sum;
}

#if TRANSMISSION
vec4 debugTransmitted(vec4 transmitted) {
  return debugOutput == 13 ? vec4(vec3(transmitted), 1.0) : vec4(0.0);
}
#endif

// What lit materials have.
vec4 debugShading(SurfaceInfo s, Incident incident, Reflected direct, Reflected indirect) {
  switch (debugOutput) {
    case 1: return vec4(s.n, 1.0);
    case 4: return vec4(vec3(s.metallic), 1.0);
    case 5: return vec4(vec3(s.perceptualRoughness), 1.0);
    case 6: return vec4(s.f0, 1.0);
    case 7: return vec4(vec3(s.NoV), 1.0);
#if SHADING_FABRIC
    case 8: return vec4(s.albedo.base, 0.0, 1.0);
#else
    case 8: return vec4(s.dfg, 0.0, 1.0);
#endif
    case 9: return vec4(incident.radiance, 1.0);
    case 10: return vec4(incident.irradiance + incident.environmentIrradiance, 1.0);
    case 11: return vec4(debugSum(s, direct), 1.0);
    case 12: return vec4(debugSum(s, indirect), 1.0);
  }
  return vec4(0.0);
}
#endif
