// Inside main() of the vertex stage: see fabric_varyings.glsl.
#if DIFFUSE_TRANSMISSION_MAP
vDiffuseTransmissionUv = vec2(diffuseTransmissionUvTransform * vec3(DIFFUSE_TRANSMISSION_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if DIFFUSE_TRANSMISSION_COLOR_MAP
vDiffuseTransmissionColorUv = vec2(diffuseTransmissionColorUvTransform * vec3(DIFFUSE_TRANSMISSION_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if WEAVE_MAP
vWeaveUv = vec2(weaveUvTransform * vec3(WEAVE_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if BACK_COLOR_MAP
vBackColorUv = vec2(backColorUvTransform * vec3(BACK_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
