import { chromium } from 'playwright-core';
import { serial } from '../serial.mjs';
import { COMMON_FLAGS, PLAIN_PAGE_FLAGS, RASTERIZER_FLAGS } from './flags.mjs';
import { startServer } from './server.mjs';

/** Executable: TELAR_CHROMIUM, else Debian's. */
const executablePath = () => process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium';

/**
 * Real headless Chromium with one page of stock three.js.
 */
export class Browser {
  #server;
  #browser;
  #page;
  #jobs = 0;
  /** URL by environment: the page keeps what it prefiltered of one. */
  #environments = new WeakMap();
  /** One job at a time: they share the page's renderers. */
  #evaluate = serial((name, job) => this.#page.evaluate(([entry, request]) => window[entry](request), [name, job]));

  /**
   * @param {object} [options]
   * @param {'mesa' | 'swiftshader'} [options.rasterizer]
   * @param {boolean} [options.isMeasured] - Draws the page around WebGL by GL as well, as browsers do: what it costs is compared.
   * @param {string} [options.three] - Folder of the three.js to draw with; the development dependency where it is left out.
   * @param {Map<string, string>} [options.edited] - Texts in place of files of that folder, by their path in it.
   * @param {string} [options.page] - The page, from the project's root.
   * @param {(text: string) => void} [options.log] - Gets what the page warns of.
   * @returns {Promise<Browser>}
   * @throws {Error} With the cure, when Chromium cannot be started.
   */
  static async start({ rasterizer = 'mesa', isMeasured = false, ...options } = {}) {
    let browser;
    try {
      browser = await chromium.launch({
        executablePath: executablePath(),
        args: [...COMMON_FLAGS, ...RASTERIZER_FLAGS[rasterizer], ...(isMeasured ? [] : PLAIN_PAGE_FLAGS)],
      });
    } catch (cause) {
      const cure = 'install it with "apt-get install chromium", or name another one in TELAR_CHROMIUM';
      throw new Error(`Chromium does not start from ${executablePath()}: ${cure}\n${cause.message}`, { cause });
    }
    const self = await Browser.#open(browser, options);
    self.#browser = browser;
    return self;
  }

  /** A second page beside this one, with renderers of its own. It is closed with this one's browser, or before. */
  another(options) {
    return Browser.#open(this.#page.context().browser(), options);
  }

  static async #open(browser, { three, edited, page = 'test/parity/browser/page.html', log = console.error } = {}) {
    const self = new Browser();
    self.#server = await startServer({ three, edited });
    self.#page = await browser.newPage();
    self.#page.on('pageerror', (error) => log(`page: ${error.stack ?? error}`));
    self.#page.on('console', (message) => {
      if (['warning', 'error'].includes(message.type())) log(`page: ${message.text()}`);
    });
    await self.#page.goto(`${self.#server.origin}/${page}`);
    await self.#page.waitForFunction('window.telarReady === true', undefined, { timeout: 600_000 });
    return self;
  }

  /**
   * @param {object} input
   * @param {object} input.shot - Resolved shot.
   * @param {Uint8Array | string} input.model - GLB bytes, or an absolute path (its folder is served).
   * @param {Uint8Array} [input.environment] - .hdr or .exr bytes; required where the shot has an environment.
   * @param {object} [input.settings] - Of the client's page, beside the shot.
   * @param {boolean} [input.ownText] - Shades with telar's text of stock three.js in place of three's own.
   * @param {boolean} [input.keepPrograms] - Keeps compiled programs for the next draw, as a page does that never disposes of materials.
   * @returns {Promise<{width: number, height: number, image: Uint8Array, mask: Uint8Array, facts: object}>} Drawing
   *   buffer, and the same drawn without background (one array where there is none): RGBA8, sRGB-encoded, premultiplied, top row first.
   */
  async draw(input) {
    const job = this.#job(input);
    const facts = await this.#run('telarDraw', job);
    const { width, height } = input.shot.size;
    const take = (name) => flipRows(this.#server.takeResult(`${job.result}/${name}`), width, height);
    const image = take('image');
    return { width, height, image, mask: this.#server.hasResult(`${job.result}/mask`) ? take('mask') : image, facts };
  }

  /**
   * Draws shots one after the other with one loaded model.
   * @param {object} input - As draw(), with `shots` of one size in place of `shot`.
   * @returns {Promise<{images: Uint8Array[], held: {programs: number, textures: number}[]}>} Drawing buffers, and what the renderer
   *   held after each.
   */
  async sequence({ shots, ...input }) {
    const job = { ...this.#job({ ...input, shot: shots[0] }), shots };
    const held = await this.#run('telarSequence', job);
    const { width, height } = shots[0].size;
    return { images: shots.map((_, i) => flipRows(this.#server.takeResult(`${job.result}/${i}`), width, height)), held };
  }

  /**
   * Values of three's own shader variables, each drawn into a float target without antialiasing.
   * @param {object} input - As draw().
   * @param {string[] | null} input.terms - Names (browser/terms.mjs), or null for all.
   * @param {[number, number]} [input.pixel] - From the top left; the whole picture where it is left out.
   * @returns {Promise<Record<string, Float32Array>>} By term: RGBA fp32, top row first; alpha 1 where the material has the
   *   term, else all 0.
   */
  async terms({ terms, pixel, ...input }) {
    const region = pixel && { x: pixel[0], y: input.shot.size.height - 1 - pixel[1], width: 1, height: 1 };
    const job = { ...this.#job(input), terms, region };
    const names = await this.#run('telarTerms', job);
    const { width, height } = region ?? input.shot.size;
    const take = (name) => new Float32Array(flipRows(this.#server.takeResult(`${job.result}/${name}`), width * 4, height).buffer);
    return Object.fromEntries(names.map((name) => [name, take(name)]));
  }

  /**
   * Faces of the cube that three prefilters of an environment.
   * @param {{shot: object, environment: Uint8Array}} input - The shot only chooses the context.
   * @returns {Promise<{name: string, size: number, values: Float32Array}[]>} As browser/prefilter.mjs.
   */
  async prefilter({ shot, environment }) {
    const job = this.#job({ shot, model: '', environment });
    const faces = await this.#run('telarPrefilter', job);
    return faces.map((face) => ({ ...face, values: new Float32Array(this.#server.takeResult(`${job.result}/${face.name}`).slice().buffer) }));
  }

  async #run(name, job) {
    try {
      return await this.#evaluate(name, job);
    } finally {
      this.#server.withdraw(job.model);
    }
  }

  #job({ shot, model, environment, textures, ownText, keepPrograms, settings }) {
    const id = ++this.#jobs;
    return {
      shot,
      textures,
      ownText,
      keepPrograms,
      settings,
      model: typeof model === 'string' ? this.#server.offerFile(model) : this.#server.offerBytes(`${id}.glb`, model),
      environment: environment ? this.#offerEnvironment(environment, id) : null,
      result: `/result/${id}`,
    };
  }

  #offerEnvironment(bytes, id) {
    const format = isExr(bytes) ? 'exr' : 'hdr';
    if (!this.#environments.has(bytes)) this.#environments.set(bytes, this.#server.offerBytes(`${id}.${format}`, bytes));
    return { url: this.#environments.get(bytes), format };
  }

  async close() {
    await (this.#browser ?? this.#page)?.close();
    await this.#server?.close();
  }
}

const isExr = (bytes) => Buffer.from(bytes.buffer, bytes.byteOffset, 4).equals(Buffer.from([0x76, 0x2f, 0x31, 0x01]));

function flipRows(pixels, width, height) {
  const stride = width * 4;
  const flipped = new Uint8Array(pixels.length);
  for (let y = 0; y < height; y++) flipped.set(pixels.subarray(y * stride, (y + 1) * stride), (height - 1 - y) * stride);
  return flipped;
}
