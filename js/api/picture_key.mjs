import path from 'node:path';
import { isNamedEnvironment } from '../shot/table/environments.mjs';
import { canonical } from './digest.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { keyOptions } from './options.mjs';
import { withParts } from './parts.mjs';
import { sha256 } from './sha256.mjs';
import { readShot, readSource } from './source.mjs';
import { digestWithVisibility } from './visibility.mjs';
import { versions } from './versions.mjs';

/** The key of a picture: SHA-256 of all that it is made of. Equal keys mean the same picture by the same GL. */

/** The module has the schema of the shot, which costs load time. */
const identityModule = () => import('../shot/identity.mjs');

/**
 * @param {object} parts
 * @param {string} parts.version of telar
 * @param {string} parts.model SHA-256 of the model and its parts
 * @param {string} parts.environment its name, which telar's version tells the bytes of, or SHA-256 of the file
 * @param {object} parts.shot what shotIdentity gives
 * @param {object} [native] the addon; node:crypto hashes without it
 * @returns {string} 64 hex digits
 */
export function keyOfParts({ version, model, environment, shot }, native) {
  const { map, ...settings } = shot.environment;
  return sha256(canonical({ version, model, environment, shot: { ...shot, environment: settings } }), native);
}

/** SHA-256 of a file or of bytes, on a loader thread. One that cannot be read counts as absent: drawing tells, where it matters. */
async function digestOf(native, source, limits, signal) {
  try {
    return await nativeCall(native, { signal }, (token) => native.hashFile(source, limits, token));
  } catch {
    signal?.throwIfAborted();
    return 'absent';
  }
}

/** The bytes of an environment are the caller's, the file is relative to the current folder. */
const environmentOf = ({ map }, bytes) => bytes ?? path.resolve(map);

/** Documented in js/api/picture_key.d.ts. */
export async function pictureKey(source, shot = {}, options = {}) {
  const native = loadNative();
  const { limits, resolve, ambientVisibility, signal } = keyOptions(options, Object.keys(native.limits));
  const maxBytes = limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
  const input = readSource(native, source, maxBytes);
  const request = readShot(native, shot, maxBytes);
  const identity = await identityOf(request.shot);
  const { map } = identity.environment;
  const [model, environment] = await Promise.all([
    withParts(native, { resolve, signal }, (parts) =>
      nativeCall(native, { signal }, (token) => native.hashModel(input, limits, { tolerant: true, parts }, token)),
    ),
    isNamedEnvironment(map) ? map : digestOf(native, environmentOf(identity.environment, request.environment), limits, signal),
  ]);
  return keyOfParts({ version: versions.telar, model: digestWithVisibility(model, ambientVisibility), environment, shot: identity }, native);
}

/**
 * What keyOfDrawn() needs to know of a shot that is being drawn.
 * @param {object} shot not resolved
 */
export async function identityOf(shot) {
  const { shotIdentity } = await identityModule();
  return shotIdentity(shot);
}

/**
 * The key of a picture that was drawn. What loading and drawing have hashed is not hashed again.
 * @param {object} native
 * @param {object} parts
 * @param {string} parts.version of telar
 * @param {string} parts.model SHA-256 of the loaded model
 * @param {object} parts.identity of identityOf()
 * @param {object} [parts.environment] native bytes
 * @param {string} parts.drawn SHA-256 of the environment as it was drawn; empty where the renderer read none
 * @param {object} parts.limits
 * @param {number} [parts.ended] samples with which the caller had enough: another picture than the finished one
 * @returns {Promise<string>}
 */
export async function keyOfDrawn(native, { version, model, identity, environment, drawn, limits, ended }) {
  const { map } = identity.environment;
  const light = isNamedEnvironment(map) ? map : drawn || (await digestOf(native, environmentOf(identity.environment, environment), limits));
  return keyOfParts({ version, model, environment: light, shot: ended === undefined ? identity : { ...identity, ended } }, native);
}
