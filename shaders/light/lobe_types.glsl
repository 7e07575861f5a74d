// The lobes of a surface as importance sampling draws from them. Also compiled as C++, with every layer on
// (renderer/brdf/shading.h).

// A GGX lobe.
struct MicrofacetLobe {
  mat3 frame;  // columns x, y, normal
  vec3 v;      // to the viewer, in the frame
  vec2 alpha;
};

// Every lobe has its share of the samples. The shares sum to 1. A lobe of share 0 is not set.
struct LobeMixture {
  mat3 cosineFrame;
  float cosineShare;
  MicrofacetLobe base;      // of a weave, its warp
  float baseShare;
#if WEAVE
  bool woven;
  MicrofacetLobe weft;
  float weftShare;
#endif
#if DIFFUSE_TRANSMISSION
  float transmissionShare;  // of a cosine lobe on the other side
#endif
#if SHEEN
  float sheenShare;
#if SHADING_FABRIC
  mat3 sheenFrame;          // x holds the viewer
  vec3 sheenLtc;
#endif
#endif
#if CLEARCOAT
  MicrofacetLobe coat;
  float coatShare;
#endif
};
