// A point in the shadow maps: material/varyings.glsl says what VARYING is.
#if FLAT_SHADOWS > 0
VARYING vec4 vFlatShadowCoord[FLAT_SHADOWS];
#endif
#if CUBE_SHADOWS > 0
VARYING vec4 vCubeShadowCoord[CUBE_SHADOWS];
#endif
