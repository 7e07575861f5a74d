// Numbers that more than one term uses. Shared text: see README.md.

const float PI = 3.141592653589793;
const float RECIPROCAL_PI = 0.3183098861837907;

// Smallest perceptual roughness that is shaded: keeps a mirror's highlight wider than a pixel. three r187
const float PERCEPTUAL_ROUGHNESS_MIN = 0.045;

// Normal reflectance of a dielectric with index of refraction 1.5, linear.
const float F0_DIELECTRIC = 0.04;

// Floor of the visibility denominator: 0/0 at NoV = NoL = 0 becomes 0. three r187
const float VISIBILITY_EPSILON = 1.0e-6;

// Floor of a sum of products of cosines and widths: what it divides is 0 as well.
const float COSINE_EPSILON = 1.0e-20;

// Least share of light that a dielectric interface lets pass on average: with f0 = 1 there is none, and rounding divides.
const float PASSING_MIN = 1.0e-4;

// Smallest sheen roughness of cloth: below it the fit's lobe leaves the rim only.
const float CLOTH_SHEEN_ROUGHNESS_MIN = 0.07;

// Floor of a squared length below which a sum of unit vectors has no direction.
const float SQUARED_LENGTH_EPSILON = 1.0e-12;

// Squared sine below which the angle to the viewer is 0: fp32 holds the direction of v - n (n.v) no more than to 1 %.
const float HEAD_ON_EPSILON = 1.0e-10;

// Largest finite half float: brighter is white for every tone curve, and inf/inf = NaN is kept out of them.
const float RADIANCE_MAX = 65504.0;

// Longest path through a volume, metres: its product with an attenuation of 0 stays 0.
const float PATH_LENGTH_MAX = 1.0e30;

// Floor of the denominators of the rough diffuse lobe. three r187
const float EON_EPSILON = 1.0e-7;

// Smallest sheen roughness: 1 / alpha stays finite in fp32. three r187
const float SHEEN_ROUGHNESS_MIN = 1.0e-4;

// Mean of sheetAlbedo() over the cosine-weighted hemisphere: 1/2 - (4 ln 2 - 1) / 6.
const float SHEET_AVERAGE = 0.2045685;

// Of facets.glsl.
const float FACET_SLOPE2 = 0.09;  // square of the slope from which on a texel counts more as edge
const float FACET_SHARE_MIN = 1.0e-4;  // half floats hold slopes times it
const float EDGE_ALPHA = 0.7;     // width of the highlight of edges, about the normal of the geometry
const float EDGE_KEPT = 0.42;     // of its light: edges turn the rest below the horizon
