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

/**
 * Draws cases with one release, those that are not kept from before.
 * @param {object} drawn
 * @param {string} drawn.name - Of the release, and of what was edited in it.
 * @param {string} drawn.folder - Of the release.
 * @param {Map<string, string>} [drawn.edited] - As of Browser.start(); then the release's sources draw in place of its build.
 * @param {import('./cases.mjs').CASES} cases
 * @param {string} stamp - pageStamp()
 * @param {(line: string) => void} log - Gets what the page warns of.
 * @returns {Promise<Record<string, Picture>>} By name of the case.
 */
export async function drawRelease({ name, folder, edited }, cases, stamp, log) {
  const list = path.join(PICTURES, `${name}.json`);
  const kept = existsSync(list) ? JSON.parse(readFileSync(list, 'utf8')) : {};
  const texts = edited ? ['src', ...[...edited].flat()] : [];
  const wanted = [];
  for (const item of cases) {
    const inputs = await loadInputs(item);
    wanted.push({ item, inputs, key: sha256(stamp, JSON.stringify([item.shot, item.settings]), inputs.model, inputs.environment ?? '', ...texts) });
  }
  const missing = wanted.filter(({ key }) => !kept[key]);
  if (missing.length > 0) {
    const options = new URLSearchParams({
      hdr: existsSync(path.join(folder, 'examples/jsm/loaders/HDRLoader.js')) ? 'HDRLoader' : 'RGBELoader',
      three: edited ? 'src/Three.js' : 'build/three.module.js',
    });
    const browser = await Browser.start({ three: folder, edited, page: `test/families/browser/page.html?${options}`, log });
    try {
      for (const { item, inputs, key } of missing) kept[key] = await drawCase(browser, item, inputs);
    } finally {
      await browser.close();
    }
    writeWhole(list, JSON.stringify(kept));
  }
  return Object.fromEntries(wanted.map(({ item, key }) => [item.name, kept[key]]));
}

async function drawCase(browser, item, inputs) {
  try {
    const { image, mask } = await browser.draw({ shot: item.shot, settings: item.settings, ...inputs });
    return { image: keep(image), mask: keep(mask) };
  } catch (error) {
    // A release may fail at what others show, as 0.156.0 does at unlit materials; run.mjs asks that the last one does not.
    const reason = /absent: (.*)/.exec(error.message)?.[1] ?? `fails: ${error.message.split('\n')[0]}`;
    return { absent: reason };
  }
}
