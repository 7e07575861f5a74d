// Structs that terms return. Shared text: see README.md.

// The two reads of a cubic filter along one axis.
struct BicubicTaps {
  float lowWeight;   // of the read before the place, [1/6, 5/6]
  float highWeight;  // of the read behind it: they sum to 1
  float lowOffset;   // from the texel before the place, texels
  float highOffset;
};

// How much a GGX lobe of one width reflects, as curves over the cosine of its direction: see cloth_energy.glsl.
struct GlossCurve {
  vec4 missing;        // of the light that a lobe of f0 = f90 = 1 does not reflect at once
  float missingSlope;
  vec4 grazing;        // of the part of its reflectance that belongs to f90
};

// The same of a lobe of two widths: see yarn_energy.glsl.
struct StretchedCurve {
  float wide2;      // squares of the widths
  float narrow2;
  float middle2;    // of the even lobe whose curves are read
  GlossCurve even;
  vec4 missing;     // what scales its missing share
  vec4 width;       // what scales the width by which its grazing share is read, and adds to it
  float lift;
  vec4 grazing;     // what scales that share
  vec2 average;     // of both over the cosine-weighted hemisphere
};

// What a specular interface sends back under uniform light of radiance 1, linear Rec.709, each [0, 1].
struct Scattering {
  vec3 single;    // after one bounce between the microfacets
  vec3 multiple;  // after two and more
};

// Of the viewer with the normals of a relief: see relief.glsl.
struct LeaningCosines {
  vec2 towards;
  vec2 away;
  float aside;
};

// One normal of a relief, and the sheen there: see relief.glsl.
struct SheenNormal {
  vec3 n;     // unit; one that faces away is turned to where it just faces the viewer
  float NoV;  // [0, 1]
  vec4 view;  // sheenView()
};

// Sheen of a relief: see relief.glsl.
struct SheenRing {
  SheenNormal first;
  SheenNormal second;
  SheenNormal third;
  SheenNormal againstFirst;  // these lean the other way
  SheenNormal againstSecond;
  SheenNormal againstThird;
  float alpha2;  // of bumpTerminator()
};

// Lobes of the environment: see relief.glsl.
struct SheenTaps {
  vec3 front;       // unit; the others have a weight alone where they are
  vec3 left;
  vec3 right;
  float aside;      // weight of each of these two, [0, 0.4]
  float roughness;  // perceptual, of each
};
