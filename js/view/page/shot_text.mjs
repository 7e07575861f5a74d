/**
 * The shot as text, to read, to copy and to change.
 * @param {HTMLElement} root
 * @param {import('./shot_state.mjs').ShotState} state
 * @param {(act: () => void) => boolean} attempt runs what may be refused, and tells it; whether it went well
 */
export function bindShotText(root, state, attempt) {
  const text = root.querySelector('textarea');
  let isEdited = false;
  const show = () => {
    if (!isEdited) text.value = JSON.stringify(state.shot, null, 2);
  };
  text.addEventListener('input', () => {
    isEdited = true;
  });
  root.querySelector('#apply-shot').addEventListener('click', () => {
    const wasEdited = isEdited;
    isEdited = false;
    if (!attempt(() => state.replace(JSON.parse(text.value)))) isEdited = wasEdited;
  });
  root.querySelector('#copy-shot').addEventListener('click', () => {
    // A browser that keeps the clipboard to itself leaves the copying to the reader.
    navigator.clipboard.writeText(text.value).catch(() => text.select());
  });
  state.addEventListener('change', show);
  show();
}
