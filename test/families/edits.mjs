import { readFileSync } from 'node:fs';
import path from 'node:path';
import { folderOf } from './releases.mjs';

/**
 * A change of a release's source, in memory.
 * @typedef {object} Edit
 * @property {string} file - In the release's folder, such as src/extras/PMREMGenerator.js.
 * @property {string} [of] - Takes the file of this release in its place.
 * @property {[string | Span, (string | Span) | (string | Span)[]][]} [replace] - Texts of this file, and what stands in their place
 *   wherever they are; each must be there.
 *
 * The text from `from` up to `to`, in this file, or in that of another release.
 * @typedef {{from: string, to: string, of?: string}} Span
 */

/** Where the GLSL of a chunk lies. */
export const chunk = (name) => `src/renderers/shaders/ShaderChunk/${name}.glsl.js`;

function spanOf(text, { from, to }, where) {
  const start = text.indexOf(from);
  const end = text.indexOf(to, start);
  if (start < 0 || end < 0) throw new Error(`${where}: there is nothing from "${from}" to "${to}"`);
  return text.slice(start, end);
}

/**
 * Texts of the files that edits change.
 * @param {string} version - Release that is edited.
 * @param {Edit[]} edits - In their order, but whole files first.
 * @param {(version: string) => string} [placeOf] - Folder of a release.
 * @returns {Map<string, string>} As of Browser.start().
 * @throws {Error} When a text to replace is not there.
 */
export function editedFiles(version, edits, placeOf = folderOf) {
  const read = (release, file) => readFileSync(path.join(placeOf(release), file), 'utf8');
  const files = new Map();
  for (const { file, of } of edits) if (of) files.set(file, read(of, file));
  for (const { file, replace = [] } of edits) {
    const where = `three.js ${version}, ${file}`;
    let text = files.get(file) ?? read(version, file);
    const textOf = (part) => {
      if (typeof part === 'string') return part;
      return spanOf(part.of ? read(part.of, file) : text, part, part.of ? `three.js ${part.of}, ${file}` : where);
    };
    for (const [before, after] of replace) {
      const old = textOf(before);
      if (!text.includes(old)) throw new Error(`${where}: there is no "${old}"`);
      text = text.split(old).join([after].flat().map(textOf).join(''));
    }
    files.set(file, text);
  }
  return files;
}
