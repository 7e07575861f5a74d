// The first form of the neutral display transform. Shared text: see README.md.

// As toneMapNeutral(), but bright colours fade towards white, not towards the grey of their own peak.
// src: Khronos 2024, "PBR Neutral Tone Mapper Specification", before its revision of May 2024; three r162
vec3 toneMapNeutralWhite(vec3 color, float exposure) {
  float knee = 0.76;
  vec3 scene = exposedColor(color, exposure);
  float darkest = min3(scene);
  vec3 x = scene - (darkest < 0.08 ? darkest * (1.0 - 6.25 * darkest) : 0.04);
  float brightest = max3(x);
  if (brightest < knee) {
    return x;
  }
  float room = 1.0 - knee;
  float rolled = 1.0 - pow2(room) / (brightest + room - knee);
  float faded = 1.0 / (0.15 * (brightest - rolled) + 1.0);
  return x * (rolled / brightest) * faded + (1.0 - faded);
}
