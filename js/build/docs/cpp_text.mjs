/** Pieces of generated C++ and GLSL. */

/** "three-quarter" as ThreeQuarter, "baseColor" as BaseColor. */
export const camel = (name) =>
  name
    .split('-')
    .map((part) => part[0].toUpperCase() + part.slice(1))
    .join('');

/** "three-quarter" as THREE_QUARTER, "baseColor" as BASE_COLOR. */
export const upper = (name) =>
  name
    .replaceAll(/(?<=[a-z\d])(?=[A-Z])/g, '_')
    .replaceAll('-', '_')
    .toUpperCase();

export const indented = (lines) => lines.map((line) => (line ? `  ${line}` : line));

const WIDTH = 110;

/** A comment of as many lines as it needs. */
export function commentLines(text) {
  const lines = [''];
  for (const word of text.split(' ')) {
    if (lines.at(-1).length + word.length > WIDTH) lines.push('');
    lines.push(`${lines.pop()} ${word}`);
  }
  return lines.map((line) => `///${line}`);
}
