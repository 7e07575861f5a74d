// Includes and comments of shader text, before three.js compiles it.

const INCLUDE = /^#include "([^"]+)"$/;
const CONDITION = /^\s*#\s*(?:el)?if\s+(.*)$/;
const NAME = /\b[A-Za-z_]\w*\b/g;

/**
 * Text with its includes, each file once, as renderer/shader does it.
 * @param {string} text
 * @param {(file: string) => string} read - Text of a file beneath shaders/; '' for one to leave out.
 * @param {Set<string>} [done] - Files that were included.
 */
export function included(text, read, done = new Set()) {
  return text
    .split('\n')
    .map((line) => {
      const file = INCLUDE.exec(line)?.[1];
      if (!file) return line;
      if (done.has(file)) return '';
      done.add(file);
      return included(read(file), read, done);
    })
    .join('\n');
}

/** Without comments and empty lines. */
export function withoutComments(text) {
  return text
    .replace(/\/\*[\s\S]*?\*\//g, '')
    .split('\n')
    .map((line) => line.replace(/\s*\/\/.*$/, '').trimEnd())
    .filter(Boolean)
    .join('\n');
}

/** Names in the conditions of a text that have to have a value: also of those that have a name of their own. */
export function conditionNames(text) {
  const names = new Set();
  for (const line of text.split('\n')) {
    const condition = CONDITION.exec(line)?.[1] ?? /^#define \w+ (\(.*(?:\|\||\+).*\))$/.exec(line)?.[1];
    for (const name of condition?.replaceAll(/defined\s*\(\s*\w+\s*\)/g, '').match(NAME) ?? []) names.add(name);
  }
  return names;
}
