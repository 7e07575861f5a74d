import { TelarError } from '../error/index.mjs';

/** What the pictures of a sheet share of a shot. What a garment is, and where it is seen from, is the spec's: flats, lengths and colours go by it too. */

export const SHARED = Object.freeze(['environment', 'lights', 'modelLights', 'shading', 'toneMapping', 'exposure', 'metering', 'quality']);

/** What stands in place of the other keys. */
const INSTEAD = Object.freeze({
  look: 'give the environment and the lights of the look by themselves',
  size: 'the size of a picture follows from its scale and `ppi` of the spec',
  camera: 'give `view`, or `azimuth` and `elevation`, to the views of the spec',
  lens: 'use `exposure`: pictures in true scale have no lens',
  background: 'the background is the paper',
  ground: 'a garment stands on white paper, without a shadow',
  variant: 'give `variant` to the views and the colourways of the spec',
  materials: 'write the cloth into the model: flats, lengths and colours are taken of the file',
  pose: 'write the pose into the model: flats, lengths and colours are taken of the file as it stands',
  ghost: 'give `ghost` to the views of the spec',
  layers: 'a sheet has no layers',
  style: 'give `style` to the views of the spec',
  flat: 'use `flats` of the spec',
  scale: 'give `scale` to the views of the spec',
  output: 'use `ppi` of the spec, and the format of the sheet',
});

/**
 * Refuses what a sheet would heed in some of its pictures alone. Unknown keys and wrong values are the shot's to refuse.
 * @param {object} shot as given
 * @param {string} [name] of the shot in messages
 * @throws {TelarError} E_OPTION
 */
export function checkShared(shot, name = 'options.shot') {
  for (const [key, value] of Object.entries(shot)) {
    if (value === undefined || !Object.hasOwn(INSTEAD, key)) continue;
    throw new TelarError('E_OPTION', `${name}.${key}: a sheet does not take it; ${INSTEAD[key]}. Of a shot it takes ${SHARED.join(', ')}`, {
      pointer: `/shot/${key}`,
    });
  }
}
