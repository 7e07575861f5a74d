import path from 'node:path';
import { ASSET_DIRECTORY } from '../api/native.mjs';
import { ENVIRONMENTS, isNamedEnvironment } from '../shot/table/environments.mjs';

const formatOf = (file) => path.extname(file).slice(1).toLowerCase();
const mapOf = (environment) => (typeof environment === 'string' ? environment : environment?.map);
const withMap = (environment, map) => (typeof environment === 'object' ? { ...environment, map } : map);

/**
 * The environments that a page may draw under: the bundled one, none, and the one of the shot that the view was opened
 * with. The page knows that one by its file's name alone: no path leaves the machine's user.
 */
export class Environments {
  #own;

  /** @param {object} shot as given; a path in it is relative to the current folder */
  constructor(shot) {
    const map = mapOf(shot.environment);
    if (typeof map === 'string' && !isNamedEnvironment(map)) this.#own = { name: path.basename(map), file: path.resolve(map) };
  }

  /** @returns {{map: string, format: string | null}[]} what the page may put into shot.environment; format null: no file */
  list() {
    const named = Object.entries(ENVIRONMENTS).map(([map, file]) => ({ map, format: file && formatOf(file) }));
    return [...(this.#own ? [{ map: this.#own.name, format: formatOf(this.#own.file) }] : []), ...named];
  }

  /** @returns {string | undefined} path of the file behind a name of list() */
  fileOf(map) {
    if (isNamedEnvironment(map)) return ENVIRONMENTS[map] ? path.join(ASSET_DIRECTORY, ENVIRONMENTS[map]) : undefined;
    return map === this.#own?.name ? this.#own.file : undefined;
  }

  /** A shot of the command line, or one that was drawn, as the page gets it: of environments, the own file alone is no name yet. */
  forPage(shot) {
    const map = mapOf(shot.environment);
    if (map === undefined || isNamedEnvironment(map) || !this.#own) return shot;
    return { ...shot, environment: withMap(shot.environment, this.#own.name) };
  }

  /**
   * A shot of the page as the renderer takes it: only environments of list() become paths, any other is left to be
   * refused.
   * @returns {object | undefined} undefined where the shot names a file that was not offered
   */
  forRenderer(shot) {
    const map = mapOf(shot.environment);
    if (map === undefined || isNamedEnvironment(map)) return shot;
    return map === this.#own?.name ? { ...shot, environment: withMap(shot.environment, this.#own.file) } : undefined;
  }
}
