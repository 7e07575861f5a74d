// Punctual and hemispherical light. Shared text: see README.md.

// Unit half vector of unit l and v. Where they are opposite (an orthographic view against the light) the sum has no
// direction: the normal stands in, so that no NaN arises; such light has NoL = 0.
// n  unit normal      l  unit, to the light      v  unit, to the viewer      all in one space
vec3 halfVector(vec3 n, vec3 l, vec3 v) {
  vec3 sum = l + v;
  float squaredLength = dot(sum, sum);
  return squaredLength > SQUARED_LENGTH_EPSILON ? sum * inversesqrt(squaredLength) : n;
}

// Falloff of a point or spot light, [1/m^2]: 1/d^2, capped at 100, faded to 0 at the range.
// lightDistance  [0, inf) m      range  [0, inf) m, 0 = no limit
// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", eq. 26; cap of three r187
float distanceAttenuation(float lightDistance, float range) {
  float attenuation = 1.0 / max(pow2(lightDistance), 0.01);
  if (range > 0.0) {
    attenuation *= pow2(saturate(1.0 - pow4(lightDistance / range)));
  }
  return attenuation;
}

// Cone of a spot light, [0, 1]: 0 outside the outer cone, 1 inside the inner one, cubic between.
// outerCos, innerCos  cosines of the half angles, outerCos <= innerCos      angleCos  cosine of the angle off the axis
// The floor answers a hard cone (outer = inner), which smoothstep leaves undefined; it is below one ulp of a cosine.
// src: three r187
float spotAttenuation(float outerCos, float innerCos, float angleCos) {
  float t = saturate((angleCos - outerCos) / max(innerCos - outerCos, 1.0e-8));
  return t * t * (3.0 - 2.0 * t);
}

// Irradiance of a two-colour dome, in the unit of its colours, linear Rec.709.
// skyColor, groundColor  >= 0      NoUp  [-1, 1]  cosine between the normal and the dome's axis
// src: three r187
vec3 hemisphereIrradiance(vec3 skyColor, vec3 groundColor, float NoUp) {
  return mix(groundColor, skyColor, 0.5 * NoUp + 0.5);
}
