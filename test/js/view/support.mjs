import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { COMMON_FLAGS, PLAIN_PAGE_FLAGS, RASTERIZER_FLAGS } from '../../parity/browser/flags.mjs';
import '../api/support/real.mjs';
import '../built.mjs';

export const SHIRT = fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url));
export const CLI = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));

/** @param {keyof typeof RASTERIZER_FLAGS} [rasterizer] */
export const launchChromium = (rasterizer = 'mesa') =>
  chromium.launch({
    executablePath: process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium',
    args: [...COMMON_FLAGS, ...RASTERIZER_FLAGS[rasterizer], ...PLAIN_PAGE_FLAGS],
  });

/** Milliseconds: a page that is not done then will not be, on however busy a machine. */
export const HANGS_AFTER_MS = 600_000;

/**
 * The real `telar view` in a process of its own.
 * @param {string} model
 * @param {string[]} [args]
 * @returns {Promise<{url: string, told: object, child: import('node:child_process').ChildProcess, stop: () => Promise<[number, string]>}>}
 *   stop: SIGINT, then exit code and signal
 */
export async function openView(model, args = []) {
  const child = spawn(process.execPath, [CLI, 'view', model, '--json', '--quiet', ...args], { stdio: ['ignore', 'pipe', 'inherit'] });
  const ended = once(child, 'exit');
  const line = await Promise.race([
    once(createInterface(child.stdout), 'line'),
    ended.then(([code]) => Promise.reject(new Error(`telar view ended with ${code}`))),
  ]);
  const told = JSON.parse(line[0]);
  const stop = () => {
    child.kill('SIGINT');
    return ended;
  };
  return { url: told.url, told, child, stop };
}

/** Waits until both pictures and their figures stand. */
export const settled = (page) => page.waitForSelector('body[data-phase=ready]', { timeout: HANGS_AFTER_MS });

/** Runs what changes the shot, and waits until both sides show it. */
export async function changing(page, act) {
  // By their number: a drawing may be over before its phase is seen.
  const drawings = await page.getAttribute('body', 'data-drawings');
  await act();
  await page.waitForSelector(`body[data-phase=ready]:not([data-drawings="${drawings}"])`, { timeout: HANGS_AFTER_MS });
}

/** Both pictures as the page shows them, each as text. */
export const pictures = (page) =>
  page.evaluate(() => ['#client-canvas canvas', '#server-picture canvas'].map((name) => document.querySelector(name).toDataURL()));

/** The figures of one region by the table's headings. */
export const figuresOf = (page, region) =>
  page.evaluate((name) => {
    const rows = [...document.querySelectorAll('#figures tr')].map((row) => [...row.cells].map((cell) => cell.textContent));
    const row = rows.find(([first]) => first === name);
    return Object.fromEntries(rows[0].map((heading, i) => [heading, Number(row[i])]));
  }, region);

/** How many pixels of a picture are opaque, and how many are dark. */
export const countsOf = (page, selector) =>
  page.evaluate((name) => {
    const source = document.querySelector(name);
    const canvas = new OffscreenCanvas(source.width, source.height);
    const context = canvas.getContext('2d');
    context.drawImage(source, 0, 0);
    const { data } = context.getImageData(0, 0, source.width, source.height);
    let [opaque, lit] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] === 255) opaque++;
      if (data[i] + data[i + 1] + data[i + 2] > 0) lit++;
    }
    return { width: source.width, height: source.height, opaque, lit };
  }, selector);

/** Changes what the page asks of the server, or what it is answered. */
export const onRoute = (target, change) => (page) =>
  page.route(`**/${target}`, async (route) => (route.request().method() === 'POST' ? change(route) : route.continue()));

export const withBody = (edit) => (route) => {
  const body = route.request().postDataJSON();
  edit(body);
  return route.continue({ postData: JSON.stringify(body) });
};
