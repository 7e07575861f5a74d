// What light/area.glsl reads of the renderer; of three.js: js/three/shading/host.glsl.
#if RECT_LIGHTS > 0
uniform vec3 rectPosition[RECT_LIGHTS];    // centres
uniform vec3 rectHalfWidth[RECT_LIGHTS];   // from the centre to the middle of an edge
uniform vec3 rectHalfHeight[RECT_LIGHTS];  // it shines towards cross(rectHalfHeight, rectHalfWidth)
uniform vec3 rectColor[RECT_LIGHTS];
#endif
#if DISK_LIGHTS > 0
uniform vec3 diskPosition[DISK_LIGHTS];  // centres
uniform vec3 diskX[DISK_LIGHTS];         // from the centre to the rim
uniform vec3 diskY[DISK_LIGHTS];         // square with it; the disk shines towards cross(diskY, diskX)
uniform vec3 diskColor[DISK_LIGHTS];
#endif
uniform sampler2D ltcInverseMap;  // RGBA = the entries that ltcInverse takes; for both see ltcCoordinates
uniform sampler2D ltcAlbedoMap;   // RG = scale and bias of f0

#if RECT_LIGHTS > 0
AreaLight rectLight(int i) { return AreaLight(rectPosition[i], rectHalfWidth[i], rectHalfHeight[i], rectColor[i], false); }
#endif
