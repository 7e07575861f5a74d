// The features that shaders/shading asks for.
#define DIFFUSE_ROUGHNESS 1
#define ANISOTROPY 1
#define IRIDESCENCE 1
#define SHEEN 1
#define CLEARCOAT 1
