/** Pixels of the screen that a hand may move during a click. */
const STILL = 4;

const MAIN_BUTTON = 0;

/**
 * Clicks on the pictures, as parts of their width and height from the top left corner. A drag is none: it turns the camera.
 * @param {HTMLElement} stage
 * @param {(place: number[], how: {isByKey: boolean}) => void} onPick
 */
export function addPicking(stage, onPick) {
  let pressed;
  stage.addEventListener('pointerdown', ({ target, button, isPrimary, clientX, clientY }) => {
    const canvas = target.closest('.paper')?.querySelector('canvas');
    pressed = canvas && isPrimary && button === MAIN_BUTTON ? { canvas, clientX, clientY } : undefined;
  });
  // The controls of the camera capture the pointer: its target is the stage by now.
  stage.addEventListener('pointerup', ({ clientX, clientY }) => {
    if (!pressed) return;
    const { canvas, clientX: x, clientY: y } = pressed;
    pressed = undefined;
    if (Math.hypot(clientX - x, clientY - y) > STILL) return;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    onPick([(clientX - left) / width, (clientY - top) / height], { isByKey: false });
  });
  // By keys: what stands in the middle of the picture.
  stage.addEventListener('keydown', (event) => {
    if (event.target !== stage || event.key !== 'Enter') return;
    event.preventDefault();
    onPick([0.5, 0.5], { isByKey: true });
  });
}
