// A place of a polished relief over which the normal turns evenly: how much of it mirrors. Shared text: see README.md.

// Width of the lobe that stands for a turn of the normal, in parts of that turn.
const float FACET_TURN = 0.5;

// GGX distribution of the normals of a place at a direction, [1/sr]. Where the normal turns, the lobe is as wide as the turn and
// falls off quickly beyond it. Farther out, the value is that of the narrow lobe of a flat place.
// alpha2  square of the width, (0, 1]
// slope  of the normal in the middle, off the direction      across, down  by how much it turns from one side of the place to the other
// src: Yan et al. 2016, "Position-Normal Distributions for Efficient Rendering of Specular Microstructure", for lobes that are as
//      wide as the normal turns; Olano & Baker 2010, "LEAN Mapping", for moments of slopes
float facetCellDistribution(float alpha2, vec2 slope, vec2 across, vec2 down) {
  across *= FACET_TURN;
  down *= FACET_TURN;
  float xx = across.x * across.x + down.x * down.x;
  float yy = across.y * across.y + down.y * down.y;
  float xy = across.x * across.y + down.x * down.y;
  float wide2 = alpha2 + xx + yy;
  xx += alpha2;
  yy += alpha2;
  float perSquare = 1.0 / max(xx * yy - xy * xy, alpha2 * alpha2);  // of the lobe's area
  float apart2 = max(yy * slope.x * slope.x - 2.0 * xy * slope.x * slope.y + xx * slope.y * slope.y, 0.0) * perSquare;
  float slope2 = dot(slope, slope);
  float narrow = alpha2 * pow2((1.0 + slope2) / (wide2 + slope2));
  float wide = (1.0 - alpha2 / wide2) * sqrt(perSquare) / pow4(1.0 + apart2 / 3.0);
  return RECIPROCAL_PI * (narrow + wide);
}
