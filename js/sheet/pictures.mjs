import { createHash } from 'node:crypto';
import { trueView } from './scale.mjs';

/** The pictures of one sheet: asked for while pages are laid out, drawn together from one load of the model. */

/** JPEG at which no ringing shows at the edge of white, on paper. */
const QUALITY = 93;

/** White around a garment, millimetres of paper: outlines of round models miss a little of them. */
const MARGIN = 1.5;

/** Resolution of a mask of the garment: a third of a millimetre. */
const MASK_PPI = 76.2;

const WHITE = '#ffffff';

/** Metres from the middle of a model to a camera that sees all of it. */
const depthOf = ({ min, max }) => 2 * Math.hypot(...max.map((high, i) => high - min[i])) + 0.01;

export class Pictures {
  #renderer;
  #model;
  #options;
  #asked = new Map();

  /**
   * @param {object} renderer
   * @param {object} model loaded
   * @param {{ppi: number, shot: object, call: {signal?: AbortSignal, timeoutMs?: number | null}}} options shot: what pictures share: light, shading, quality
   */
  constructor(renderer, model, options) {
    this.#renderer = renderer;
    this.#model = model;
    this.#options = options;
  }

  /**
   * A picture in true scale, drawn later.
   * @param {import('./scale.mjs').Extent} extent
   * @param {{ratio: number, variant: string, margin?: number}} how
   * @returns {{file: string, width: number, height: number, view: import('./scale.mjs').TrueView}} millimetres of paper
   */
  ask(extent, { ratio, variant, margin = MARGIN }) {
    const view = trueView(extent, { ratio, ppi: this.#options.ppi, margin, depth: depthOf(this.#model.facts.bounds) });
    const shot = {
      ...this.#options.shot,
      size: view.size,
      camera: view.camera,
      variant,
      background: WHITE,
      output: { format: 'jpeg', quality: QUALITY, ppi: Math.round(this.#options.ppi) },
    };
    const file = `${createHash('sha256').update(JSON.stringify(shot)).digest('hex').slice(0, 16)}.jpg`;
    this.#asked.set(file, shot);
    return { file, ...view.paper, view };
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
    const perMillimetre = MASK_PPI / 25.4;
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
    return new Map(files.map((file, i) => [file, images[i]]));
  }
}
