/** The rows in which call-outs and points of measure are edited. */

const make = (name, properties = {}, ...children) => {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
};

const options = (pairs) => pairs.map(([value, text]) => make('option', { value, textContent: text }));

/** A number as typed; undefined where nothing is, NaN (which the server refuses by name) where it is none. */
const numberOf = (text) => (text.trim() === '' ? undefined : Number(text));

const SIDES = [
  ['', 'Best side'],
  ['left', 'Left'],
  ['right', 'Right'],
];

const WAYS = [
  ['straight', 'Straight'],
  ['surface', 'Along the cloth'],
];

/** Fields of each list: how a control reads a row, and which keys of the row it sets. */
function fieldsOf({ views, baseSize, units }) {
  const seen = options(views.map(({ name }) => [name, name]));
  const view = {
    label: 'View',
    control: () => make('select', {}, ...seen.map((node) => node.cloneNode(true))),
    read: (row) => row.view ?? views[0].name,
    keys: (value) => ({ view: value }),
  };
  const number = (label, read, keys) => ({ label, control: () => make('input', { type: 'number', step: 'any' }), read: (row) => read(row) ?? '', keys });
  return {
    callouts: {
      text: {
        label: 'Text',
        control: () => make('textarea', { rows: 1 }),
        read: ({ text }) => text,
        keys: (text) => ({ text }),
      },
      side: {
        label: 'Side',
        control: () => make('select', {}, ...options(SIDES)),
        read: ({ side }) => side ?? '',
        keys: (side) => ({ side: side === '' ? undefined : side }),
      },
      view,
    },
    measures: {
      code: { label: 'Code', control: () => make('input', { type: 'text' }), read: ({ code }) => code, keys: (code) => ({ code }) },
      description: {
        label: 'Description',
        control: () => make('input', { type: 'text' }),
        read: ({ description }) => description,
        keys: (description) => ({ description }),
      },
      along: {
        label: 'Way',
        control: () => make('select', {}, ...options(WAYS)),
        read: ({ points, along }) => (points ? (along ?? 'straight') : undefined),
        keys: (along) => ({ along }),
      },
      tolerance: number(
        `Tolerance, ${units}`,
        ({ tolerance }) => tolerance,
        (text) => ({ tolerance: numberOf(text) }),
      ),
      ...(baseSize && {
        value: number(
          `${baseSize}, ${units}`,
          ({ values }) => values?.[baseSize],
          (text, { values = {} }) => {
            const { [baseSize]: _old, ...rest } = values;
            const value = numberOf(text);
            return { values: value === undefined ? rest : { ...values, [baseSize]: value } };
          },
        ),
      }),
      view,
    },
  };
}

/** One list of rows; they follow the state. */
export class Rows {
  #body;
  #list;
  #state;
  #fields;
  /** Controls whose text is not the state's yet. */
  #typed = new Set();

  /**
   * @param {HTMLTableSectionElement} body
   * @param {'callouts' | 'measures'} list
   * @param {import('./spec_state.mjs').SpecState} state
   * @param {object} about views, baseSize and units of the spec
   */
  constructor(body, list, state, about) {
    this.#body = body;
    this.#list = list;
    this.#state = state;
    this.#fields = fieldsOf(about)[list];
    const titles = [
      list === 'callouts' ? '#' : undefined,
      ...Object.values(this.#fields).map(({ label }) => label),
      list === 'measures' ? 'Measured' : undefined,
      '',
    ];
    const heads = titles.filter((title) => title !== undefined).map((title) => make('th', { scope: 'col', textContent: title }));
    body.parentElement.querySelector('thead').replaceChildren(make('tr', {}, ...heads));
  }

  /** @param {(row: object, index: number) => {text?: string, isWrong?: boolean}} [measuredOf] what is known of a row's length */
  show(measuredOf) {
    const rows = this.#state.lists[this.#list];
    while (this.#body.rows.length > rows.length) this.#body.rows[rows.length].remove();
    while (this.#body.rows.length < rows.length) this.#body.append(this.#row(this.#body.rows.length));
    rows.forEach((row, i) => this.#fill(this.#body.rows[i], row, measuredOf?.(row, i)));
    this.#body.closest('table').hidden = rows.length === 0;
  }

  /** Puts the focus where a new row is named. */
  focus(index, field) {
    const control = this.#body.rows[index].querySelector(`[data-field=${field}]`);
    control.focus();
    control.select();
  }

  #row(index) {
    const what = this.#list === 'callouts' ? 'call-out' : 'point of measure';
    const cells = Object.entries(this.#fields).map(([name, { label, control: made, keys }]) => {
      const control = made();
      control.dataset.field = name;
      control.setAttribute('aria-label', `${label} of ${what} ${index + 1}`);
      control.addEventListener('input', () => this.#typed.add(control));
      control.addEventListener('blur', () => this.#typed.delete(control));
      control.addEventListener('change', () => this.#typed.delete(control));
      control.addEventListener('change', () => this.#state.edit(this.#list, index, keys(control.value, this.#state.lists[this.#list][index])));
      return make('td', {}, control);
    });
    const remove = make('button', { type: 'button', textContent: 'Delete' });
    remove.setAttribute('aria-label', `Delete ${what} ${index + 1}`);
    remove.addEventListener('click', () => this.#state.remove(this.#list, index));
    const number = this.#list === 'callouts' ? [make('th', { scope: 'row', textContent: String(index + 1) })] : [];
    const length = this.#list === 'measures' ? [make('td', {}, make('output'))] : [];
    const row = make('tr', {}, ...number, ...cells, ...length, make('td', {}, remove));
    row.dataset.index = index;
    return row;
  }

  #fill(node, row, measured) {
    for (const control of node.querySelectorAll('[data-field]')) {
      const value = this.#fields[control.dataset.field].read(row);
      control.disabled = value === undefined;
      // Text that is being typed is its writer's: a length that comes meanwhile must not take it away.
      if (value !== undefined && !this.#typed.has(control) && control.value !== String(value)) control.value = value;
    }
    const output = node.querySelector('output');
    if (!output) return;
    output.textContent = measured?.text ?? '';
    output.classList.toggle('wrong', measured?.isWrong === true);
  }
}
