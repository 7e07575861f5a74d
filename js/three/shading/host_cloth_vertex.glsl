#if AMBIENT_VISIBILITY
attribute vec4 _telar_visibility;
#if AMBIENT_VISIBILITY_BACK
attribute vec4 _telar_visibility_back;
#endif
#endif
#if AMBIENT_VISIBILITY
out vec4 vVisibility;
#if AMBIENT_VISIBILITY_BACK
out vec4 vVisibilityBack;
#endif
#endif
