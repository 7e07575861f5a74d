import { readFileSync } from 'node:fs';
import { TelarError } from '../error/index.mjs';
import { ABOUT } from './read.mjs';

/** Headings by language. */

const read = (language) => JSON.parse(readFileSync(new URL(`strings/${language}.json`, import.meta.url), 'utf8'));

/** Languages that telar knows. */
export const LANGUAGES = Object.freeze(['en', 'es']);

/**
 * The headings of a spec's language: its own words but empty ones, those of the language, those of English.
 * @param {{language: string, words: Record<string, string>}} spec
 * @returns {(key: string, values?: Record<string, string>) => string}
 * @throws {TelarError} E_SPEC
 */
export function wordsOf({ language, words }) {
  const [base] = language.split('-');
  const english = read('en');
  const unknown = Object.keys(words).find((key) => !Object.hasOwn(english, key));
  if (unknown !== undefined)
    throw new TelarError(ABOUT.code, `spec.words: there is no heading ${JSON.stringify(unknown.slice(0, 60))}; js/sheet/strings/en.json lists them`, {
      pointer: '/words',
    });
  if (!LANGUAGES.includes(base) && Object.keys(words).length === 0)
    throw new TelarError(
      ABOUT.code,
      `spec.language: expected ${LANGUAGES.map((name) => `"${name}"`).join(', ')}, or another with its headings in spec.words, got "${language}"`,
      { pointer: '/language' },
    );
  const known = { ...english, ...(LANGUAGES.includes(base) && read(base)) };
  const filled = (text, values) => text.replaceAll(/\{(\w+)\}/g, (_, name) => (Object.hasOwn(values, name) ? (values[name] ?? '') : ''));
  // A heading or the text of a picture is never empty: a PDF/UA has none.
  return (key, values = {}) => filled(words[key] ?? '', values) || filled(known[key], values);
}
