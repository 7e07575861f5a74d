// The features that shaders/shading asks for, and every shading.
#define DIFFUSE_ROUGHNESS 1
#define ANISOTROPY 1
#define IRIDESCENCE 1
#define SHEEN 1
#define CLEARCOAT 1
#define DIFFUSE_TRANSMISSION 1
#define FLATNESS 1
#define WEAVE 1
#define WEAVE_MAP 1
#define NORMAL_MAP 1
#define SHADING_THREE 1
#define SHADING_PRINCIPLED 1
#define SHADING_FABRIC 1
#define ALL_TERMS 1
#define CHOSEN(slot, number) s.terms.slot
