import { createHash } from 'node:crypto';
import { TelarError } from '../error/index.mjs';
import { ofView } from './shown.mjs';
import { GHOSTS_MAX } from '../shot/table/parts.mjs';
import { INCH, basisOf, trueView } from './scale.mjs';
import { middlePixel } from './seen_part.mjs';
import { floatsOf } from './squares.mjs';

/**
 * What a view shows.
 * @typedef {object} Seen
 * @property {object} model - Loaded, or with its parts apart.
 * @property {string} variant
 * @property {object[]} ghost - Of the shot.
 * @property {'render' | 'flat'} style
 * @property {number} index - Of the view in the spec.
 */

/** The pictures of one sheet: asked for while pages are laid out, drawn together from one load of the model. */

/** JPEG at which no ringing shows at the edge of white, on paper. */
const QUALITY = 93;

/** White around a garment, millimetres of paper: strokes of flats are half as wide beyond its edge, and edges are smooth over a pixel. */
const MARGIN = 1.5;

/** Resolution of a mask of the garment: a third of a millimetre. */
const MASK_PPI = 76.2;

/** How far off the edge of what a view shows of a part a line ends, where there is room: millimetres of paper. */
const CLEAR = 3;

const WHITE = '#ffffff';

/** Widths of the lines of flats on paper, millimetres: the series of ISO 128-2:2020 one step beneath that of Model.flat, for A4. */
const WEIGHTS = { silhouette: 0.5, contour: 0.35, seam: 0.25, stitch: 0.18, crease: 0.18 };

/** Metres from the middle of a model to a camera that sees all of it. */
const depthOf = ({ min, max }) => 2 * Math.hypot(...max.map((high, i) => high - min[i])) + 0.01;

const nameOf = (asked) => createHash('sha256').update(JSON.stringify(asked)).digest('hex').slice(0, 16);

export class Pictures {
  #renderer;
  #options;
  #asked = new Map();
  #flats = new Map();
  #squares = new Map();
  #depths = new Map();

  /**
   * @param {object} renderer
   * @param {{ppi: number, shot: object, flats: object, call: {signal?: AbortSignal, timeoutMs?: number | null}}} options shot: what pictures
   *   share: light, shading, quality; flats: of the spec
   */
  constructor(renderer, options) {
    this.#renderer = renderer;
    this.#options = options;
  }

  /**
   * A picture in true scale, drawn later.
   * @param {import('./scale.mjs').Extent} extent
   * @param {Seen & {ratio: number, margin?: number}} how
   * @returns {{file: string, width: number, height: number, view: import('./scale.mjs').TrueView}} millimetres of paper
   */
  ask(extent, { ratio, model, variant, ghost, style, index, margin = MARGIN }) {
    const view = trueView(extent, { ratio, ppi: this.#options.ppi, margin, depth: depthOf(model.facts.bounds) });
    const seen = { size: view.size, camera: view.camera, variant, ...(ghost.length > 0 && { ghost }) };
    const file = style === 'flat' ? this.#askFlat(seen, { ratio, model, index }) : this.#askRender(seen, { model, index });
    return { file, ...view.paper, view };
  }

  #renderOf(seen) {
    return { ...this.#options.shot, ...seen, background: WHITE, output: { format: 'jpeg', quality: QUALITY, ppi: Math.round(this.#options.ppi) } };
  }

  #askRender(seen, { model, index }) {
    const shot = this.#renderOf(seen);
    const file = `${nameOf([shot, model.facts.sha256])}.jpg`;
    this.#asked.set(file, { shot, model, index });
    return file;
  }

  #askFlat(shot, { ratio: scale, model, index }) {
    const { foldLength, ...flats } = this.#options.flats;
    const options = { ...flats, foldLength: Math.min(1, foldLength / shot.camera.height), scale, weights: WEIGHTS };
    const file = `${nameOf([shot, options, model.facts.sha256])}.svg`;
    this.#flats.set(file, { shot, options, model, index });
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
   * @param {import('./scale.mjs').Extent} extent
   * @param {Seen & {ratio: number, margin?: number}} how
   * @returns {Promise<{covers: (x: number, y: number) => boolean}>} millimetres of paper in the picture
   */
  async mask(extent, { ratio, model, variant, ghost, index, margin = MARGIN }) {
    const view = trueView(extent, { ratio, ppi: MASK_PPI, margin, depth: depthOf(model.facts.bounds) });
    const shot = {
      ...this.#options.shot,
      quality: 'draft',
      size: view.size,
      camera: view.camera,
      variant,
      ghost,
      background: 'transparent',
      output: { format: 'raw' },
    };
    const { data, info } = await this.#renderer.render(model, shot, this.#options.call).catch((thrown) => {
      throw ofView(thrown, index);
    });
    const perMillimetre = MASK_PPI / INCH;
    const covers = (x, y) => {
      const [px, py] = [Math.floor(x * perMillimetre), Math.floor(y * perMillimetre)];
      return px >= 0 && py >= 0 && px < info.width && py < info.height && data[4 * (py * info.width + px) + 3] > 0;
    };
    return { covers };
  }

  /**
   * Where a view shows the middle of a part, drawn at once: what is hidden behind other parts does not count.
   * @param {import('./scale.mjs').Extent} extent
   * @param {Seen & {ratio: number}} how
   * @param {{node: number | string} | {material: number | string}} part
   * @returns {Promise<import('./scale.mjs').Vec3 | undefined>} undefined where nothing of it is seen
   */
  async middleOf(extent, how, part) {
    if (how.ghost.length >= GHOSTS_MAX) return undefined;
    const view = trueView(extent, { ratio: how.ratio, ppi: MASK_PPI, margin: MARGIN, depth: depthOf(how.model.facts.bounds) });
    const key = `${how.index} ${how.ratio}`;
    if (!this.#depths.has(key)) this.#depths.set(key, await this.#depthsOf(view, how));
    // The part is what is farther, or gone, without it.
    const [whole, without] = [this.#depths.get(key), await this.#depthsOf(view, { ...how, ghost: [...how.ghost, { ...part, opacity: 0 }] })];
    const perMillimetre = view.size.width / view.paper.width;
    const pixel = middlePixel(
      whole.map((depth, i) => depth !== without[i]),
      view.size,
      Math.round(CLEAR * perMillimetre),
    );
    return pixel && view.pointAt(pixel.map((at) => (at + 0.5) / perMillimetre));
  }

  async #depthsOf({ size, camera }, { model, variant, ghost, index }) {
    const output = { format: 'raw', layers: { format: 'raw' } };
    // Without the part there may be nothing that says how deep to look: twice as far as to the middle there is none of the model.
    const depth = depthOf(model.facts.bounds);
    const range = { near: depth / 4, far: 2 * depth };
    const shot = { quality: 'draft', environment: 'none', size, camera: { ...camera, ...range }, variant, ghost, layers: ['depth'], output };
    const { layers } = await this.#renderer.render(model, shot, this.#options.call).catch((thrown) => {
      throw ofView(thrown, index);
    });
    return floatsOf(layers.depth);
  }

  /**
   * Draws all that was asked for.
   * @param {(part: number) => void} [onProgress]
   * @returns {Promise<Map<string, {data: Buffer, info: object}>>} by file
   */
  async draw(onProgress) {
    const drawn = new Map();
    // One load of each model: of the whole, and of each with its parts apart.
    const models = new Set([...this.#asked.values()].map(({ model }) => model));
    for (const model of models) {
      const asked = [...this.#asked].filter(([, picture]) => picture.model === model);
      const before = drawn.size;
      const progress = onProgress && ((part) => onProgress((before + part * asked.length) / this.#asked.size));
      for (const [file, image] of await this.#renders(model, asked, progress)) drawn.set(file, image);
    }
    for (const [file, { square, shot }] of this.#squares) drawn.set(file, await this.#renderer.render(square, shot, this.#options.call));
    for (const [file, flat] of this.#flats) drawn.set(file, { data: Buffer.from(await this.#flat(flat)) });
    return drawn;
  }

  async #renders(model, asked, onProgress) {
    try {
      const images = await this.#renderer.renderAll(
        model,
        asked.map(([, { shot }]) => shot),
        { ...this.#options.call, onProgress },
      );
      return asked.map(([file], i) => [file, images[i]]);
    } catch (thrown) {
      throw ofView(thrown, asked[thrown.index]?.[1].index);
    }
  }

  async #flat({ shot, options, model, index }) {
    try {
      return (await model.flat(shot, { ...options, ...this.#options.call })).svg;
    } catch (thrown) {
      // Of what the options name, parts alone may not be there.
      if (thrown.code !== 'E_MEASURE') throw ofView(thrown, index);
      throw new TelarError('E_SPEC', `spec.flats.stitched: ${thrown.message}`, { pointer: `/flats${thrown.pointer}`, cause: thrown });
    }
  }
}
