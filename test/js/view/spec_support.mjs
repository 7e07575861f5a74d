import { changing, HANGS_AFTER_MS } from './support.mjs';

/** What tests of the page's sheet share: places in the pictures by the camera's own arithmetic, without three.js. */

const sub = (a, b) => a.map((value, i) => value - b[i]);
const add = (a, b, factor = 1) => a.map((value, i) => value + factor * b[i]);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((value) => value / Math.hypot(...a));

export const apart = (a, b) => Math.hypot(...sub(a, b));

/** The camera of the page as the server resolves it: position, axes, and how far the picture reaches at a distance of 1. */
export async function cameraOf(page) {
  const { camera, size } = await page.evaluate(async () => {
    const response = await fetch('draw', { method: 'POST', headers: { 'content-type': 'application/json' }, body: document.querySelector('#shot').value });
    return JSON.parse((await response.formData()).get('info')).shot;
  });
  const forward = unit(sub(camera.target, camera.position));
  const right = unit(cross(forward, camera.up));
  const reach = Math.tan((camera.fovY * Math.PI) / 360);
  return { position: camera.position, forward, right, up: cross(right, forward), reach: [(reach * size.width) / size.height, reach] };
}

/** The point of a plane that is seen at a place of the picture, parts of it from the top left corner. */
export function seenOn({ position, forward, right, up, reach }, [u, v], { point, normal }) {
  const ray = add(add(forward, right, (2 * u - 1) * reach[0]), up, (1 - 2 * v) * reach[1]);
  return add(position, ray, dot(sub(point, position), normal) / dot(ray, normal));
}

/** Where a point of the model is seen. */
export function placeOf({ position, forward, right, up, reach }, point) {
  const to = sub(point, position);
  const depth = dot(to, forward);
  return [(dot(to, right) / depth / reach[0] + 1) / 2, (1 - dot(to, up) / depth / reach[1]) / 2];
}

/** Rectangle of a picture on the screen, pixels. */
export async function rectangleOf(page, selector = '#client-picture') {
  const canvas = page.locator(`${selector} canvas`).first();
  await canvas.scrollIntoViewIfNeeded();
  return canvas.boundingBox();
}

/** A click on the whole pixel that is nearest to a place. @returns the place of that pixel */
export async function clickAt(page, place, selector) {
  const { x, y, width, height } = await rectangleOf(page, selector);
  const at = [Math.round(x + place[0] * width), Math.round(y + place[1] * height)];
  await page.mouse.click(...at);
  return [(at[0] - x) / width, (at[1] - y) / height];
}

export const tool = (page, name) => page.locator(`input[name=tool][value=${name}]`).check({ force: true });

/** Values of the controls of one list, by row. */
export const rowsOf = (page, list) =>
  page
    .locator(`#${list} tbody tr`)
    .evaluateAll((rows) =>
      rows.map((row) => Object.fromEntries([...row.querySelectorAll('[data-field], output')].map((node) => [node.dataset.field ?? 'length', node.value]))),
    );

/** What is drawn over a picture: for each mark its label, its places and its line, parts of the picture. */
export const marksOf = (page, selector = '#client-picture') =>
  page.locator(`${selector} svg.marks`).evaluate((svg) => {
    const [, , width, height] = svg.getAttribute('viewBox').split(' ').map(Number);
    const part = ([x, y]) => [x / width, y / height];
    return [...svg.querySelectorAll('g')].map((group) => ({
      label: group.dataset.label,
      places: [...group.querySelectorAll('circle')].map((circle) => part([Number(circle.getAttribute('cx')), Number(circle.getAttribute('cy'))])),
      line: [...group.querySelectorAll('polyline')].flatMap((line) => line.getAttribute('points').split(' ')).map((pair) => part(pair.split(',').map(Number))),
      isHidden: [...group.querySelectorAll('circle')].map((circle) => circle.classList.contains('hidden')),
    }));
  });

/** Pairs of labels of the browser's picture of which one covers the other by more than a pixel. */
export const overlaps = (page) =>
  page.locator('#client-picture svg.marks text').evaluateAll((texts) => {
    const boxes = texts.map((text) => text.getBBox());
    const covers = (a, b) =>
      Math.min(a.x + a.width, b.x + b.width) > Math.max(a.x, b.x) + 1 && Math.min(a.y + a.height, b.y + b.height) > Math.max(a.y, b.y) + 1;
    return texts.flatMap((text, i) =>
      texts.slice(i + 1).flatMap((other, k) => (covers(boxes[i], boxes[i + 1 + k]) ? [`${text.textContent}, ${other.textContent}`] : [])),
    );
  });

/** Millimetres that a page's length text says. */
export const lengthIn = (text) => 10 * Number.parseFloat(text);

/** Turns to a named view and waits for both pictures. */
export const look = (page, view) => changing(page, () => page.locator(`#views [data-view=${view}]`).click());

/** Waits until no length is asked for. */
export const measured = (page) =>
  page.waitForFunction(() => [...document.querySelectorAll('#measures output')].every(({ value }) => value !== '' && value !== '\u2026'));

/** Saves, and waits until the page knows. */
export async function save(page) {
  await page.locator('#save-spec').click();
  await page.waitForSelector('#sheet[data-saved=true]', { timeout: HANGS_AFTER_MS });
}
