// Directions on the square [-1, 1]^2: an octahedron, whose lower half is folded out.
// src: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2), listing 1

vec2 octahedronFolded(vec2 place) {
  return (1.0 - abs(place.yx)) * vec2(place.x < 0.0 ? -1.0 : 1.0, place.y < 0.0 ? -1.0 : 1.0);
}

// d  of any length
vec2 octahedronPlace(vec3 d) {
  vec2 place = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
  return d.z < 0.0 ? octahedronFolded(place) : place;
}

// Not unit.
vec3 octahedronDirection(vec2 place) {
  float z = 1.0 - abs(place.x) - abs(place.y);
  return vec3(z < 0.0 ? octahedronFolded(place) : place, z);
}
