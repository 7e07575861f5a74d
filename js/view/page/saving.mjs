import { embedShot } from '../../compare/embedded_shot.mjs';
import { png } from './remote.mjs';

/** A shot as it is saved with a picture: what was drawn, whatever file it was going to. */
const savedShot = ({ output: { ppi }, ...shot }) => ({ ...shot, output: { ppi } });

/**
 * Saves pixels as a PNG with their shot inside, so that `telar compare` knows what was drawn.
 * @param {import('../../compare/image.mjs').Image} image
 * @param {object} resolved the shot that it shows
 * @param {string} name of the file
 */
export async function savePicture(image, resolved, name) {
  const file = embedShot(await png(image), savedShot(resolved));
  const url = URL.createObjectURL(new Blob([file], { type: 'image/png' }));
  const link = Object.assign(document.createElement('a'), { href: url, download: name });
  link.click();
  // After the browser has taken the data over.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
