import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';

// The pages of js/docs/recipes show files that lie beside them and that test/js/docs/recipes.test.mjs runs.

const FOLDER = 'js/docs/recipes';
const root = new URL('../../../', import.meta.url);
const read = (name) => readFileSync(new URL(`${FOLDER}/${name}`, root), 'utf8');
const LANGUAGES = { '.mjs': 'js', '.sh': 'bash', '.yaml': 'yaml' };

/** A page with the code of each file that it names. @param {string} page @param {(name: string) => string} textOf */
export const withCode = (page, textOf) =>
  page.replace(/(<!-- code: (\S+) -->\n)[\s\S]*?(<!-- end of code -->)/g, (_, begin, name, end) => {
    return `${begin}\n\`\`\`${LANGUAGES[path.extname(name)]}\n${textOf(name)}\`\`\`\n\n${end}`;
  });

/** @returns {Record<string, string>} path from the root: text */
export const recipePages = () =>
  Object.fromEntries(
    readdirSync(new URL(FOLDER, root))
      .filter((name) => name.endsWith('.md'))
      .map((name) => [`${FOLDER}/${name}`, withCode(read(name), read)]),
  );
