// `metering` of the shot: server and browser expose by what each of them has drawn.
import { makeCase } from './make_case.mjs';
import { LIGHTS } from './shot.mjs';

const lens = { aperture: 4, shutter: 1 / 30, iso: 100 };

export const CASES = [
  makeCase('metered-dark', 'sweep', 'lamps', { camera: 'front', metering: { most: 3 } }),
  makeCase(
    'metered-bright',
    'stage',
    'gradient',
    { lights: [LIGHTS.directional], exposure: 0.7, background: 'environment', metering: { percentile: 0.7 } },
    true,
  ),
  makeCase('metered-lens', 'sweep', 'lamps', { environmentSettings: { intensity: 400 }, lens, metering: { least: 0.01, most: 100 } }),
  makeCase('metered-cutouts', 'alpha-mask', 'gradient', { lights: [LIGHTS.directional], metering: { percentile: 0.9, level: 0.5, least: 0.01 } }),
  makeCase(
    'metered-fabric',
    'cloth',
    'gradient',
    { lights: [LIGHTS.directional], shading: 'fabric', metering: { level: 0.4, least: 0.01 }, size: { width: 300, height: 180 } },
    true,
  ),
  // The small picture has 128 x 18 texels: narrower than 256 x 35.
  makeCase('metered-strip', 'sweep', 'lamps', { metering: { percentile: 0.5, level: 0.45, least: 0.1, most: 3 }, size: { width: 256, height: 35 } }),
];
