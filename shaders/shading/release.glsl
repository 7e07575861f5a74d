// How text takes the term that a release of three.js has in a slot (js/docs/families.md). In GLSL the number is known to the
// preprocessor, and terms that are not chosen are not in the program. In C++ the choice travels in `holder`, a SurfaceInfo or
// MaterialInputs.
#if !ALL_TERMS
#define RELEASE(holder, slot, number) number
#endif
