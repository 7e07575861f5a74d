#if AMBIENT_VISIBILITY
attribute vec4 _telar_visibility;
#if AMBIENT_VISIBILITY_BACK
attribute vec4 _telar_visibility_back;
#endif
#endif
