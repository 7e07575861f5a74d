// The features that shaders/shading and shaders/material/layers.glsl ask for, and every shading.
#include "brdf/layers_on.inc"
#define CLEARCOAT_NORMAL_MAP 1
#define WEAVE_MAP 1
#define NORMAL_MAP 1
#define NORMAL_VARIANCE 1
#define NORMAL_FACETS 1
#define AMBIENT_VISIBILITY 1
#define METAL_MEANS 1
#define METAL_YARNS 1
#define YARN_RELIEF 1
#define SHADING_THREE 1
#define SHADING_PRINCIPLED 1
#define SHADING_FABRIC 1
#define ALL_TERMS 1
#define CHOSEN(slot, number) s.terms.slot
#define RELEASE(holder, slot, number) holder.three.slot
