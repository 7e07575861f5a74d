import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';

// Every link of a built site, to a page, a file or a heading, leads somewhere.

const unescaped = (text) => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"').replaceAll('&#39;', "'");

/** Ids of a page. */
const idsOf = (html) => new Set([...html.matchAll(/\sid="([^"]+)"/g)].map(([, id]) => unescaped(id)));

/**
 * @param {string} folder - Of HTML
 * @param {string} [base] - Where the site lies on its host
 * @returns {string[]} `page: link` of those that lead nowhere.
 */
export function deadLinks(folder, base = '/') {
  const files = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith('.html'));
  const html = new Map(files.map((file) => [file, readFileSync(path.join(folder, file), 'utf8')]));
  const ids = new Map();
  const idsIn = (file) => ids.get(file) ?? ids.set(file, idsOf(html.get(file))).get(file);
  const fileOf = (at) =>
    [at, `${at}.html`, path.join(at, 'index.html')].find((name) => existsSync(path.join(folder, name)) && statSync(path.join(folder, name)).isFile());
  const dead = [];
  for (const [page, text] of html) {
    for (const [, raw] of text.matchAll(/\s(?:href|src)="([^"]*)"/g)) {
      const link = unescaped(raw);
      if (/^(https?:|mailto:|data:|\/\/)/.test(link) || link === '') continue;
      const [, target, fragment] = /^([^?#]*)(?:\?[^#]*)?(?:#(.*))?$/.exec(link);
      const at = target === '' ? page : target.startsWith('/') ? path.join('.', target.slice(base.length)) : path.join(path.dirname(page), target);
      const file = fileOf(decodeURIComponent(at));
      const isThere = file && (!fragment || !file.endsWith('.html') || idsIn(file).has(decodeURIComponent(fragment)));
      if (!isThere) dead.push(`${page}: ${link}`);
    }
  }
  return [...new Set(dead)];
}
