import { stat } from 'node:fs/promises';
import { documentOf, readDocument } from '../view/model_files.mjs';

/**
 * Names of a model's material variants, from its JSON alone, so that names of pictures are known before any is drawn.
 * @param {string | Uint8Array} source path or bytes
 * @param {number} maxBytes of the file
 * @returns {Promise<string[]>} without doubles; empty too for what is no model: drawing it tells what it is
 */
export async function variantNames(source, maxBytes) {
  try {
    const { extensions } = await documentFrom(source, maxBytes);
    const names = extensions.KHR_materials_variants.variants.map(({ name }) => name);
    return [...new Set(names.filter((name) => typeof name === 'string' && name !== ''))];
  } catch {
    return [];
  }
}

async function documentFrom(source, maxBytes) {
  if (typeof source !== 'string') return documentOf(source);
  const found = await stat(source);
  if (!found.isFile() || found.size > maxBytes) throw new Error('no model file of a size that is read');
  return readDocument(source);
}
