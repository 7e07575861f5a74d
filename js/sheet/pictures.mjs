import { createHash } from 'node:crypto';
import { TelarError } from '../error/index.mjs';
import { INCH, basisOf, trueView } from './scale.mjs';

/** The pictures of one sheet: asked for while pages are laid out, drawn together from one load of the model. */

/** JPEG at which no ringing shows at the edge of white, on paper. */
const QUALITY = 93;

/** White around a garment, millimetres of paper: outlines of round models miss a little of them. */
const MARGIN = 1.5;

/** Resolution of a mask of the garment: a third of a millimetre. */
const MASK_PPI = 76.2;

const WHITE = '#ffffff';

/** Widths of the lines of flats on paper, millimetres: the series of ISO 128-2:2020 one step beneath that of Model.flat, for A4. */
const WEIGHTS = { silhouette: 0.5, contour: 0.35, seam: 0.25, stitch: 0.18, crease: 0.18 };

/** Metres from the middle of a model to a camera that sees all of it. */
const depthOf = ({ min, max }) => 2 * Math.hypot(...max.map((high, i) => high - min[i])) + 0.01;

const nameOf = (asked) => createHash('sha256').update(JSON.stringify(asked)).digest('hex').slice(0, 16);

export class Pictures {
  #renderer;
  #model;
  #options;
  #asked = new Map();
  #flats = new Map();
  #squares = new Map();

  /**
   * @param {object} renderer
   * @param {object} model loaded
   * @param {{ppi: number, shot: object, flats: object, call: {signal?: AbortSignal, timeoutMs?: number | null}}} options shot: what pictures
   *   share: light, shading, quality; flats: of the spec
   */
  constructor(renderer, model, options) {
    this.#renderer = renderer;
    this.#model = model;
    this.#options = options;
  }

  /**
   * A picture in true scale, drawn later.
   * @param {import('./scale.mjs').Extent} extent
   * @param {{ratio: number, variant: string, style?: 'render' | 'flat', margin?: number}} how
   * @returns {{file: string, width: number, height: number, view: import('./scale.mjs').TrueView}} millimetres of paper
   */
  ask(extent, { ratio, variant, style = 'render', margin = MARGIN }) {
    const view = trueView(extent, { ratio, ppi: this.#options.ppi, margin, depth: depthOf(this.#model.facts.bounds) });
    const seen = { size: view.size, camera: view.camera, variant };
    const file = style === 'flat' ? this.#askFlat(seen, ratio) : this.#askRender(seen);
    return { file, ...view.paper, view };
  }

  #renderOf(seen) {
    return { ...this.#options.shot, ...seen, background: WHITE, output: { format: 'jpeg', quality: QUALITY, ppi: Math.round(this.#options.ppi) } };
  }

  #askRender(seen) {
    const shot = this.#renderOf(seen);
    const file = `${nameOf(shot)}.jpg`;
    this.#asked.set(file, shot);
    return file;
  }

  #askFlat(shot, scale) {
    const { foldLength, ...flats } = this.#options.flats;
    const options = { ...flats, foldLength: Math.min(1, foldLength / shot.camera.height), scale, weights: WEIGHTS };
    const file = `${nameOf([shot, options])}.svg`;
    this.#flats.set(file, { shot, options });
    return file;
  }

  /**
   * A picture of a square of a material, drawn later.
   * @param {object} square model of Model.swatch
   * @param {{size: number, ratio: number}} how size: metres
   * @returns {{file: string, width: number, height: number}} millimetres of paper
   */
  askSquare(square, { size, ratio }) {
    const extent = { basis: basisOf({ view: 'front' }), centre: [0, 0, 0], width: size, height: size };
    const view = trueView(extent, { ratio, ppi: this.#options.ppi, depth: depthOf(square.facts.bounds) });
    const shot = this.#renderOf({ size: view.size, camera: view.camera });
    const file = `${nameOf([shot, this.#squares.size])}.jpg`;
    this.#squares.set(file, { square, shot });
    return { file, ...view.paper };
  }

  /**
   * Where the garment is in a picture, drawn at once.
   * @returns {Promise<{covers: (x: number, y: number) => boolean}>} millimetres of paper in the picture
   */
  async mask(extent, { ratio, variant, margin = MARGIN }) {
    const view = trueView(extent, { ratio, ppi: MASK_PPI, margin, depth: depthOf(this.#model.facts.bounds) });
    const shot = {
      ...this.#options.shot,
      quality: 'draft',
      size: view.size,
      camera: view.camera,
      variant,
      background: 'transparent',
      output: { format: 'raw' },
    };
    const { data, info } = await this.#renderer.render(this.#model, shot, this.#options.call);
    const perMillimetre = MASK_PPI / INCH;
    const covers = (x, y) => {
      const [px, py] = [Math.floor(x * perMillimetre), Math.floor(y * perMillimetre)];
      return px >= 0 && py >= 0 && px < info.width && py < info.height && data[4 * (py * info.width + px) + 3] > 0;
    };
    return { covers };
  }

  /**
   * Draws all that was asked for.
   * @param {(part: number) => void} [onProgress]
   * @returns {Promise<Map<string, {data: Buffer, info: object}>>} by file
   */
  async draw(onProgress) {
    const files = [...this.#asked.keys()];
    const images = await this.#renderer.renderAll(this.#model, [...this.#asked.values()], { ...this.#options.call, onProgress });
    const drawn = new Map(files.map((file, i) => [file, images[i]]));
    for (const [file, { square, shot }] of this.#squares) drawn.set(file, await this.#renderer.render(square, shot, this.#options.call));
    for (const [file, flat] of this.#flats) drawn.set(file, { data: Buffer.from(await this.#flat(flat)) });
    return drawn;
  }

  async #flat({ shot, options }) {
    try {
      return (await this.#model.flat(shot, { ...options, ...this.#options.call })).svg;
    } catch (thrown) {
      // Of what the options name, parts alone may not be there.
      if (thrown.code !== 'E_MEASURE') throw thrown;
      throw new TelarError('E_SPEC', `spec.flats.stitched: ${thrown.message}`, { pointer: `/flats${thrown.pointer}`, cause: thrown });
    }
  }
}
