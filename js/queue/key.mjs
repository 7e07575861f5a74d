import { digestOf } from '../api/digest.mjs';
import { keyOfParts } from '../api/picture_key.mjs';
import { digestWithVisibility, visibilityOption } from '../api/visibility.mjs';
import { bytesOf } from '../api/source.mjs';
import { versions } from '../api/versions.mjs';
import { shotIdentity } from '../shot/identity.mjs';

/**
 * The key of a picture before it is drawn: that of `info.key`, found without opening the model; of pixels that are encoded afterwards with that format.
 * @param {import('./job_queue.mjs').Task} task
 * @returns {Promise<string | undefined>} undefined where it takes the files that the model names
 * @throws {import('../error/index.mjs').TelarError} E_SHOT
 */
export async function keyOf({ kind, asked, files }) {
  if (kind !== 'thumbnail' || Object.keys(files).some((name) => name.startsWith('part '))) return undefined;
  const identity = shotIdentity(asked.shot ?? {});
  const map = bytesOf(identity.environment.map);
  const [model, environment] = await Promise.all([digestOf(files.model), map ? digestOf(map) : identity.environment.map]);
  const key = keyOfParts({
    version: versions.telar,
    model: digestWithVisibility(model, visibilityOption(asked.ambientVisibility)),
    environment,
    shot: identity,
  });
  return asked.encode ? `${key}-${asked.encode}` : key;
}
