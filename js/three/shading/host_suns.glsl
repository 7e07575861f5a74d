// Suns of the environment among the directional lights of three.js.
#if SUNS > 0
uniform vec3 sunColors[SUNS];  // times intensity, linear Rec.709, as of lights

// three.js gives shaders no names of lights: a sun is known by its colour, which no shadow changes.
bool isSun(vec3 lightColor) {
  for (int i = 0; i < SUNS; ++i) {
    if (lightColor == sunColors[i]) return true;
  }
  return false;
}
#endif
