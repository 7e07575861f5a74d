import { CHARACTERS } from '../shot/table/rows.mjs';
import { NAME_MAX } from './table/basics.mjs';

/** Names that files have, as a spec may hold them: what a file calls its parts may be of any length, and of several lines. */

const CONTROL = /[\u0000-\u001f\u007f]+/g;
/** Halves of characters, which no UTF-8 holds. */
const HALVES = /[\ud800-\udfff]/gu;

const cut = (text, most) =>
  text.length > most
    ? `${text
        .slice(0, most - 1)
        .replace(HALVES, '')
        .trimEnd()}…`
    : text;

/** A name of at most so many characters on one line. */
export const oneLine = (text = '', most = NAME_MAX) => cut(text.replace(HALVES, '').replace(CONTROL, ' ').trim(), most);

/** Whether a spec may hold a name as it is. */
export const isName = (text) => text.length <= NAME_MAX && CHARACTERS.test(text);

/** The name, with a number behind it where others have it. @param {string} name @param {Set<string>} taken gets what is returned */
export function unlike(name, taken) {
  let own = name;
  for (let number = 2; taken.has(own); ++number) own = `${cut(name, NAME_MAX - ` ${number}`.length)} ${number}`;
  taken.add(own);
  return own;
}
