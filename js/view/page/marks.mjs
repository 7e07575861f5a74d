import { labelPlaces } from './label_places.mjs';

const SVG = 'http://www.w3.org/2000/svg';

/** Pixels of the screen. */
const RADIUS = 5;

const element = (name, attributes, text = '') => {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
};

/**
 * Points and lines of the garment over its pictures; what lies behind it is pale and dashed.
 *
 * @typedef {{points: number[][], path?: number[][], isLoop?: boolean, label: string, isChosen?: boolean}} Mark metres
 */
export class Marks {
  #layers;
  #project;
  #hides;
  #marks = [];
  /** Pixels that labels are wide. */
  #widths = new Map();

  /**
   * @param {HTMLElement[]} pictures that show the garment
   * @param {(point: number[]) => number[] | undefined} project parts of the picture's width and height, from its top left corner;
   *   undefined: behind the camera
   * @param {(point: number[]) => boolean} hides whether the garment lies before it: drawn pale and dashed
   */
  constructor(pictures, project, hides) {
    this.#project = project;
    this.#hides = hides;
    this.#layers = pictures.map((picture) => {
      const svg = element('svg', { class: 'marks', 'aria-hidden': 'true' });
      picture.append(svg);
      new ResizeObserver(() => this.draw()).observe(picture);
      return svg;
    });
  }

  /** @param {Mark[]} marks */
  show(marks) {
    this.#marks = marks;
    this.draw();
  }

  /** Draws them again: the camera or the pictures have moved. */
  draw() {
    const known = new Map();
    const hides = (point) => {
      if (!known.has(point)) known.set(point, this.#hides(point));
      return known.get(point);
    };
    for (const svg of this.#layers) {
      const { clientWidth: width, clientHeight: height } = svg.parentElement.querySelector('.paper');
      if (width === 0) continue;
      svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
      const place = (point) => this.#project(point)?.map((part, i) => (part * [width, height][i]).toFixed(2));
      const marks = this.#marks.map((mark) => drawn(mark, place, hides));
      svg.replaceChildren(...marks.map(({ group }) => group));
      this.#placeLabels(
        marks.filter(({ text }) => text),
        [width, height],
      );
    }
  }

  #placeLabels(marks, picture) {
    for (const { text } of marks) {
      const label = text.textContent;
      if (!this.#widths.has(label)) this.#widths.set(label, text.getComputedTextLength());
    }
    const labels = marks.map(({ text, beside }) => ({ points: beside, width: this.#widths.get(text.textContent) }));
    const places = labelPlaces(
      labels,
      marks.flatMap(({ points }) => points),
      picture,
    );
    for (const [i, [x, y]] of places.entries()) {
      marks[i].text.setAttribute('x', x);
      marks[i].text.setAttribute('y', y);
    }
  }
}

/** @returns {{group: SVGElement, text?: SVGElement, points: number[][], beside: number[][]}} `text` without a place; it may stand beside `beside` */
function drawn({ points, path, isLoop, label, isChosen }, place, hides) {
  const group = element('g', { class: isChosen ? 'mark chosen' : 'mark' });
  group.dataset.label = label;
  const line = path?.map((point) => ({ at: place(point), isHidden: hides(point) })) ?? [];
  // A line that runs behind the camera is not drawn: its picture would be another line.
  const isDrawn = line.length > 1 && line.every(({ at }) => at);
  if (isDrawn) for (const run of runsOf(isLoop ? [...line, line[0]] : line)) group.append(lineOf(run));
  const places = points.map((point) => ({ at: place(point), isHidden: hides(point) })).filter(({ at }) => at);
  for (const { at, isHidden } of places) group.append(element('circle', { cx: at[0], cy: at[1], r: RADIUS, ...(isHidden && HIDDEN) }));
  const all = [...places, ...(isDrawn ? line : [])];
  const isBehind = all.length > 0 && all.every(({ isHidden }) => isHidden);
  const shown = places.map(({ at }) => at.map(Number));
  const onLine = line.find(({ at }) => at)?.at.map(Number);
  const beside = shown.length > 0 || !onLine ? shown : [onLine];
  if (beside.length === 0) return { group, points: shown, beside };
  const text = element('text', isBehind ? HIDDEN : {}, label);
  group.append(text);
  return { group, text, points: shown, beside };
}

const HIDDEN = { class: 'hidden' };

/** A line in runs that are seen and runs that are not: between two points that are hidden it is hidden. */
function runsOf(line) {
  const runs = [];
  line.slice(1).forEach((to, i) => {
    const from = line[i];
    const isHidden = from.isHidden && to.isHidden;
    if (runs.at(-1)?.isHidden === isHidden) runs.at(-1).points.push(to.at);
    else runs.push({ isHidden, points: [from.at, to.at] });
  });
  return runs;
}

const lineOf = ({ isHidden, points }) => element('polyline', { points: points.map((at) => at.join(',')).join(' '), ...(isHidden && HIDDEN) });
