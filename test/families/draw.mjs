import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateSync, inflateSync } from 'node:zlib';
import { Browser } from '../parity/browser/chromium.mjs';
import { loadInputs } from '../parity/inputs.mjs';
import { PICTURES } from './places.mjs';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));

/** What a picture depends on besides the release and its case. */
const PAGE_FOLDERS = ['js/three', 'test/parity/browser', 'test/families/browser'];

const sha256 = (...parts) => {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part).update('\0');
  return hash.digest('hex').slice(0, 24);
};

/** Stands for the page in the keys of pictures: one that changes is drawn anew. */
export function pageStamp() {
  const files = PAGE_FOLDERS.flatMap((folder) =>
    readdirSync(path.join(ROOT, folder), { withFileTypes: true })
      .filter((entry) => entry.isFile() && /\.(mjs|html)$/.test(entry.name))
      .map(({ name }) => path.join(ROOT, folder, name)),
  );
  return sha256(...files.sort().map((file) => readFileSync(file)));
}

/**
 * A picture.
 * @typedef {object} Picture
 * @property {string} [absent] - Why the release cannot show the case; then nothing below is there.
 * @property {string} image - Name of its bytes, which are the same where the name is: see readPixels().
 * @property {string} mask - The same without background.
 */

const fileOf = (name) => path.join(PICTURES, `${name}.z`);

function keep(pixels) {
  const name = sha256(pixels);
  if (!existsSync(fileOf(name))) writeWhole(fileOf(name), deflateSync(pixels));
  return name;
}

function writeWhole(file, bytes) {
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(`${file}.part`, bytes);
  renameSync(`${file}.part`, file);
}

/** RGBA8, premultiplied, top row first. */
export const readPixels = (name) => inflateSync(readFileSync(fileOf(name)));

/** Pictures drawn until the list is written again: a run that ends early loses no more. */
const LIST_AFTER = 16;

/** One release in headless Chromium, started for the first picture that is not kept from before. */
export class ReleaseBrowser {
  #release;
  #kept;
  #browser;
  #unlisted = 0;

  /**
   * @param {object} release
   * @param {string} release.name - Of the release, and of what was edited in it.
   * @param {string} release.folder - Of the release.
   * @param {Map<string, string>} [release.edited] - As of Browser.start(); then the release's sources draw in place of its build.
   * @param {string} release.stamp - pageStamp()
   * @param {(line: string) => void} release.log - Gets what the page warns of.
   */
  constructor(release) {
    this.#release = release;
    this.#kept = existsSync(this.#list) ? JSON.parse(readFileSync(this.#list, 'utf8')) : {};
  }

  get #list() {
    return path.join(PICTURES, `${this.#release.name}.json`);
  }

  /** @param {Browser} [beside] - Whose Chromium it shares. @returns {Promise<Browser>} Of its own. */
  start(beside) {
    const { folder, edited, log } = this.#release;
    const options = new URLSearchParams({
      hdr: existsSync(path.join(folder, 'examples/jsm/loaders/HDRLoader.js')) ? 'HDRLoader' : 'RGBELoader',
      three: edited ? 'src/Three.js' : 'build/three.module.js',
    });
    const asked = { three: folder, edited, page: `test/families/browser/page.html?${options}`, log };
    return beside ? beside.another(asked) : Browser.start(asked);
  }

  /**
   * @param {object} input - As of Browser.draw().
   * @returns {Promise<Picture>} Kept from before, or drawn.
   */
  async picture({ shot, settings, model, environment, textures }) {
    const { stamp, edited } = this.#release;
    const texts = edited ? ['src', ...[...edited].flat()] : [];
    const key = sha256(stamp, JSON.stringify(textures ? [shot, settings, textures] : [shot, settings]), model, environment ?? '', ...texts);
    if (!this.#kept[key]) {
      this.#browser ??= this.start();
      this.#kept[key] = await drawPicture(await this.#browser, { shot, settings, model, environment, textures });
      if (++this.#unlisted >= LIST_AFTER) this.#writeList();
    }
    return this.#kept[key];
  }

  /**
   * Draws as Browser.draw(), what is not kept from before.
   * @throws {Error} Where the release cannot show it.
   */
  async draw(input) {
    const begin = performance.now();
    const { absent, image, mask } = await this.picture(input);
    if (absent) throw new Error(absent);
    const { width, height } = input.shot.size;
    return { width, height, image: readPixels(image), mask: readPixels(mask), facts: { loadMs: 0, drawMs: performance.now() - begin } };
  }

  #writeList() {
    if (this.#unlisted > 0) writeWhole(this.#list, JSON.stringify(this.#kept));
    this.#unlisted = 0;
  }

  async close() {
    this.#writeList();
    await (await this.#browser)?.close();
  }
}

/**
 * Draws cases with one release, those that are not kept from before.
 * @param {object} drawn - As of ReleaseBrowser: name, folder, edited.
 * @param {import('./cases.mjs').CASES} cases
 * @param {string} stamp - pageStamp()
 * @param {(line: string) => void} log - Gets what the page warns of.
 * @returns {Promise<Record<string, Picture>>} By name of the case.
 */
export async function drawRelease(drawn, cases, stamp, log) {
  const browser = new ReleaseBrowser({ ...drawn, stamp, log });
  const pictures = {};
  try {
    for (const item of cases) pictures[item.name] = await browser.picture({ shot: item.shot, settings: item.settings, ...(await loadInputs(item)) });
  } finally {
    await browser.close();
  }
  return pictures;
}

/** No word of a release, and so nothing to keep: the machine ran out of something. */
const CHROMIUM_ENDED = /Target .*has been closed|Target crashed/;

async function drawPicture(browser, input) {
  try {
    const { image, mask } = await browser.draw(input);
    return { image: keep(image), mask: keep(mask) };
  } catch (error) {
    if (CHROMIUM_ENDED.test(error.message)) throw error;
    // A release may fail at what others show, as 0.156.0 does at unlit materials; run.mjs asks that the last one does not.
    const reason = /(?:shot\.toneMapping: )(three\.js .* has no tone mapping .*)/.exec(error.message)?.[1] ?? `fails: ${error.message.split('\n')[0]}`;
    return { absent: reason };
  }
}
