import { digestOf } from '../api/digest.mjs';
import { STRICT } from '../api/options.mjs';
import { keyOfParts } from '../api/picture_key.mjs';
import { digestWithVisibility, visibilityOption } from '../api/visibility.mjs';
import { bytesOf } from '../api/source.mjs';
import { versions } from '../api/versions.mjs';
import { shotIdentity } from '../shot/identity.mjs';

/**
 * The key of what is answered: that of the picture, with the format and the quality that its pixels are encoded in afterwards, and with what leaves a model
 * without a picture, where that is not the default.
 * @param {string} key - info.key
 * @param {{encode?: string, shot?: object, failOn?: string}} asked
 */
export function answerKey(key, { encode, shot, failOn }) {
  const encoded = encode && `${encode}${shot.output.quality ?? ''}`;
  return [key, encoded, failOn !== STRICT.failOn && failOn].filter(Boolean).join('-');
}

/**
 * The key of an answer before it is drawn: that of `info.key`, found without opening the model, as answerKey() has it.
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
  return answerKey(key, asked);
}
