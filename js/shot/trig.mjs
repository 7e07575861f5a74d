/**
 * Sine and cosine of an angle in degrees from additions and multiplications alone: Math.sin and Math.cos may differ in the
 * last bit from engine to engine, and a shot must resolve to the same bits in every browser and on the server.
 * Multiples of 90 are exact. Error below 1.2e-16 (Taylor terms up to x^17 for |x| <= pi/4).
 * @param {number} degrees
 * @returns {{sin: number, cos: number}}
 */
export function sinCosDegrees(degrees) {
  const turn = degrees % 360;
  const quarter = Math.round(turn / 90);
  const x = (turn - 90 * quarter) * (Math.PI / 180);
  const x2 = x * x;
  let sin = 0;
  let cos = 0;
  for (let n = 16; n >= 0; n -= 2) {
    sin = 1 - (x2 * sin) / ((n + 2) * (n + 3));
    cos = 1 - (x2 * cos) / ((n + 1) * (n + 2));
  }
  sin *= x;
  switch (((quarter % 4) + 4) % 4) {
    case 1:
      return { sin: cos, cos: 0 - sin };
    case 2:
      return { sin: 0 - sin, cos: 0 - cos };
    case 3:
      return { sin: 0 - cos, cos: sin };
    default:
      return { sin, cos };
  }
}

/** Tangent of an angle in degrees, (-90, 90). */
export function tanDegrees(degrees) {
  const { sin, cos } = sinCosDegrees(degrees);
  return sin / cos;
}

/**
 * Angle in radians, [0, PI / 2), of a slope >= 0. Each half-angle step halves the angle, after three of which the series
 * converges by a factor of 25 and more a term.
 */
export function arcTangent(slope) {
  let x = slope;
  for (let i = 0; i < 3; ++i) x /= 1 + Math.sqrt(1 + x * x);
  let sum = 0;
  for (let n = 23; n >= 1; n -= 2) sum = 1 / n - x * x * sum;
  return 8 * x * sum;
}
