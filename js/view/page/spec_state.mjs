/** Most steps that can be undone. */
const STEPS = 200;

/** Metres are kept to a hundredth of a millimetre: a tenth of what is promised. */
const DIGITS = 5;

const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';

/** @param {number[]} point metres */
export const rounded = (point) => point.map((value) => Number(value.toFixed(DIGITS)) + 0);

/** The first code that no point of measure has: A, B, ..., Z, A2, ... */
export function nextCode(measures) {
  const taken = new Set(measures.map(({ code }) => code));
  for (let round = 1; ; round++) {
    const free = [...LETTERS].map((letter) => (round === 1 ? letter : `${letter}${round}`)).find((code) => !taken.has(code));
    if (free) return free;
  }
}

/** The view of the spec that looks at a thing most as the camera does. @param {{name: string, back: number[]}[]} views @param {number[]} back to the viewer */
export function nearestView(views, back) {
  const facing = (view) => view.back.reduce((sum, value, i) => sum + value * back[i], 0);
  return views.reduce((best, view) => (facing(view) > facing(best) + 1e-9 ? view : best)).name;
}

/**
 * The call-outs and points of measure of a spec as they are edited: `lists` is what is saved. Rows are never changed, only
 * replaced. Fires `change`.
 */
export class SpecState extends EventTarget {
  #lists;
  #saved;
  #undone = [];
  #done = [];

  /** @param {{callouts: object[], measures: object[]}} spec */
  constructor({ callouts, measures }) {
    super();
    this.#lists = { callouts, measures };
    this.#saved = this.#lists;
  }

  get lists() {
    return this.#lists;
  }

  /** Whether something is to be saved. */
  get isEdited() {
    return this.#lists !== this.#saved;
  }

  get canUndo() {
    return this.#done.length > 0;
  }

  get canRedo() {
    return this.#undone.length > 0;
  }

  #show(lists) {
    this.#lists = lists;
    this.dispatchEvent(new Event('change'));
  }

  #change(list, rows) {
    this.#done = [...this.#done, this.#lists].slice(-STEPS);
    this.#undone = [];
    this.#show({ ...this.#lists, [list]: rows });
  }

  /** @param {'callouts' | 'measures'} list */
  add(list, row) {
    this.#change(list, [...this.#lists[list], row]);
  }

  remove(list, index) {
    this.#change(list, this.#lists[list].toSpliced?.(index, 1) ?? this.#lists[list].filter((_, i) => i !== index));
  }

  /** Sets some keys of a row; undefined takes a key away. Nothing happens where they are so already. */
  edit(list, index, keys) {
    const row = this.#lists[list][index];
    const edited = Object.fromEntries(Object.entries({ ...row, ...keys }).filter(([, value]) => value !== undefined));
    if (JSON.stringify(edited) === JSON.stringify(row)) return;
    this.#change(
      list,
      this.#lists[list].map((other, i) => (i === index ? edited : other)),
    );
  }

  undo() {
    if (!this.canUndo) return;
    this.#undone.push(this.#lists);
    this.#show(this.#done.pop());
  }

  redo() {
    if (!this.canRedo) return;
    this.#done.push(this.#lists);
    this.#show(this.#undone.pop());
  }

  /** @param {object} lists that are in the file now */
  markSaved(lists) {
    this.#saved = lists;
    this.dispatchEvent(new Event('change'));
  }
}
