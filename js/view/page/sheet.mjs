import { Lengths } from './lengths.mjs';
import { Marks } from './marks.mjs';
import { addPicking } from './picking.mjs';
import { saveSpec, spec as readSpec } from './remote.mjs';
import { Rows } from './spec_rows.mjs';
import { SpecState, nearestView, nextCode, rounded } from './spec_state.mjs';

const $ = (id) => document.getElementById(id);

const HINTS = {
  turn: 'Choose what a click on the garment makes.',
  callout: 'Click on the garment: the call-out points there.',
  straight: 'Click on the garment where the measure begins and where it ends.',
  surface: 'Click on the garment where the measure begins, and where it goes on.',
};
const SECOND = 'Now where it ends.';
const FURTHER = 'Click where it goes on; Enter, or a second click on its end, ends it.';

/** Pixels of the screen within which a click is on the point before it. */
const SAME = 6;

/** Elements whose own Enter is another thing. */
const TAKES_ENTER = '#stage, button, summary, a';

/** Most points that a spec takes of one measure. */
const POINTS_MAX = 64;

const IN_POSE = 'Points are those of the garment as the file stands: choose the animation "As in the file" first.';

/**
 * The part of the page that edits a tech sheet's spec.
 * @param {object} options
 * @param {import('./client.mjs').Client} options.client
 * @param {import('./shot_state.mjs').ShotState} options.shots
 * @param {(error?: Error) => void} options.tell
 * @returns {Promise<Record<string, () => unknown>>} what single keys do
 */
export async function addSheet({ client, shots, tell }) {
  const about = await readSpec();
  const state = new SpecState(about);
  const sheet = new SheetPanel({ about, state, client, shots, tell });
  $('sheet').hidden = false;
  $('sheet-keys').hidden = false;
  return sheet.keys;
}

class SheetPanel {
  #about;
  #state;
  #client;
  #shots;
  #tell;
  #marks;
  #rows;
  #lengths;
  /** Points of a measure that is not ended yet, and whether the last came of a key. */
  #begun = [];
  #isByKey = false;
  #chosen = {};
  #isSaving = false;

  constructor({ about, state, client, shots, tell }) {
    this.#about = about;
    this.#state = state;
    this.#client = client;
    this.#shots = shots;
    this.#tell = tell;
    this.#lengths = new Lengths(() => this.#show());
    this.#marks = new Marks(
      [$('client-picture'), $('server-picture')],
      (point) => client.camera && client.project(point),
      (point) => client.hides(point),
    );
    this.#rows = Object.fromEntries(['callouts', 'measures'].map((list) => [list, new Rows($(list).tBodies[0], list, state, about)]));
    client.onDraw = () => this.#showMarks();
    addPicking($('stage'), (place, how) => this.#pick(place, how));
    state.addEventListener('change', () => this.#show());
    for (const radio of this.#tools) radio.addEventListener('change', () => this.#end('surface') || this.#useTool());
    for (const list of ['callouts', 'measures']) $(list).addEventListener('focusin', ({ target }) => this.#choose(list, target.closest('tr')?.dataset.index));
    $('undo').addEventListener('click', () => state.undo());
    $('redo').addEventListener('click', () => state.redo());
    $('save-spec').addEventListener('click', () => void this.#save());
    document.addEventListener('keydown', (event) => this.#onKey(event));
    addEventListener('beforeunload', (event) => state.isEdited && event.preventDefault());
    $('save-spec').textContent = `Save ${about.name}`;
    this.#useTool();
    this.#show();
  }

  get #tools() {
    return [...document.querySelectorAll('input[name=tool]')];
  }

  get #tool() {
    return this.#tools.find(({ checked }) => checked).value;
  }

  get keys() {
    const tools = this.#tools.map((radio) => [radio.dataset.key, () => radio.click()]);
    return {
      ...Object.fromEntries(tools),
      Enter: () => !document.activeElement.matches(TAKES_ENTER) && this.#end(),
      Escape: () => (this.#begun.length > 0 ? this.#drop() : this.#tools[0].click()),
    };
  }

  /** Undo and redo, but for typed text, which the browser undoes itself. */
  #onKey(event) {
    const { key, ctrlKey, metaKey, shiftKey, target } = event;
    if (!(ctrlKey || metaKey) || target.matches('textarea, input[type=text], input[type=number]')) return;
    const letter = key.toLowerCase();
    if (letter !== 'z' && letter !== 'y') return;
    event.preventDefault();
    if (letter === 'y' || shiftKey) this.#state.redo();
    else this.#state.undo();
  }

  #drop() {
    this.#begun = [];
    this.#useTool();
  }

  #useTool() {
    this.#begun = [];
    $('stage').dataset.tool = this.#tool;
    $('tool-hint').textContent = HINTS[this.#tool];
    this.#showMarks();
  }

  #choose(list, index) {
    if (this.#chosen.list === list && this.#chosen.index === Number(index)) return;
    this.#chosen = { list, index: Number(index) };
    this.#showMarks();
  }

  /** Makes the measure of the points so far. @returns {boolean} whether there were enough of them */
  #end(along = this.#tool) {
    const points = this.#begun;
    if (points.length < 2) return false;
    const view = nearestView(this.#about.views, this.#client.back);
    this.#useTool();
    this.#add('measures', { code: nextCode(this.#state.lists.measures), description: 'New measure', view, points, along }, 'description');
    return true;
  }

  /** Whether a place of the picture is that of the last point. */
  #isLast([x, y]) {
    const last = this.#begun.length > 0 && this.#client.project(this.#begun.at(-1));
    const { clientWidth: width, clientHeight: height } = $('client-picture').querySelector('.paper');
    return Boolean(last) && Math.hypot((x - last[0]) * width, (y - last[1]) * height) <= SAME;
  }

  #pick(place, { isByKey }) {
    const tool = this.#tool;
    // Enter ends what clicks have made, and what keys have made where the picture has not been turned since.
    const isEnd = this.#isLast(place) || (isByKey && this.#begun.length > 1 && !this.#isByKey);
    if (isEnd && tool === 'surface') return this.#end();
    if (tool === 'turn') return;
    if (this.#shots.resolved.pose) return this.#tell(new Error(IN_POSE));
    const found = this.#client.pick(place);
    if (!found) return this.#tell(new Error('There is no garment at this place.'));
    this.#tell();
    const point = rounded(found);
    const view = nearestView(this.#about.views, this.#client.back);
    if (tool === 'callout') return this.#add('callouts', { view, point, text: 'New call-out' }, 'text');
    this.#begun = [...this.#begun, point];
    this.#isByKey = isByKey;
    if (this.#begun.length === (tool === 'straight' ? 2 : POINTS_MAX)) return this.#end();
    $('tool-hint').textContent = this.#begun.length > 1 ? FURTHER : SECOND;
    return this.#showMarks();
  }

  #add(list, row, field) {
    this.#state.add(list, row);
    this.#rows[list].focus(this.#state.lists[list].length - 1, field);
  }

  #show() {
    const { callouts, measures } = this.#state.lists;
    this.#rows.callouts.show();
    this.#rows.measures.show((row) => this.#lengths.told(row));
    this.#lengths.want(measures);
    $('undo').disabled = !this.#state.canUndo;
    $('redo').disabled = !this.#state.canRedo;
    $('save-spec').disabled = this.#isSaving || !(this.#state.isEdited || this.#about.isNew);
    const counts = `${callouts.length} call-outs, ${measures.length} points of measure`;
    $('sheet-state').textContent = this.#about.isNew ? `${counts}; not in a file yet` : `${counts}${this.#state.isEdited ? '; not saved' : ''}`;
    $('sheet').dataset.saved = String(!this.#about.isNew && !this.#state.isEdited);
    this.#showMarks();
  }

  #showMarks() {
    if (!this.#client.camera) return;
    // Of another pose the points would lie beside the garment.
    this.#marks.show(
      this.#shots.resolved.pose
        ? []
        : [...this.#savedMarks(), ...(this.#begun.length > 0 ? [{ points: this.#begun, path: this.#begun, label: '', isChosen: true }] : [])],
    );
  }

  #savedMarks() {
    const { callouts, measures } = this.#state.lists;
    const isChosen = (list, index) => this.#chosen.list === list && this.#chosen.index === index;
    const placeOf = (point) => (typeof point === 'string' ? this.#about.anchors[point] : point);
    return [
      ...callouts.map(({ point }, i) => ({ points: point ? [point] : [], label: String(i + 1), isChosen: isChosen('callouts', i) })),
      ...measures.map((row, i) => {
        const { path, isLoop, text } = this.#lengths.known(row) ?? {};
        const points = (row.points ?? []).map(placeOf).filter(Boolean);
        return { points, path, isLoop, label: [row.code, text].filter(Boolean).join('  '), isChosen: isChosen('measures', i) };
      }),
    ];
  }

  async #save() {
    const { lists } = this.#state;
    this.#isSaving = true;
    this.#show();
    try {
      const { version } = await saveSpec({ version: this.#about.version, ...lists });
      this.#about = { ...this.#about, version, isNew: false };
      this.#tell();
    } catch (error) {
      this.#isSaving = false;
      this.#show();
      return this.#tell(error);
    }
    this.#isSaving = false;
    return this.#state.markSaved(lists);
  }
}
