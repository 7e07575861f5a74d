// The features that shaders/shading and shaders/material/layers.glsl ask for, and every shading.
#define SPECULAR 1
#define DIFFUSE_ROUGHNESS 1
#define ANISOTROPY 1
#define IRIDESCENCE 1
#define SHEEN 1
#define CLEARCOAT 1
#define CLEARCOAT_NORMAL_MAP 1
#define DIFFUSE_TRANSMISSION 1
#define FLATNESS 1
#define WEAVE 1
#define WEAVE_MAP 1
#define NORMAL_MAP 1
#define NORMAL_VARIANCE 0
#define SHADING_THREE 1
#define SHADING_PRINCIPLED 1
#define SHADING_FABRIC 1
#define ALL_TERMS 1
#define CHOSEN(slot, number) s.terms.slot
