// What the site holds, and in which order. A page of js/docs that stands in no group comes last by itself.

/** Pages of the repository beside those of js/docs: file, page of the site. */
export const OTHERS = {
  'README.md': 'start.md',
  'SECURITY.md': 'security.md',
  'ARCHITECTURE.md': 'architecture.md',
  'CONTRIBUTING.md': 'contributing.md',
  'CHANGELOG.md': 'changelog.md',
};

/** Groups of the side bar. */
export const GROUPS = [
  { text: 'Start', pages: ['start', 'install', 'container', 'examples'] },
  { text: 'Pictures', pages: ['options', 'formats', 'layers', 'many', 'compare', 'view', 'browser', 'errors'] },
  { text: 'Tech sheets', pages: ['sheet'] },
  { text: 'Cloth', pages: ['fabric', 'cloths', 'visibility', 'shading'] },
  { text: 'In production', pages: ['pool', 'server', 'queue', 'scale', 'security'] },
  { text: 'Recipes', pages: ['recipes'], folder: 'recipes' },
  { text: 'Accuracy', pages: ['trade', 'reference', 'accuracy', 'fabric_accuracy', 'numerics', 'analysis', 'figures'] },
  { text: 'Releases of three.js', pages: ['releases', 'families'] },
  { text: 'The project', pages: ['architecture', 'contributing', 'changelog'] },
];

/** What the side bar calls a page where that is not its heading. */
export const TITLES = {
  recipes: 'Overview',
  start: 'Introduction',
  install: 'Install',
  container: 'Container',
  server: 'Over HTTP (telar serve)',
  pool: 'A pool of workers',
};

/** Group of pages that no other one names. */
export const REST = 'More';
