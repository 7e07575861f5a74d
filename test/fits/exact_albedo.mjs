// Directional albedo of a GGX lobe with height-correlated Smith masking, by quadrature over its visible normals.

/**
 * @param {number} alpha (0, 1]
 * @param {number} cosine (0, 1] of the viewer
 * @param {number} strata a side of the grid of directions
 * @returns {{missing: number, grazing: number}} of light 1: what one bounce does not reflect for f0 = f90 = 1, and the part of
 *   what it does that belongs to f90 with Schlick's fifth power. Error some 1e-4 with 72 strata.
 * src: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"; Heitz 2014, eq. 99
 */
function exactAlbedo(alpha, cosine, strata) {
  const sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
  const length = Math.hypot(alpha * sine, cosine);
  const stretched = { x: (alpha * sine) / length, z: cosine / length };
  const lambda = (c) => (Math.sqrt(1 + (alpha * alpha * (1 - c * c)) / (c * c)) - 1) / 2;
  const lambdaV = lambda(cosine);
  let reflected = 0;
  let grazing = 0;
  for (let i = 0; i < strata; i += 1) {
    const phi = (2 * Math.PI * (i + 0.5)) / strata;
    for (let j = 0; j < strata; j += 1) {
      const z = (1 - (j + 0.5) / strata) * (1 + stretched.z) - stretched.z;
      const r = Math.sqrt(Math.max(0, 1 - z * z));
      const h = [alpha * (r * Math.cos(phi) + stretched.x), alpha * r * Math.sin(phi), Math.max(z + stretched.z, 1e-12)];
      const norm = Math.hypot(...h);
      const VoH = Math.max((h[0] * sine + h[2] * cosine) / norm, 0);
      const NoL = (2 * VoH * h[2]) / norm - cosine;
      if (NoL <= 0) continue;
      const kept = (1 + lambdaV) / (1 + lambdaV + lambda(NoL));
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
  return widths.flatMap((roughness) => Array.from({ length: cosines }, (_, i) => {
    const cosine = Math.max((i / (cosines - 1)) ** 2, 1e-6);
    return { roughness, cosine, ...exactAlbedo(roughness ** 2, cosine, strata) };
  }));
}
