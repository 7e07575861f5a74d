#if AMBIENT_VISIBILITY
vVisibility = visibilityInView(_telar_visibility);
#if AMBIENT_VISIBILITY_BACK
vVisibilityBack = visibilityInView(_telar_visibility_back);
#endif
#endif
