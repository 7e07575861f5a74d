// Structs that terms return. Shared text: see README.md.

// What a specular interface sends back under uniform light of radiance 1, linear Rec.709, each [0, 1].
struct Scattering {
  vec3 single;    // after one bounce between the microfacets
  vec3 multiple;  // after two and more
};
