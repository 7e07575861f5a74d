import { readFileSync } from 'node:fs';

// VitePress's configuration; js/build/site/make.mjs copies it beside the pages, with the side bars.

const { sidebar, api, version, base, out } = JSON.parse(readFileSync(new URL('./contents.json', import.meta.url), 'utf8'));

/** Ids of headings as GitHub and npm make them, which links in the pages go by. */
const slugOf = (text) =>
  text
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M} _-]/gu, '')
    .replaceAll(' ', '-');

export default {
  title: 'telar',
  description: 'Garment thumbnails on a server that match what the browser client shows',
  lang: 'en',
  base,
  outDir: out,
  cleanUrls: false,
  lastUpdated: false,
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${base}icon.svg` }]],
  markdown: { theme: { light: 'github-light', dark: 'github-dark-dimmed' }, anchor: { slugify: slugOf } },
  vite: { build: { chunkSizeWarningLimit: 4096 }, logLevel: 'warn' },
  themeConfig: {
    logo: '/icon.svg',
    nav: [
      { text: 'Guide', link: '/start', activeMatch: '^/(?!api|changelog)' },
      { text: 'API', link: '/api/', activeMatch: '^/api/' },
      { text: `Version ${version}`, link: '/changelog' },
    ],
    sidebar: { '/api/': api, '/': sidebar },
    outline: { level: [2, 3] },
    search: { provider: 'local' },
    docFooter: { prev: 'Before', next: 'Next' },
  },
};
