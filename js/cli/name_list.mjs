import { TelarError } from '../error/index.mjs';

/** "a, b" as the names in it, each once; may be empty. @param {string} text */
export const namesIn = (text) => [
  ...new Set(
    text
      .split(',')
      .map((name) => name.trim())
      .filter(Boolean),
  ),
];

/**
 * What an option lists.
 * @param {string} option its name, without dashes
 * @param {string | undefined} text
 * @param {string[]} fallback where it is not given
 * @returns {string[]} not empty, but for the fallback
 * @throws {TelarError} E_USAGE
 */
export function namesOf(option, text, fallback) {
  if (text === undefined) return fallback;
  const names = namesIn(text);
  if (names.length === 0) throw new TelarError('E_USAGE', `--${option}: expected names with commas between`);
  return names;
}
