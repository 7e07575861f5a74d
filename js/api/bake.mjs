import { readFile } from 'node:fs/promises';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { GltfFile } from './gltf_file.mjs';
import { loadModel, Model } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { bakeOptions } from './options.mjs';
import { bytesOf, readSource } from './source.mjs';
import { Work } from './work.mjs';

/** Attributes of both sides: js/docs/visibility.md. */
const NAMES = { front: '_TELAR_VISIBILITY', back: '_TELAR_VISIBILITY_BACK' };

/** Documented in js/api/bake.d.ts. */
export async function bake(source, options = {}) {
  return bakeOn(loadNative(), source, options);
}

/** @internal */
export async function bakeOn(native, source, options = {}) {
  const { limits, signal, timeoutMs, cacheDirectory, cacheBytes, ...loading } = bakeOptions(options, Object.keys(native.limits));
  const input = readSource(native, source, limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES);
  const bytes = typeof input === 'string' ? undefined : Buffer.from(bytesOf(source));
  const work = new Work(native, signal, timeoutMs);
  work.allowLong();
  const model = await loadModel(native, input, limits, { ...loading, work, cache: { directory: cacheDirectory, bytes: cacheBytes } });
  const baked = await nativeCall(native, work, (token) => native.visibilityOf(Model.sceneOf(model), token));
  const file = new GltfFile(bytes ?? (await fileBytes(input)));
  for (const { mesh, primitive, vertices, ...sides } of baked) {
    const { attributes } = primitiveOf(file.document, mesh, primitive, vertices);
    for (const [side, name] of Object.entries(NAMES)) {
      const earlier = attributes[name];
      delete attributes[name];
      if (sides[side]) attributes[name] = file.addShorts(sides[side], earlier);
    }
  }
  const vertices = baked.reduce((sum, item) => sum + item.vertices, 0);
  const { format, parts } = file;
  return {
    data: file.bytes(),
    info: { format, parts, primitives: baked.length, vertices, rays: loading.ambientVisibility, warnings: model.facts.warnings ?? [] },
  };
}

/** Of a file that was loaded. */
async function fileBytes(path) {
  try {
    return await readFile(path);
  } catch (cause) {
    throw new TelarError('E_FILE', `${shown(path)} cannot be read (${cause.code})`, { cause });
  }
}

/** @throws {TelarError} E_FILE where the file is no longer the one that was loaded */
function primitiveOf({ meshes = [], accessors = [] }, mesh, primitive, vertices) {
  const found = meshes[mesh]?.primitives?.[primitive];
  if (found?.attributes && accessors[found.attributes.POSITION]?.count === vertices) return found;
  throw new TelarError('E_FILE', 'the model has changed while it was read: try again');
}
