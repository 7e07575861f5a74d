// A file is included once, where it is first named. Under a condition there, its text is missing wherever else it is named and the
// condition does not hold, and only scenes that do not meet the condition show it.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const SHADERS = fileURLToPath(new URL('../../../shaders/', import.meta.url));

/** Text of a file; '' of one that CMake writes, which includes nothing. */
const textOf = (file) => (existsSync(path.join(SHADERS, file)) ? readFileSync(path.join(SHADERS, file), 'utf8') : '');

/**
 * Files that are named under fewer conditions than where their text stands.
 * @param {string} stage - Path from shaders/.
 * @param {(file: string) => string} read
 * @returns {string[]} "FILE names INCLUDED, which stands under CONDITION"
 */
function missing(stage, read = textOf) {
  const [conditions, stands, found] = [[], new Map(), []];
  const follow = (file) => {
    for (const line of read(file).split('\n')) {
      if (/^#\s*if/.test(line)) conditions.push(line);
      else if (/^#\s*el/.test(line)) conditions.push(`${line} of ${conditions.pop()}`);
      else if (/^#\s*endif/.test(line)) conditions.pop();
      const [, included] = /^#include "(.*)"/.exec(line) ?? [];
      if (!included) continue;
      if (!stands.has(included)) {
        stands.set(included, [...conditions]);
        follow(included);
        continue;
      }
      const lacking = stands.get(included).find((condition) => !conditions.includes(condition));
      if (lacking) found.push(`${file} names ${included}, which stands under ${lacking}`);
    }
  };
  follow(stage);
  return found;
}

test('no file is included under a condition that another one that names it does not have', () => {
  const stages = readdirSync(SHADERS, { recursive: true }).filter((file) => /\.(vert|frag)$/.test(file));
  assert.ok(stages.length > 10);
  for (const stage of stages) assert.deepEqual(missing(stage), [], stage);
});

test('one that is, is found', () => {
  const files = {
    'a.vert': '#if TANGENT\n#include "terms.glsl"\n#endif\n#include "coords.glsl"\n',
    'b.vert': '#include "terms.glsl"\n#include "coords.glsl"\n',
    'coords.glsl': '#include "terms.glsl"\n',
    'terms.glsl': '#define A 0\n',
  };
  const read = (file) => files[file];
  assert.deepEqual(missing('a.vert', read), ['coords.glsl names terms.glsl, which stands under #if TANGENT']);
  assert.deepEqual(missing('b.vert', read), []);
});
