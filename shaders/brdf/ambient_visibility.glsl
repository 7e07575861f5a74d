// Light from everywhere where a part of the hemisphere is hidden: baked per vertex. Shared text: see README.md.

// Factor on indirect diffuse light, [0, 1]: what hides the sky is lit itself, and of the same colour.
// visibility  [0, 1]  open part of the hemisphere, by the cosine      albedo  [0, 1]
// src: Jimenez, Wu, Pesce & Jarabo 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion", section 5: a cubic
//      fitted to path traced scenes. It gives 1.0001 for a white surface with all of it open.
vec3 multiBounceVisibility(float visibility, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324;
  vec3 b = 0.6417 - 4.7951 * albedo;
  vec3 c = 2.7552 * albedo + 0.6903;
  return clamp(visibility * (visibility * (visibility * a + b) + c), vec3(visibility), vec3(1.0));
}

// The factor that is left to the vertices where a map has its own: together they are the smaller of both.
// visibility, occlusion  [0, 1]
float visibilityBesideMap(float visibility, float occlusion) {
  return min(visibility / max(occlusion, 1.0e-4), 1.0);
}

// Radians, [0, PI], within 7e-5. The same on every GL, which leaves the accuracy of its own to the driver.
// src: Abramowitz & Stegun 1964, formula 4.4.45
float arcCosine(float x) {
  float y = abs(x);
  float angle = sqrt(max(1.0 - y, 0.0)) * (1.5707288 + y * (y * (0.0742610 - 0.0187293 * y) - 0.2121144));
  return x < 0.0 ? PI - angle : angle;
}

// Solid angle over 2 PI that two cones have in common, [0, 1].
// cosA, cosB  [0, 1]  of their half angles      cosBetween  [-1, 1]  of the angle between their axes
// src: Oat & Sander 2007, "Ambient Aperture Lighting", eq. 3: a smooth step between none and all of the smaller one
float conesIntersection(float cosA, float cosB, float cosBetween) {
  float a = arcCosine(cosA);
  float b = arcCosine(cosB);
  float apart = abs(a - b);
  float inside = 1.0 - saturate((arcCosine(cosBetween) - apart) / max(a + b - apart, 1.0e-4));
  return (1.0 - max(cosA, cosB)) * inside * inside * (3.0 - 2.0 * inside);
}

// Numbers of vertices tell no sharper border than the cone of this roughness, 12 degrees.
const float CONE_ROUGHNESS_MIN = 0.1;

// Factor on indirect specular light, [0, 1]: the part of the lobe's cone within the open cone, over its part above the horizon.
// visibility  [0, 1]      perceptualRoughness  [0, 1]
// cosOpen, cosFace  [-1, 1]  of the angles of the lobe's direction with the mean open direction and with the normal
// src: Jimenez et al. 2016, section 6: a cone that is open in the cosine's measure V has the half angle acos(sqrt(1 - V)), that of
//      the lobe is acos(10^-roughness^2). Its division by the horizon, so that a surface that nothing hides stays as it is, is ours.
float specularVisibility(float visibility, float perceptualRoughness, float cosOpen, float cosFace) {
  float lobe = exp2(-3.3219281 * pow2(max(perceptualRoughness, CONE_ROUGHNESS_MIN)));
  float seen = conesIntersection(sqrt(1.0 - visibility), lobe, cosOpen);
  float whole = conesIntersection(0.0, lobe, cosFace);
  return seen < whole ? seen / whole : 1.0;
}
