import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { GROUPS, OTHERS, REST, TITLES } from './contents.mjs';

// The Markdown of the repository as pages of the site: the same text, with links that lead to where things are there.

const DOCS = 'js/docs';
const PICTURE = /\.(png|jpe?g|svg|webp)$/;
/** Files that a page offers; what else it names, as a source, is text. */
const OFFERED = /\.(json|csv|mjs|yaml|txt)$/;

/** Files of a repository that become pages, by the page. @param {string} root @returns {Map<string, string>} */
export function pagesOf(root) {
  const own = readdirSync(path.join(root, DOCS), { recursive: true }).filter((file) => file.endsWith('.md'));
  return new Map([...own.map((file) => [`${DOCS}/${file}`, file]), ...Object.entries(OTHERS).filter(([file]) => existsSync(path.join(root, file)))]);
}

/**
 * A page's text with links that lead to the site's pages, pictures and files.
 * @param {string} text
 * @param {string} file - Of the repository
 * @param {Map<string, string>} pages
 * @param {(file: string) => boolean} exists
 * @param {(page: string) => string} titleOf - What a link says that says the name of a file
 * @returns {{text: string, copied: string[]}} copied: pictures and files that it names
 * @throws {Error} For a link to a file that is not there.
 */
export function withSiteLinks(text, file, pages, exists, titleOf = (page) => page) {
  const copied = [];
  const here = path.dirname(pages.get(file));
  const led = text.replace(/(!?)\[((?:[^\]\\]|\\.)*)\]\((?!https?:|mailto:|#)([^)#\s]+)(#[^)\s]*)?\)/g, (_, mark, words, target, part = '') => {
    const named = path.posix.normalize(path.posix.join(path.posix.dirname(file), target));
    if (!exists(named)) throw new Error(`${file}: ${target} is not there`);
    const page = pages.get(named);
    if (page) return `[${named.endsWith(words.replace(/^(\.\.\/)+/, '')) ? titleOf(page) : words}](${path.posix.relative(here, page)}${part})`;
    if (PICTURE.test(named) || (OFFERED.test(named) && named.startsWith(DOCS))) {
      copied.push(named);
      const place = `${path.posix.relative(here, '.') || '.'}/files/${named}`;
      return mark ? `![${words}](${place})` : `<a href="${place}" target="_self">${words.replaceAll('`', '')}</a>`;
    }
    return /^`.*`$/.test(words) ? words : `${words} (\`${named}\`)`;
  });
  return { text: led, copied };
}

/** Numbers in tables stay beside their units. */
export const unbroken = (text) => text.replace(/^\|.*$/gm, (line) => line.replace(/(\d) (?=(?:ms|s|min|MB|[KMG]iB|px|mm|%)(?![\w]))/g, '$1\u00a0'));

/** Its first heading. */
const headingOf = (text, fallback) => /^# (.+)$/m.exec(text)?.[1].replaceAll('`', '') ?? fallback;

/** The side bar of VitePress. @param {Map<string, string>} titles - By page, without its ending */
export function sidebarOf(titles) {
  const item = (page) => ({ text: titles.get(page), link: `/${page}` });
  const inFolder = (folder) => [...titles.keys()].filter((page) => page.startsWith(`${folder}/`)).sort();
  const groups = GROUPS.map(({ text, pages, folder }) => ({
    text,
    pages: [...(pages ?? []), ...(folder ? inFolder(folder) : [])].filter((page) => titles.has(page)),
  }));
  const named = new Set(groups.flatMap(({ pages }) => pages));
  const rest = [...titles.keys()].filter((page) => !named.has(page)).sort();
  return [...groups, { text: REST, pages: rest }]
    .filter(({ pages }) => pages.length)
    .map(({ text, pages }) => ({ text, collapsed: false, items: pages.map(item) }));
}

/**
 * Writes the pages, pictures and files.
 * @param {string} root - Of the repository
 * @param {string} out - Is emptied by the caller
 * @returns {object[]} The side bar.
 */
export function writePages(root, out) {
  const pages = pagesOf(root);
  const read = (file) => readFileSync(path.join(root, file), 'utf8');
  const headings = new Map([...pages].map(([file, page]) => [page, headingOf(read(file), page)]));
  const put = (name, write) => {
    const file = path.join(out, name);
    mkdirSync(path.dirname(file), { recursive: true });
    write(file);
  };
  for (const [file, page] of pages) {
    const { text, copied } = withSiteLinks(
      read(file),
      file,
      pages,
      (name) => existsSync(path.join(root, name)),
      (to) => headings.get(to),
    );
    put(page, (to) => writeFileSync(to, unbroken(text)));
    for (const name of copied) put(`${PICTURE.test(name) ? 'files' : 'public/files'}/${name}`, (to) => copyFileSync(path.join(root, name), to));
  }
  const peers = /<!-- peers -->\n([\s\S]*?)<!-- end -->/.exec(read('README.md'))?.[1] ?? '';
  const home = readFileSync(new URL('./home.md', import.meta.url), 'utf8').replace('<!-- peers -->', peers);
  for (const [, name] of home.matchAll(/\/files\/(js\/[\w./-]+)/g)) put(`public/files/${name}`, (to) => copyFileSync(path.join(root, name), to));
  put('index.md', (to) => writeFileSync(to, home));
  const names = [...headings].map(([page, heading]) => [page.replace(/\.md$/, ''), heading]);
  return sidebarOf(new Map(names.map(([page, heading]) => [page, TITLES[page] ?? heading])));
}
