// Texture coordinates of what FabricLayers adds, vertex stage.
#if DIFFUSE_TRANSMISSION_MAP
uniform mat3 diffuseTransmissionUvTransform;
out vec2 vDiffuseTransmissionUv;
#endif
#if DIFFUSE_TRANSMISSION_COLOR_MAP
uniform mat3 diffuseTransmissionColorUvTransform;
out vec2 vDiffuseTransmissionColorUv;
#endif
#if WEAVE_MAP
uniform mat3 weaveUvTransform;
out vec2 vWeaveUv;
#endif
#if BACK_COLOR_MAP
uniform mat3 backColorUvTransform;
out vec2 vBackColorUv;
#endif
