// What shading takes and gives. Also compiled as C++, with every layer on (renderer/brdf/shading.h).

// Whether a normal map may have what is finer than a pixel.
#define RELIEF (NORMAL_MAP && NORMAL_VARIANCE)

// Whether a polished relief has two highlights: of its flat facets, whose normal is the shading normal, and of the edges between them.
#define FACETS (RELIEF && NORMAL_FACETS)

#if FACETS
// The highlight of the edges, about the normal of the geometry.
struct EdgeLobe {
  float share;        // of the surface, [0, 1]; 0: there is one highlight
  // preparedSurface() sets the rest.
  vec3 n;             // view space
  float NoV;
  vec3 reflectance;   // share of uniform light that it reflects after one bounce
};
#endif

// Normals and tangent frame at one point, view space.
struct Normals {
  vec3 geometric;  // interpolated (or of the flat face), turned to the viewer on double-sided surfaces
  vec3 shading;    // after the normal map
#if CLEARCOAT
  vec3 coat;       // after the clearcoat's own normal map
#endif
#if NORMAL_VARIANCE
  vec2 relief;             // of the normal map within the pixel: x 1 - length of the mean normal, y variance of the slopes about
                           // it that most of the surface has, the sum of both axes
  vec3 reliefAxis;         // across its lines, where it runs along some: as long as reliefTowards() says
#if CLEARCOAT
  vec2 coatRelief;
#endif
#endif
#if FACETS
  float edgeShare;         // of a polished normal map: what of the pixel is edges between facets
  float facetsTold;        // of the light from one direction, what is shaded place by place (light/facets.glsl), [0, 1]
#endif
#if ANISOTROPY || WEAVE
  mat3 frame;      // columns: tangent, bitangent, geometric normal
#endif
#if YARN_RELIEF
  vec2 meanSlope;          // of the normal map within the pixel, +Y up the texture
#endif
#if WEAVE
  float upward;    // 1: the bitangent is Y of the tangent space, the texture's v upwards; -1: it runs against it
#endif
};

#if WEAVE
// One set of parallel yarns as they lie at a point of cloth, view space.
struct YarnLobe {
  vec3 t;              // along the yarn
  vec3 b;              // across it
  vec3 n;              // square to both; leans where the yarn dips under another
  float coverage;      // share of the surface that shows it; 0 in both sets means no weave
  float alphaT;        // along
  float alphaB;        // across
  vec3 specularColor;  // factor on the normal reflectance, [0, 1]
  vec3 lying;          // t without its slope
  float metallic;
#if RELIEF
  vec2 slopeVariance;  // of the normals within the pixel, along it and across it, each twice that of the axis
  vec2 glossKept;      // preparedSurface() sets it, as in SurfaceInfo
#endif
  // preparedSurface() sets the rest, as in SurfaceInfo.
  StretchedCurve gloss;
  vec2 albedo;
  vec3 f0;
  vec3 f0Dielectric;
  vec3 returning;
  vec3 returningLobe;
  vec3 returningDielectric;
};
#endif

#if SHADING_FABRIC
// glossAlbedo() of a surface for one direction.
struct GlossAlbedo {
  vec2 base;           // of its one lobe; of a weave, of the warp
#if WEAVE
  vec2 weft;
#endif
};
#endif

// Everything the lights need to know of one point of a surface.
struct SurfaceInfo {
#if ALL_TERMS
  ThreeTerms three;          // of a release of three.js, chosen at run time: in C++ only
#endif
  vec3 n;          // shading normal, view space
  vec3 v;          // to the viewer, view space
  vec3 baseColor;  // linear Rec.709
  float metallic;  // of a woven cloth whose metal lies in some yarns: their mean
  vec3 diffuse;    // albedo of the diffuse lobe
  vec3 f0;         // of the dielectric-metal blend
  vec3 f0Dielectric;
  float f90;
  float perceptualRoughness;  // floor and geometric roughness applied; of a principled shading as authored
  float alpha;
  float NoV;
#if SHADING_THREE || SHADING_PRINCIPLED
  vec2 dfg;
#endif
#if DIFFUSE_ROUGHNESS
  float diffuseRoughness;
#endif
#if ANISOTROPY || WEAVE
  vec3 t;          // along which the highlight is stretched, view space; of a weave, along its weft
  vec3 b;
  float anisotropyStrength;
  float alphaT;
#endif
#if IRIDESCENCE
  float iridescence;        // weight of the film
  vec3 filmFresnel;         // reflectance of film and base
  vec3 filmF0Dielectric;    // the same as a normal reflectance
  vec3 filmF0Metal;
#endif
#if SHEEN
  vec3 sheenColor;
  float sheenRoughness;
#endif
#if CLEARCOAT
  vec3 coatNormal;
  float clearcoat;
  float clearcoatRoughness;
  float clearcoatNoV;
#if SHADING_THREE || SHADING_PRINCIPLED
  vec2 coatDfg;
#endif
#endif
#if FLATNESS
  float flatness;             // share of subsurface scattering, or of a thin sheet's, in the diffuse lobe
#endif
#if DIFFUSE_TRANSMISSION
  float diffuseTransmission;  // share of the diffuse light that goes through
  vec3 transmittedColor;      // its colour, linear Rec.709
#endif
#if SHADING_PRINCIPLED
#if ALL_TERMS
  ShadingTerms terms;        // chosen at run time: in C++ only
#endif
#if SHEEN
  vec3 sheenLtc;             // by preparedSurface, where the sheen is a transformed cosine
#endif
#endif
#if SHADING_THREE
  vec3 compensation;  // factor on the GGX lobe of one direction
#endif
#if SHADING_FABRIC
  vec3 metalColor;            // base colour of what is metal; baseColor is that of the rest
#if NORMAL_MAP
  vec3 geometricNormal;       // before the normal map
#endif
#if RELIEF
  float relief;               // as Normals has it and the next two
  float slopeVariance;
  vec3 reliefAxis;
#endif
#if FACETS
  EdgeLobe edges;
  float facetsTold;           // share of light from one direction that these two highlights leave to light/facets.glsl, [0, 1]
#endif
#if WEAVE
  YarnLobe warp;
  YarnLobe weft;
#endif
#if AMBIENT_VISIBILITY
  vec3 faceNormal;            // before the normal map
  vec3 openDirection;         // mean of those that nothing hides
  float visibility;           // open part of the hemisphere, by the cosine
  float visibilityBehind;     // the same of the other side
#endif
  // preparedSurface() of fabric.glsl sets the rest.
#if ANISOTROPY
  StretchedCurve stretched;
#endif
  GlossCurve gloss;           // of a lobe of one width
  GlossAlbedo albedo;         // towards the viewer
  vec3 returning;             // share of what one bounce does not reflect that more bounces do
  vec3 returningLobe;         // the same as a lobe towards the viewer, for a light of missing share 1, [1/sr]
  vec3 returningDielectric;
  vec3 leaving;               // share of the light under the dielectric interface that passes towards the viewer
  vec3 passing;               // the same, relative to the average over all directions
#if NORMAL_MAP
  float bumpAlpha2;           // of bumpTerminator()
#endif
  float glossRoughness;       // perceptual, of a texel
#if RELIEF
  float reliefSeen;           // of reliefTowards(), towards the viewer
  vec2 glossKept;             // of reliefGloss()
#endif
#if SHEEN
  float sheenAlbedo;          // at NoV, per unit of colour
#if RELIEF
  SheenRing sheenRing;        // where relief is above 0
#endif
  vec4 sheenView;
#endif
#if CLEARCOAT
  float coatAlbedo;           // at clearcoatNoV
#endif
#endif
};

// Light from everywhere that arrives at a surface, linear Rec.709.
struct Incident {
  vec3 irradiance;             // ambient and hemisphere
  vec3 environmentIrradiance;
  vec3 radiance;               // environment, as the lobe of the base layer sees it
#if CLEARCOAT
  vec3 coatRadiance;           // the same for the coat
#endif
#if DIFFUSE_TRANSMISSION
  vec3 behind;                 // irradiance of all these on the other side
#endif
#if SHADING_FABRIC && WEAVE
  vec3 weftRadiance;           // environment, as the weft sees it: `radiance` is that of the warp
#endif
#if SHADING_FABRIC && FACETS
  vec3 edgeRadiance;           // environment, as the edges see it
#endif
#if SHADING_FABRIC && SHEEN
  vec3 sheenRadiance;          // environment, as the sheen sees it
#endif
};

// Light that leaves the surface towards the viewer, by lobe, linear Rec.709.
struct Reflected {
  vec3 diffuse;
  vec3 specular;
#if SHEEN
  vec3 sheen;
#endif
#if CLEARCOAT
  vec3 coat;
#endif
};
