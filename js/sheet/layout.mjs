import { PAPERS } from './table/index.mjs';
import { fittingRatio, ratioOf, scaleText } from './scale.mjs';
import { pathText, pointerText, wrongValue } from '../shot/complain.mjs';
import { ABOUT } from './read.mjs';
import { printedText } from './units.mjs';

/** Measures of a page, and what its pages share. Millimetres. */

const MARGIN = 12;
const TOP = 23;
const BOTTOM = 14;

/** Room that a section's heading takes. */
export const HEADING = 10;

/** The paper, and the box that sections fill. @param {{paper: {size: string, orientation: string}}} spec */
export function pageOf({ paper: { size, orientation } }) {
  const [short, long] = PAPERS[size];
  const [width, height] = orientation === 'landscape' ? [long, short] : [short, long];
  return { width, height, margin: MARGIN, top: TOP, bottom: BOTTOM, box: { width: width - 2 * MARGIN, height: height - TOP - BOTTOM }, isWide: width > height };
}

/** White above the name of a view, and beneath it. */
export const CAPTION_GAP = 2.5;
const CAPTION_END = 2;

/** A figure without anything in it. */
export const emptyFigure = (width, height) => ({
  width,
  height,
  pictures: [],
  rings: [],
  lines: [],
  arrows: [],
  sites: [],
  captions: [],
  labels: [],
  codes: [],
});

/** What the parts of one sheet need to know of each other. */
export class Layout {
  /**
   * @param {object} parts
   * @param {object} parts.spec of readSpec
   * @param {object} parts.facts of the model
   * @param {{model: object, extent: import('./scale.mjs').Extent}[]} parts.shown of shownBy
   * @param {(key: string, values?: object) => string} parts.words
   * @param {import('./pictures.mjs').Pictures} parts.pictures
   * @param {import('./engine.mjs').Engine} parts.engine
   * @param {Set<string>} parts.changed JSON pointers that differ from the last revision
   */
  constructor(parts) {
    Object.assign(this, parts);
    this.page = pageOf(parts.spec);
    this.warnings = [];
  }

  warn(code, message, pointer) {
    this.warnings.push({ code, message, pointer });
  }

  /** Tells of a length of the spec that is printed as another one. @param {(string | number)[]} path @param {number} length in the spec's units */
  roundedAt(path, length, printed, of = '') {
    const { units, printedUnits } = this.spec;
    this.warn('W_SHEET_ROUND', `${pathText(path, ABOUT)}: ${length} ${units}${of} is printed as ${printedText(printed)} ${printedUnits}`, pointerText(path));
  }

  #indexOf({ name }) {
    return this.spec.views.findIndex((view) => view.name === name);
  }

  extent(view) {
    return this.shown[this.#indexOf(view)].extent;
  }

  /** What pictures need to know of a view. @returns {import('./pictures.mjs').Seen} */
  seen(view) {
    const index = this.#indexOf(view);
    return { model: this.shown[index].model, variant: view.variant, ghost: view.ghost, style: view.style, index };
  }

  /** The scale of a view that has a box to itself. @throws {TelarError} E_SPEC where the spec's does not fit */
  ratio(view, box) {
    const extent = this.extent(view);
    const fitting = fittingRatio([extent], box);
    if (view.scale === 'fit') return fitting;
    const ratio = ratioOf(view.scale);
    const [width, height] = [extent.width, extent.height].map((length) => (1000 * length) / ratio);
    if (width <= box.width && height <= box.height) return ratio;
    const index = this.spec.views.indexOf(view);
    throw wrongValue(
      ['views', index, 'scale'],
      `a scale at which ${Math.round(width)} x ${Math.round(height)} mm fit into ${Math.floor(box.width)} x ${Math.floor(box.height)} mm of this paper, such as "${scaleText(fitting)}"`,
      view.scale,
      ABOUT,
    );
  }

  titleOf(view) {
    if (view.title) return view.title;
    return view.view ? this.words(`view.${view.view}`) : view.name;
  }

  /** Room that the name of a view takes beneath it, millimetres, with the gap above. */
  captionRoom(views, width) {
    const sizes = this.measure(views.map((view) => ({ kind: 'caption', text: this.titleOf(view), value: this.scaleNote(88.888), width })));
    return CAPTION_GAP + Math.max(...sizes.map(([, height]) => height)) + CAPTION_END;
  }

  /** The name of a view beneath it, with its scale. @param {{x: number, y: number, width: number}} at */
  caption(view, ratio, at) {
    return { ...at, title: this.titleOf(view), note: this.scaleNote(ratio), text: '', centred: true };
  }

  scaleNote(ratio) {
    return `${this.words('scale')} ${scaleText(ratio)}`;
  }

  altOf(view, ratio) {
    const { name, style } = this.spec.header;
    return this.words(view.style === 'flat' ? 'alt.flat' : 'alt.view', {
      name: name || style || this.facts.name || this.words('sheet'),
      title: this.titleOf(view),
      scale: scaleText(ratio),
    });
  }

  isChanged(...path) {
    return this.changed.has(pointerText(path));
  }

  /** Widths and heights of texts as the template sets them. @param {{kind: string, text: string, width: number, value?: string}[]} texts */
  measure(texts) {
    if (texts.length === 0) return [];
    return this.engine.measure({ texts, fonts: this.fonts, language: this.spec.language.split('-')[0] });
  }
}
