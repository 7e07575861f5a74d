/**
 * Factor on radiance (nit) that a lens with shutter and ISO gives, so that a surface of 1.2 * 2^EV100 nit becomes 1:
 * EV100 = log2(N^2 / t * 100 / S), exposure = 1 / (1.2 * 2^EV100).
 * src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering", section 5.1.2 (saturation-based
 * sensitivity, lens and vignetting q = 0.65)
 * @param {{aperture: number, shutter: number | null, iso: number | null} | null} lens resolved: f-number, seconds
 * @returns {number} 1 where there is no lens, or one without shutter and ISO
 */
export function lensExposure(lens) {
  if (!lens || lens.shutter === null || lens.iso === null) return 1;
  return (lens.shutter * lens.iso) / (120 * lens.aperture * lens.aperture);
}
