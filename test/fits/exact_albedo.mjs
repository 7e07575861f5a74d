// Directional albedo of a GGX lobe with height-correlated Smith masking, by quadrature over its visible normals.

/**
 * @param {number} alpha (0, 1]
 * @param {number} cosine (0, 1] of the viewer
 * @param {number} strata a side of the grid of directions
 * @param {number} [across] width across `alpha`, where the lobe has two
 * @param {number} [azimuth] of the viewer, from the axis of `alpha`, radians
 * @returns {{missing: number, grazing: number}} of light 1: what one bounce does not reflect for f0 = f90 = 1, and the part of
 *   what it does that belongs to f90 with Schlick's fifth power. Error some 1e-4 with 72 strata.
 * src: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"; Heitz 2014, eq. 99
 */
export function exactAlbedo(alpha, cosine, strata, across = alpha, azimuth = 0) {
  const sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
  const v = [sine * Math.cos(azimuth), sine * Math.sin(azimuth), cosine];
  const length = Math.hypot(alpha * v[0], across * v[1], cosine);
  const stretched = [(alpha * v[0]) / length, (across * v[1]) / length, cosine / length];
  const lambda = (x, y, z) => (Math.hypot(alpha * x, across * y, z) / z - 1) / 2;
  const lambdaV = lambda(...v);
  let reflected = 0;
  let grazing = 0;
  for (let i = 0; i < strata; i += 1) {
    const phi = (2 * Math.PI * (i + 0.5)) / strata;
    for (let j = 0; j < strata; j += 1) {
      const z = (1 - (j + 0.5) / strata) * (1 + stretched[2]) - stretched[2];
      const r = Math.sqrt(Math.max(0, 1 - z * z));
      const h = [alpha * (r * Math.cos(phi) + stretched[0]), across * (r * Math.sin(phi) + stretched[1]), Math.max(z + stretched[2], 1e-12)];
      const norm = Math.hypot(...h);
      const VoH = Math.max((h[0] * v[0] + h[1] * v[1] + h[2] * v[2]) / norm, 0);
      const l = h.map((c, k) => (2 * VoH * c) / norm - v[k]);
      if (l[2] <= 0) continue;
      const kept = (1 + lambdaV) / (1 + lambdaV + lambda(...l));
      reflected += kept;
      grazing += kept * (1 - VoH) ** 5;
    }
  }
  return { missing: 1 - reflected / strata ** 2, grazing: grazing / strata ** 2 };
}

/**
 * The same on a grid, dense where the curves bend: at low roughness and towards grazing.
 * @returns {{roughness: number, cosine: number, missing: number, grazing: number}[]}
 */
export function exactTable({ roughnesses = 31, cosines = 31, strata = 72 } = {}) {
  const widths = [0.045, 0.055, 0.07, 0.085, ...Array.from({ length: roughnesses }, (_, i) => 0.1 + (0.9 * i) / (roughnesses - 1))];
  return widths.flatMap((roughness) =>
    Array.from({ length: cosines }, (_, i) => {
      const cosine = Math.max((i / (cosines - 1)) ** 2, 1e-6);
      return { roughness, cosine, ...exactAlbedo(roughness ** 2, cosine, strata) };
    }),
  );
}
