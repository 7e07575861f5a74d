/** Elements that take typed characters themselves. */
const TYPED_INTO = 'input:not([type=radio], [type=range], [type=checkbox]), textarea, select';

/**
 * Single keys that work anywhere on the page, unless the reader turned them off or is typing.
 * @param {Record<string, () => unknown>} actions by `event.key`; false = nothing to do, the browser may have the key
 * @param {HTMLInputElement} toggle
 */
export function bindShortcuts(actions, toggle) {
  document.addEventListener('keydown', (event) => {
    const { key, ctrlKey, metaKey, altKey, target, repeat } = event;
    if (!toggle.checked || repeat || ctrlKey || metaKey || altKey || !Object.hasOwn(actions, key)) return;
    if (target.matches(TYPED_INTO) || target.closest('dialog')) return;
    if (key === ' ' && target.matches('button, summary, a, input')) return;
    if (actions[key]() !== false) event.preventDefault();
  });
}
