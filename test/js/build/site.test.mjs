import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { GROUPS, OTHERS } from '../../../js/build/site/contents.mjs';
import { deadLinks } from '../../../js/build/site/links.mjs';
import { pagesOf, sidebarOf, unbroken, withSiteLinks, writePages } from '../../../js/build/site/pages.mjs';

// What makes the site of the Markdown, but for VitePress and TypeDoc, which `npm run site` installs.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const PAGES = new Map([...Object.entries(OTHERS), ['js/docs/options.md', 'options.md'], ['js/docs/recipes/s3.md', 'recipes/s3.md']]);
const led = (text, file = 'js/docs/options.md', exists = () => true) => withSiteLinks(text, file, PAGES, exists, () => 'The shot');

function folderFor(t) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-site-'));
  t.after(() => rmSync(folder, { recursive: true }));
  return folder;
}

test('links lead to pages, pictures and files of the site; sources are text', () => {
  assert.equal(led('[SECURITY.md](../../SECURITY.md#limits)').text, '[The shot](security.md#limits)');
  assert.equal(led('[the shot](js/docs/options.md)', 'README.md').text, '[the shot](options.md)');
  assert.equal(led('[it](../options.md)', 'js/docs/recipes/s3.md').text, '[it](../options.md)');
  assert.deepEqual(led('![a shirt](../assets/a.jpg)'), { text: '![a shirt](./files/js/assets/a.jpg)', copied: ['js/assets/a.jpg'] });
  assert.equal(led('![a](../../assets/a.jpg)', 'js/docs/recipes/s3.md').text, '![a](../files/js/assets/a.jpg)');
  const offered = { text: '<a href="./files/js/docs/sheet/skirt.json" target="_self">a spec</a>', copied: ['js/docs/sheet/skirt.json'] };
  assert.deepEqual(led('[a spec](sheet/skirt.json)'), offered, 'relative: the site may lie anywhere on its host');
  assert.equal(led('[the gate](../../test/parity/README.md)').text, 'the gate (`test/parity/README.md`)');
  assert.equal(led('[out](https://example.com/a.md), [here](#part)').text, '[out](https://example.com/a.md), [here](#part)');
  assert.throws(() => led('[gone](gone.md)', 'README.md', () => false), /README.md: gone.md is not there/);
});

test('numbers in tables stay beside their units', () => {
  assert.equal(unbroken('| 190 ms | 2 GiB, 5 sides |\n190 ms'), '| 190\u00a0ms | 2\u00a0GiB, 5 sides |\n190 ms');
});

test('every page of js/docs is in the side bar, once; one without a group comes last', (t) => {
  const out = folderFor(t);
  const items = writePages(ROOT, out).flatMap((group) => group.items);
  const pages = [...pagesOf(ROOT).values()].map((page) => `/${page.replace(/\.md$/, '')}`);
  assert.deepEqual(items.map(({ link }) => link).sort(), pages.sort());
  for (const { text, link } of items) assert.ok(text && readFileSync(path.join(out, `${link}.md`), 'utf8').length > 0, link);
  assert.doesNotMatch(readFileSync(path.join(out, 'index.md'), 'utf8'), /<!-- peers -->/);
  assert.deepEqual(
    sidebarOf(
      new Map([
        ['start', 'a'],
        ['planted', 'b'],
      ]),
    ).at(-1),
    { text: 'More', collapsed: false, items: [{ text: 'b', link: '/planted' }] },
  );
  assert.ok(GROUPS.length > 5);
});

test('links of a built site that lead nowhere are found: pages, headings, files', (t) => {
  const folder = folderFor(t);
  mkdirSync(path.join(folder, 'recipes'));
  const write = (name, html) => writeFileSync(path.join(folder, name), html);
  write(
    'index.html',
    '<h1 id="a&amp;b"></h1><a href="/recipes/s3.html">x</a><a href="#a&amp;b">x</a><img src="./icon.svg"><a href="https://example.com/">x</a>',
  );
  write('recipes/s3.html', '<a href="../index.html#a&amp;b">x</a><a href="/">x</a><a href="/recipes/s3">x</a>');
  write('icon.svg', '<svg/>');
  assert.deepEqual(deadLinks(folder), []);
  assert.deepEqual(deadLinks(folder, '/telar/').length > 0, true);
  write('planted.html', '<a href="/gone.html">x</a><a href="index.html#gone">x</a><img src="/gone.png"><a href="#gone">x</a>');
  assert.deepEqual(
    deadLinks(folder),
    ['/gone.html', 'index.html#gone', '/gone.png', '#gone'].map((link) => `planted.html: ${link}`),
  );
});
