import { wrongValue } from './complain.mjs';
import { length, subtract } from './frame.mjs';
import { inOrder } from './table/resolved.mjs';
import { lens as LENS } from './table/stage.mjs';

/** A photographic lens: how bright (lens_exposure.mjs), and what is sharp. */

/**
 * @param {object | null} lens parsed
 * @param {object} camera resolved
 * @returns {{aperture: number, shutter: number | null, iso: number | null, focusDistance: number | null} | null}
 */
export function resolveLens(lens, camera) {
  if (lens === null) return null;
  const { shutter = null, iso = null, focusDistance = null } = lens;
  if (shutter === null && iso !== null) throw wrongValue(['lens', 'shutter'], 'a number of seconds beside iso', lens.shutter);
  if (iso === null && shutter !== null) throw wrongValue(['lens', 'iso'], 'a sensitivity beside shutter', lens.iso);
  if (focusDistance !== null && camera.projection === 'orthographic') {
    throw wrongValue(['lens', 'focusDistance'], 'none with the orthographic projection, which has no lens to blur', focusDistance);
  }
  const distance = focusDistance === 'target' ? length(subtract(camera.target, camera.position)) : focusDistance;
  return inOrder(LENS, { ...lens, shutter, iso, focusDistance: distance });
}
