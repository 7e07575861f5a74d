import { CLOTHS } from '../../shot/table/cloths.mjs';
import { Client } from './client.mjs';
import { titled } from './text.mjs';

/** Shows parts of the model in another cloth: `materials` of the shot, one part at a time. */

const ALL = '*';
const OWN = '';

const option = ([value, text]) => Object.assign(document.createElement('option'), { value, textContent: text });
const without = (object, key) => Object.fromEntries(Object.entries(object).filter(([name]) => name !== key));

const labelOf = (preset) => (preset === OWN ? 'As in the file' : titled(preset).replaceAll('-', ' '));

/** In cloths.webp, as js/assets/make/cloth_pages.mjs writes it: pictures in the order of the table, so many in a row. */
const COLUMNS = 7;
const ROWS = Math.ceil(CLOTHS.length / COLUMNS);

/** A radio button that shows its cloth. */
function swatch(preset) {
  const input = Object.assign(document.createElement('input'), { type: 'radio', name: 'cloth', value: preset });
  input.setAttribute('aria-label', labelOf(preset));
  const picture = document.createElement('span');
  const at = CLOTHS.indexOf(preset);
  if (at < 0) picture.className = 'own';
  else picture.style.backgroundPosition = `${((at % COLUMNS) / (COLUMNS - 1)) * 100}% ${(Math.floor(at / COLUMNS) / (ROWS - 1)) * 100}%`;
  const label = Object.assign(document.createElement('label'), { title: labelOf(preset) });
  label.append(input, picture);
  return label;
}

/** Keys of a cloth that say something. */
const said = (cloth) => Object.fromEntries(Object.entries(cloth).filter(([, value]) => value !== undefined && value !== null));

/**
 * @param {HTMLFormElement} form
 * @param {import('./shot_state.mjs').ShotState} state
 * @param {import('../../shot/dressings.mjs').Names} names of the model
 * @param {(act: () => void) => void} attempt runs what may be refused, and tells it
 */
export function bindCloths(form, state, { materials }, attempt) {
  const swatches = form.querySelector('#cloths .swatches');
  swatches.replaceChildren(...[OWN, ...CLOTHS].map(swatch));
  const { part, cloth, clothColour, clothScale, clothRotation } = form.elements;
  const parts = [...new Set(materials)].filter((name) => name);
  part.replaceChildren(...[[ALL, 'All'], ...parts.map((name) => [name, name])].map(option));

  const chosen = () => state.shot.materials?.[part.value] ?? {};
  const show = () => {
    const { preset, scale = 1, rotation = 0 } = chosen();
    cloth.value = preset ?? OWN;
    form.querySelector('#cloth-name').value = labelOf(preset ?? OWN);
    const color = state.resolved.materials[part.value]?.color;
    if (color) clothColour.value = Client.hexOf(color);
    for (const [input, value] of [
      [clothScale, scale],
      [clothRotation, rotation],
    ]) {
      input.disabled = !preset;
      input.value = value;
      input.parentElement.querySelector('output').value = `${value}${input.parentElement.querySelector('output').dataset.unit ?? ''}`;
    }
  };
  const put = (changes) => {
    const next = said({ ...chosen(), ...changes });
    const rest = without(state.shot.materials ?? {}, part.value);
    const all = Object.keys(next).length > 0 ? { ...rest, [part.value]: next } : rest;
    attempt(() => state.change({ materials: Object.keys(all).length > 0 ? all : undefined }));
    show();
  };
  part.addEventListener('input', show);
  swatches.addEventListener('input', () =>
    put(cloth.value === OWN ? { preset: undefined, color: undefined, scale: undefined, rotation: undefined, metresPerUv: undefined } : { preset: cloth.value }),
  );
  clothColour.addEventListener('input', () => put({ color: clothColour.value }));
  clothScale.addEventListener('input', () => put({ scale: Number(clothScale.value) }));
  clothRotation.addEventListener('input', () => put({ rotation: Number(clothRotation.value) }));
  state.addEventListener('change', show);
  show();
}
