// Textures and factors of what FabricLayers adds (renderer/include/telar/fabric.h). Factors are linear Rec.709.
#if DIFFUSE_TRANSMISSION_MAP
uniform sampler2D diffuseTransmissionMap;  // linear: A
in vec2 vDiffuseTransmissionUv;
#endif
#if DIFFUSE_TRANSMISSION_COLOR_MAP
uniform sampler2D diffuseTransmissionColorMap;  // sRGB
in vec2 vDiffuseTransmissionColorUv;
#endif
#if WEAVE_MAP
uniform sampler2D weaveMap;  // linear: RG turn of the yarn, B its slope, A 0 weft .. 1 warp
in vec2 vWeaveUv;
#endif
#if BACK_COLOR_MAP
uniform sampler2D backColorMap;  // sRGB
in vec2 vBackColorUv;
#endif

#if DIFFUSE_TRANSMISSION
uniform float diffuseTransmissionFactor;
uniform vec3 diffuseTransmissionColorFactor;
#endif
#if FLATNESS
uniform float flatness;
#endif
#if WEAVE
uniform vec2 yarnCoverage;       // warp, weft
uniform vec2 yarnRoughness;      // perceptual, along the yarn
uniform vec2 yarnAnisotropy;     // across it: alpha = mix(roughness^2, 1, anisotropy^2)
uniform vec3 warpSpecularColor;
uniform vec3 weftSpecularColor;
uniform vec2 threadsPerUv;       // yarns in one unit of vWeaveUv: warp, weft; 0 = not known
#endif
#if BACK
uniform vec3 backColorFactor;
uniform float backRoughness;     // perceptual
#endif
