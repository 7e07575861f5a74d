import * as z from '../dist/zod.mjs';
import { wrongValue } from './complain.mjs';
import { HUGE, TINY, number, object } from './fields.mjs';
import { length, subtract } from './frame.mjs';

/** A photographic lens: how bright (lens_exposure.mjs), and what is sharp. */

const FOCUS = 'a distance in metres in [1e-30, 1e30] or "target"';

export const lensSchema = object('A photographic lens', {
  aperture: number('f-number: focal length over the width of the opening', { what: 'an f-number', min: 0.1, max: 1000 }),
  shutter: number('', { what: 'a number of seconds', above: 0, max: 86400 }).nullable().optional()
    .describe('Seconds that the shutter is open; with `iso` it exposes by EV100, a factor beside `exposure`; none = the lens does not change the exposure'),
  iso: number('', { what: 'a sensitivity', above: 0, max: 1e7 }).nullable().optional().describe('Sensitivity, ISO'),
  focusDistance: z.union([z.number({ error: FOCUS }).min(TINY, { error: FOCUS }).max(HUGE, { error: FOCUS }), z.literal('target')], { error: FOCUS })
    .nullable().optional()
    .describe('Distance in metres, along the view, of what is sharp, or "target": the camera\'s target; quality "reference" blurs the rest, the raster does not. None = all is sharp'),
}).nullable().default(null).describe('A photographic lens: exposure by EV100, and depth of field in quality "reference"; null = a pinhole');

/**
 * @param {object | null} lens parsed
 * @param {object} camera resolved
 * @returns {{aperture: number, shutter: number | null, iso: number | null, focusDistance: number | null} | null}
 */
export function resolveLens(lens, camera) {
  if (lens === null) return null;
  const { aperture, shutter = null, iso = null, focusDistance = null } = lens;
  if (shutter === null && iso !== null) throw wrongValue(['lens', 'shutter'], 'a number of seconds beside iso', lens.shutter);
  if (iso === null && shutter !== null) throw wrongValue(['lens', 'iso'], 'a sensitivity beside shutter', lens.iso);
  if (focusDistance !== null && camera.projection === 'orthographic') {
    throw wrongValue(['lens', 'focusDistance'], 'none with the orthographic projection, which has no lens to blur', focusDistance);
  }
  return { aperture, shutter, iso, focusDistance: focusDistance === 'target' ? length(subtract(camera.target, camera.position)) : focusDistance };
}
