// Vertex stage: where a point lies in the shadow maps. FLAT_SHADOWS maps of spot and directional lights, CUBE_SHADOWS of
// point lights.
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
uniform mat4 viewMatrix;
#endif
#include "shadow/varyings.glsl"
#if FLAT_SHADOWS > 0
uniform mat4 flatShadowMatrix[FLAT_SHADOWS];  // world to map coordinates 0..1, after / w
uniform float flatShadowNormalBias[FLAT_SHADOWS];  // metres
#endif
#if CUBE_SHADOWS > 0
uniform mat4 cubeShadowMatrix[CUBE_SHADOWS];  // world to the vector from the light
uniform float cubeShadowNormalBias[CUBE_SHADOWS];
#endif

#include "shading/three_terms.glsl"
#if THREE_SHADOW_NORMAL_OFFSET_TERM == THREE_SHADOW_NORMAL_OFFSET_NO_PLACE
const float BEYOND_EVERY_MAP = 1e15;  // metres
#endif

#if SHADING_FABRIC && FLAT_SHADOWS + CUBE_SHADOWS > 0
#include "shadow/offset.glsl"
#endif

#if FLAT_SHADOWS + CUBE_SHADOWS > 0
// point       mesh space
// viewNormal  view space, any length; 0 where the mesh has none
void setShadowCoords(vec3 point, vec3 viewNormal) {
  vec4 world = modelMatrix * vec4(point, 1.0);
  vec3 normal = vec3(0.0);
  if (viewNormal != vec3(0.0)) normal = normalize((vec4(viewNormal, 0.0) * viewMatrix).xyz);
#if THREE_SHADOW_NORMAL_OFFSET_TERM == THREE_SHADOW_NORMAL_OFFSET_NO_PLACE
  // three.js normalises a vector of length 0 here, and what is not a number lies in no map and before nothing.
  else {
#repeat FLAT_SHADOWS
    vFlatShadowCoord[INDEX] = vec4(-1.0, -1.0, -1.0, 1.0);
#end
#repeat CUBE_SHADOWS
    vCubeShadowCoord[INDEX] = vec4(BEYOND_EVERY_MAP, 0.0, 0.0, 1.0);
#end
    return;
  }
#endif
#if SHADING_FABRIC
#repeat FLAT_SHADOWS
  vFlatShadowCoord[INDEX] =
      flatShadowMatrix[INDEX] *
      offsetToLight(world, normal * flatShadowNormalBias[INDEX], toFlatLight(flatShadowMatrix[INDEX], world));
#end
#repeat CUBE_SHADOWS
  vCubeShadowCoord[INDEX] =
      cubeShadowMatrix[INDEX] *
      offsetToLight(world, normal * cubeShadowNormalBias[INDEX], -vec3(cubeShadowMatrix[INDEX] * world));
#end
#else
#repeat FLAT_SHADOWS
  vFlatShadowCoord[INDEX] = flatShadowMatrix[INDEX] * (world + vec4(normal * flatShadowNormalBias[INDEX], 0.0));
#end
#repeat CUBE_SHADOWS
  vCubeShadowCoord[INDEX] = cubeShadowMatrix[INDEX] * (world + vec4(normal * cubeShadowNormalBias[INDEX], 0.0));
#end
#endif
}
#endif
