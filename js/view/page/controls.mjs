import { withFit, withFovY, withModelCamera, withProjection } from './camera_edit.mjs';
import { choicesOf, defaultOf, hasKey } from './choices.mjs';
import { Client } from './client.mjs';
import { titled } from './text.mjs';
import { REVISION } from '../../shot/three_terms.mjs';

const COLOUR = 'colour';
const FRAMED = '';

/** What a background may be beside a colour. */
const ENVIRONMENT = 'environment';
const BACKGROUNDS = ['transparent', ENVIRONMENT];

/** What lies beneath the model. */
const NO_GROUND = 'none';
const SHADOW = 'shadow';

/** What "three" means beside this page's three.js: its release. */
const revision = Number.parseInt(Client.revision, 10);
const STOCK = revision === REVISION ? 'three' : { base: 'three', revision };

/** How each control reads the state, and what it changes of the shot. Names are those of the form's elements. */
const BINDINGS = {
  modelCamera: {
    read: ({ shot }) => String(shot.camera?.gltf ?? FRAMED),
    change: (value) => ({ camera: value === FRAMED ? undefined : withModelCamera(Number(value)) }),
  },
  projection: {
    read: ({ resolved }) => resolved.camera.projection,
    change: (value, { shot, resolved }) => ({ camera: withProjection(shot.camera, resolved.camera, value) }),
  },
  fovY: {
    read: ({ resolved }) => resolved.camera.fovY,
    change: (value, { shot, resolved }) => ({ camera: withFovY(shot.camera, resolved.camera, Number(value)) }),
  },
  fit: {
    read: ({ shot }) => (shot.camera?.position || shot.camera?.gltf !== undefined ? undefined : (shot.camera?.fit ?? defaultOf('camera.fit'))),
    change: (value, { shot }) => ({ camera: withFit(shot.camera, Number(value)) }),
  },
  variant: { read: ({ resolved }) => resolved.variant, change: (variant) => ({ variant }) },
  animation: {
    read: ({ resolved }) => String(resolved.pose?.animation ?? ''),
    change: (value) => ({ pose: value === '' ? undefined : { animation: Number(value) } }),
  },
  time: {
    read: ({ resolved }) => resolved.pose?.time,
    change: (value, { resolved }) => ({ pose: { ...resolved.pose, time: Number(value) } }),
  },
  shading: { read: ({ resolved: { shading } }) => shading.base ?? shading, change: (shading) => ({ shading: shading === 'three' ? STOCK : shading }) },
  toneMapping: { read: ({ resolved }) => resolved.toneMapping, change: (toneMapping) => ({ toneMapping }) },
  exposure: { read: ({ resolved }) => resolved.exposure, change: (value) => ({ exposure: Number(value) }) },
  environment: {
    read: ({ resolved }) => resolved.environment.map,
    change: (map, { resolved }) => ({ environment: { ...resolved.environment, map } }),
  },
  intensity: {
    read: ({ resolved }) => resolved.environment.intensity,
    change: (value, { resolved }) => ({ environment: { ...resolved.environment, intensity: Number(value) } }),
  },
  rotation: {
    read: ({ resolved }) => resolved.environment.rotation,
    change: (value, { resolved }) => ({ environment: { ...resolved.environment, rotation: Number(value) } }),
  },
  background: {
    read: ({ resolved: { background } }) => (Array.isArray(background) ? COLOUR : (background.type ?? background)),
    change: (value, _state, form) => ({ background: value === COLOUR ? form.elements.backgroundColour.value : value }),
  },
  blur: {
    read: ({ resolved: { background } }) => (background === ENVIRONMENT ? defaultOf('background.blur') : background.blur),
    change: (value) => ({ background: { type: ENVIRONMENT, blur: Number(value) } }),
  },
  ground: {
    read: ({ resolved }) => (resolved.ground === NO_GROUND ? NO_GROUND : SHADOW),
    change: (value) => ({ ground: value === NO_GROUND ? NO_GROUND : {} }),
  },
  opacity: {
    read: ({ resolved }) => resolved.ground.opacity,
    change: (value, { shot }) => ({ ground: { ...shot.ground, opacity: Number(value) } }),
  },
  backgroundColour: {
    read: ({ resolved }) => (Array.isArray(resolved.background) ? Client.hexOf(resolved.background) : undefined),
    change: (background) => ({ background }),
  },
  width: { read: ({ resolved }) => resolved.size.width, change: (value, { resolved }) => ({ size: { ...resolved.size, width: Number(value) } }) },
  height: { read: ({ resolved }) => resolved.size.height, change: (value, { resolved }) => ({ size: { ...resolved.size, height: Number(value) } }) },
  quality: { read: ({ resolved }) => resolved.quality.preset ?? '', change: (quality) => ({ quality }) },
};

/** Controls whose every keystroke is not a value yet. */
const ON_CHANGE = ['width', 'height'];

const option = ([value, text]) => Object.assign(document.createElement('option'), { value, textContent: text });
const asOptions = (names) => names.map((name) => [name, titled(name)]);

/**
 * The form beside the pictures.
 * @param {HTMLFormElement} form
 * @param {import('./shot_state.mjs').ShotState} state
 * @param {object} known
 * @param {{map: string}[]} known.environments
 * @param {object[]} known.cameras of the model
 * @param {string[]} known.variants of the model
 * @param {{name: string, duration: number}[]} known.animations
 * @param {(act: () => void) => void} attempt runs what may be refused, and tells it
 */
export function bindControls(form, state, { environments, cameras, variants, animations }, attempt) {
  const { elements } = form;
  const fill = (name, options) => elements[name].replaceChildren(...options.map(option));
  fill('modelCamera', [[FRAMED, 'Free'], ...cameras.map(({ name }, i) => [String(i), name || `Camera ${i}`])]);
  fill('projection', asOptions(choicesOf('camera.projection')));
  fill('variant', [['', 'As in the file'], ...variants.map((name) => [name, name])]);
  fill('animation', [['', 'As in the file'], ...animations.map(({ name }, i) => [String(i), name || `Animation ${i}`])]);
  fill('shading', asOptions(choicesOf('shading')));
  fill('toneMapping', asOptions(choicesOf('toneMapping')));
  fill(
    'environment',
    environments.map(({ map }) => [map, titled(map)]),
  );
  fill('background', [...asOptions(BACKGROUNDS), [COLOUR, 'Colour']]);
  fill('ground', asOptions([NO_GROUND, SHADOW]));
  fill('quality', asOptions(choicesOf('quality')));
  const rows = { modelCamera: cameras.length > 0, variant: variants.length > 0, animation: animations.length > 0 && hasKey('pose') };
  for (const [name, isShown] of Object.entries({ ...rows, time: rows.animation })) elements[name].closest('.row').hidden = !isShown;
  form.querySelector('#model-controls').hidden = !rows.variant && !rows.animation;

  const show = () => {
    // Before its value, which the range would cut.
    elements.time.max = animations[state.resolved.pose?.animation]?.duration ?? 0;
    for (const [name, { read }] of Object.entries(BINDINGS)) showValue(elements[name], read(state));
  };
  const onInput = ({ type, target }) => {
    if (!BINDINGS[target.name] || (type === 'change') !== ON_CHANGE.includes(target.name)) return;
    attempt(() => state.change(BINDINGS[target.name].change(target.value, state, form)));
    show();
  };
  form.addEventListener('input', onInput);
  form.addEventListener('change', onInput);
  form.addEventListener('submit', (event) => event.preventDefault());
  state.addEventListener('change', show);
  show();
}

/** A control without a value has nothing to change: an orthographic camera has no field of view. */
function showValue(control, value) {
  control.disabled = value === undefined;
  const isTypedInto = control.type === 'number' && document.activeElement === control;
  if (value !== undefined && !isTypedInto) control.value = value;
  const output = control.parentElement.querySelector('output');
  if (output) output.value = value === undefined ? '' : `${Number(Number(value).toFixed(2))}${output.dataset.unit ?? ''}`;
}
