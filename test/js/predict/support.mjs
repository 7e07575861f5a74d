import { FAMILIES } from '../../../js/predict/settings.mjs';

export const MACHINE = { raster: 50, tracer: 200 };

export const featuresWith = (more = {}) => ({
  shading: 'fabric',
  surface: 'relief',
  environment: 'studio',
  shadows: false,
  triangles: 10_000,
  pixels: 256 * 256,
  covered: 50_000,
  traceable: true,
  ...more,
});

/** Errors of a family's cheapest setting, and what its times are of the draft's. */
const PLANTED = {
  prefiltered: { flip: 0.3, times: 1 },
  denoised: { flip: 0.1, times: 6 },
  tracer: { flip: 0.1, times: 12 },
};

/** Rows by a law: each setting of a family errs by 0.6 of the one before and takes 1.8 times as long; relief errs twice as much. */
export function plantedRows({ scenes = 12 } = {}) {
  const all = Array.from({ length: scenes }, (_, i) =>
    ['relief', 'smooth'].map((surface) => featuresWith({ surface, triangles: 1000 + 2500 * ((i * 5) % 12), covered: 5_000 + 5_500 * ((i * 7) % 11) })),
  ).flat();
  return all.flatMap((features, scene) =>
    Object.entries(FAMILIES).flatMap(([family, settings]) =>
      Object.keys(settings).map((setting, i) => ({
        model: `model ${scene}`,
        light: 'studio',
        shading: 'fabric',
        size: 256,
        setting,
        family,
        flip: PLANTED[family].flip * 0.6 ** i * (features.surface === 'relief' ? 1 : 0.5) * (0.8 + 0.02 * (scene % 10)),
        cpuMs: PLANTED[family].times * 1.8 ** i * (5 + 0.0005 * features.triangles + 0.0003 * features.covered) * (scene % 2 ? 1.03 : 0.97),
        features,
      })),
    ),
  );
}
