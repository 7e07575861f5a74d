import { TelarError } from '../error/index.mjs';
import { pathText, pointerText } from '../shot/complain.mjs';
import { readColourList } from './colour_list.mjs';
import { LIGHTS, nearestColours } from './colour.mjs';
import { hexOf } from './pages/cells.mjs';
import { ABOUT } from './read.mjs';

/** Squares of the materials of a model, and their colours. */

/** Side of a square, metres. */
export const SIDE = 0.1;

/** Pixels of a side of the picture whose mean is taken: of what is finer, the mip levels hold the mean. */
const PIXELS = 256;

const CAMERA = { projection: 'orthographic', position: [0, 0, 1], target: [0, 0, 0], height: SIDE, near: 0.5, far: 1.5 };

/** @internal */
export const ALBEDO = Object.freeze({
  size: { width: PIXELS, height: PIXELS },
  camera: CAMERA,
  quality: 'draft',
  environment: 'none',
  background: 'transparent',
  layers: ['albedo', 'coverage'],
  output: { format: 'raw', layers: { format: 'raw' } },
});

/** Layers as they come: bytes of floats that may begin anywhere. */
export const floatsOf = (bytes) => new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));

/**
 * Mean of a picture by coverage.
 * @param {Float32Array} colours three floats a pixel, linear Rec.709
 * @param {Float32Array} coverage 0..1
 * @returns {number[]} linear Rec.709
 */
export function meanOf(colours, coverage) {
  const sums = [0, 0, 0];
  let whole = 0;
  for (const [i, part] of coverage.entries()) {
    whole += part;
    // What is no number, as texture coordinates that overflow make it, is drawn black.
    for (let c = 0; c < 3; ++c) sums[c] += part * (colours[3 * i + c] || 0);
  }
  return sums.map((sum) => (whole > 0 ? sum / whole : 0));
}

/** @throws {TelarError} E_SPEC where the file is not there or no list, or the fonts cannot show a name of it */
export async function colourListOf({ colourList }, { resolve, fonts }) {
  if (!colourList) return undefined;
  const bytes = await resolve?.(colourList.file);
  if (!bytes)
    throw new TelarError(ABOUT.code, `spec.colourList.file: there is no file ${JSON.stringify(colourList.file)}${resolve ? '' : '; give the option resolve'}`, {
      pointer: '/colourList/file',
    });
  return { light: colourList.light, colours: readColourList(bytes, fonts) };
}

export class Squares {
  #context;
  #made = new Map();

  /** @param {{model: object, renderer: object, call: object, list?: {light: string, colours: object[]}}} context list: of colourListOf */
  constructor(context) {
    this.#context = context;
  }

  /**
   * @param {{material?: number | string, node?: number | string, variant: string}} what
   * @param {(string | number)[]} path of what names it
   * @param {boolean} [draped]
   * @returns {Promise<object>} model
   * @throws {TelarError} E_SPEC where the model has no such part
   */
  async model({ material, node, variant }, path, draped = false) {
    const kind = material !== undefined ? 'material' : 'node';
    const key = JSON.stringify([kind, material ?? node, variant, draped]);
    if (this.#made.has(key)) return this.#made.get(key);
    const { model, call } = this.#context;
    try {
      const square = await model.swatch({ part: { [kind]: material ?? node }, variant, size: SIDE, draped, ...call });
      this.#made.set(key, square);
      return square;
    } catch (thrown) {
      if (thrown.code !== 'E_MEASURE') throw thrown;
      throw new TelarError(ABOUT.code, `${pathText(path, ABOUT)}: ${thrown.message}`, { pointer: pointerText([...path, kind]), cause: thrown });
    }
  }

  /**
   * The colour of the material itself, without light: the mean of its base colour.
   * @returns {Promise<{linear: number[], srgb: string, labD50: number[], labD65: number[], nearest: {name: string, difference: number}[]}>}
   */
  async colour(what, path) {
    const { list } = this.#context;
    const square = await this.model(what, path);
    const linear = square.facts.meanBaseColor ?? (await this.#drawnColour(square));
    return { linear, srgb: hexOf(linear), labD50: LIGHTS.D50(linear), labD65: LIGHTS.D65(linear), nearest: list ? nearestColours(linear, list) : [] };
  }

  /** The mean of what is seen of a square. */
  async #drawnColour(square) {
    const { renderer, call } = this.#context;
    const { layers } = await renderer.render(square, ALBEDO, call);
    const coverage = floatsOf(layers.coverage);
    // In the layer of the albedo, what is less than half there is not there, and so is the cloth at the edge of a hole.
    return coverage.every((part) => part === 1) ? meanOf(floatsOf(layers.albedo), coverage) : this.#sheerColour(square);
  }

  /** The same of what is sheer or has holes: by its alpha. */
  async #sheerColour(square) {
    const { renderer, call } = this.#context;
    const { layers, output, ...shot } = ALBEDO;
    const { data: color } = await renderer.renderQuantity(square, shot, 'baseColor', call);
    const { data: alpha } = await renderer.renderQuantity(square, shot, 'alpha', call);
    return meanOf(
      color.filter((_, i) => i % 4 < 3),
      alpha.filter((_, i) => i % 4 === 0),
    );
  }
}
