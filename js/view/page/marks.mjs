const SVG = 'http://www.w3.org/2000/svg';

/** Pixels of the screen. */
const RADIUS = 5;
const LABEL = { x: 9, y: -7 };

const element = (name, attributes, text = '') => {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.textContent = text;
  return node;
};

/**
 * Points and lines of the garment over its pictures, where the camera sees them.
 *
 * @typedef {{points: number[][], path?: number[][], isLoop?: boolean, label: string, isChosen?: boolean}} Mark metres
 */
export class Marks {
  #layers;
  #project;
  #marks = [];

  /**
   * @param {HTMLElement[]} pictures that show the garment
   * @param {(point: number[]) => number[] | undefined} project parts of the picture's width and height, from its top left corner;
   *   undefined: behind the camera
   */
  constructor(pictures, project) {
    this.#project = project;
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
    for (const svg of this.#layers) {
      const { clientWidth: width, clientHeight: height } = svg.parentElement.querySelector('.paper');
      if (width === 0) continue;
      svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
      const place = (point) => this.#project(point)?.map((part, i) => (part * [width, height][i]).toFixed(2));
      svg.replaceChildren(...this.#marks.map((mark) => drawn(mark, place)));
    }
  }
}

function drawn({ points, path, isLoop, label, isChosen }, place) {
  const group = element('g', { class: isChosen ? 'mark chosen' : 'mark' });
  group.dataset.label = label;
  const line = path?.map(place) ?? [];
  // A line that runs behind the camera is not drawn: its picture would be another line.
  if (line.length > 1 && line.every(Boolean)) group.append(element(isLoop ? 'polygon' : 'polyline', { points: line.map((at) => at.join(',')).join(' ') }));
  const places = points.map(place).filter(Boolean);
  for (const [cx, cy] of places) group.append(element('circle', { cx, cy, r: RADIUS }));
  const at = places[0] ?? line.find(Boolean);
  if (at) group.append(element('text', { x: Number(at[0]) + LABEL.x, y: Number(at[1]) + LABEL.y }, label));
  return group;
}
