import { luminance } from '../shot/luminance.mjs';

/** Lobes and albedos of a target's material under two shadings, for the plots. */

/** Angles between normal and viewer of the lobe plots, degrees. */
const VIEW_ANGLES = [20, 65];
/** Angles of the albedo curves, degrees. */
export const ALBEDO_ANGLES = [0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80, 84, 87];
/** Steps of the light over the plane of incidence, degrees. */
const LIGHT_STEP = 1.5;

const RADIANS = Math.PI / 180;

/** Light angles from the viewer's side (90) over the normal (0) to the other (-90), degrees. */
export const LIGHT_ANGLES = Array.from({ length: 180 / LIGHT_STEP - 1 }, (_, i) => 90 - (i + 1) * LIGHT_STEP);

const luminances = (lobes) => Object.fromEntries(Object.entries(lobes).map(([lobe, rgb]) => [lobe, luminance(rgb)]));

/** The material that a target shows, as evaluateShading takes it: that named after the variant, else the first, else glTF's default. */
function materialOf(model, variant) {
  const { materials } = model.facts;
  if (materials.length === 0) return { material: {} };
  return {
    model,
    material: Math.max(
      0,
      materials.findIndex(({ name }) => name === variant),
    ),
  };
}

/**
 * @typedef {Record<'diffuse' | 'specular' | 'sheen' | 'coat' | 'total', number>} Lobes - Luminances.
 * @typedef {object} Curves
 * @property {string} target
 * @property {Array<{viewAngle: number, from: Lobes[], to: Lobes[]}>} lobes - For each of LIGHT_ANGLES the BRDF times the cosine.
 * @property {{from: Lobes[], to: Lobes[]}} albedo - For each of ALBEDO_ANGLES.
 *
 * @param {object} api with evaluateShading
 * @param {object} model - The target, loaded.
 * @param {import('./targets.mjs').Target} target
 * @param {{from: object, to: object}} shadings
 * @param {{signal?: AbortSignal}} [options]
 * @returns {Promise<Curves>}
 */
export async function curvesOf(api, model, target, shadings, { signal } = {}) {
  const shown = materialOf(model, target.shot.variant);
  const ask = (shading, degrees, more) => api.evaluateShading({ ...shown, shading, viewAngle: degrees * RADIANS, signal, ...more });
  const directions = LIGHT_ANGLES.map((degrees) => [Math.sin(degrees * RADIANS), 0, Math.cos(degrees * RADIANS)]);
  const both = async (of) => ({ from: await of(shadings.from), to: await of(shadings.to) });
  const lobes = [];
  for (const viewAngle of VIEW_ANGLES) {
    lobes.push({ viewAngle, ...(await both(async (shading) => (await ask(shading, viewAngle, { directions })).radiance.map(luminances))) });
  }
  const albedo = await both(async (shading) => {
    const curve = [];
    for (const degrees of ALBEDO_ANGLES) curve.push(luminances((await ask(shading, degrees, { albedo: true })).albedo));
    return curve;
  });
  return { target: target.name, lobes, albedo };
}
