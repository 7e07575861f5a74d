import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { PerspectiveCamera } from 'three';
import { fromControls, orbited } from './camera_edit.mjs';

/** Degrees and factor of one key press. */
const TURN = 5;
const ZOOM = 1.1;

const KEYS = {
  ArrowLeft: { turn: -TURN },
  ArrowRight: { turn: TURN },
  ArrowUp: { tilt: TURN },
  ArrowDown: { tilt: -TURN },
  '+': { zoom: ZOOM },
  '=': { zoom: ZOOM },
  '-': { zoom: 1 / ZOOM },
};

/**
 * Moves the shot's camera by pointer and keys.
 * @param {HTMLElement} element what is dragged and focused
 * @param {import('./shot_state.mjs').ShotState} state
 * @param {() => object} cameraOf three's camera as it was drawn last
 * @param {(act: () => void) => void} attempt runs what may be refused, and tells it
 */
export function addOrbit(element, state, cameraOf, attempt) {
  // Upright from the start: the controls take the axis that they turn about from their first camera.
  const controls = new OrbitControls(new PerspectiveCamera(), element);
  let begun;
  controls.addEventListener('start', () => {
    controls.object = cameraOf().clone();
    controls.object.up.set(0, 1, 0);
    controls.target.fromArray(state.resolved.camera.target);
    // The zoom of an orthographic camera counts from the height that the drag began with.
    begun = state.resolved.camera;
  });
  controls.addEventListener('end', () => {
    begun = undefined;
  });
  controls.addEventListener('change', () => {
    if (!begun) return;
    const {
      object: { position, zoom },
      target,
    } = controls;
    attempt(() => state.change({ camera: fromControls(begun, { position, target, zoom }) }));
  });
  element.addEventListener('keydown', (event) => {
    if (event.target !== element || event.ctrlKey || event.metaKey || event.altKey || !KEYS[event.key]) return;
    event.preventDefault();
    attempt(() => state.change({ camera: orbited(state.resolved.camera, KEYS[event.key]) }));
  });
}
