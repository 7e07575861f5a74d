// The shading "three": its terms are those that others take too.
#include "shading/three.glsl"
