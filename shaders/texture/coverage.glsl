// Holes of a texture.
uniform float cutoff;  // alpha from which on a cut-out texture is there; 0: of a blended one, alpha is the share that is there

// What is cut out has a colour too; it counts only where there is nothing else.
const float CUT_OUT_WEIGHT = 0.0009765625;

float shareOfTexel(float alpha) { return cutoff > 0.0 ? step(cutoff, alpha) : alpha; }
