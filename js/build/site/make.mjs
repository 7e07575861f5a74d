import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { ROOT } from '../../machine/step.mjs';
import { deadLinks } from './links.mjs';
import { writePages } from './pages.mjs';

// node js/build/site/make.mjs TOOLS: the documentation as a site, in out/site. TOOLS holds node_modules of js/build/site/package.json.
// TELAR_SITE_BASE: where it lies on its host, as /telar/.

const HERE = path.join(ROOT, 'js/build/site');
const SOURCES = path.join(ROOT, 'out/site-pages');
const OUT = path.join(ROOT, 'out/site');
const base = process.env.TELAR_SITE_BASE ?? '/';
const [tools] = process.argv.slice(2);
const own = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));

const tool = (file, args) =>
  execFileSync(process.execPath, [path.join(tools, 'node_modules', file), ...args], { cwd: ROOT, stdio: ['ignore', 'ignore', 'inherit'] });

/** Declarations of every entry that package.json gives to import, by the entry's name, as telar/pool. */
const declarations = new Map(
  Object.entries(own.exports).flatMap(([entry, { import: given }]) => (given?.types ? [[path.posix.join('telar', entry), given.types]] : [])),
);

function writeApi() {
  const entryPoints = [...declarations.values()].map((file) => path.join(ROOT, file));
  const config = path.join(SOURCES, 'typedoc.json');
  const tsconfig = path.join(SOURCES, 'tsconfig.json');
  writeFileSync(
    tsconfig,
    JSON.stringify({
      compilerOptions: {
        module: 'nodenext',
        target: 'es2023',
        lib: ['es2023', 'dom', 'esnext.disposable'],
        types: ['node'],
        typeRoots: [path.join(tools, 'node_modules/@types')],
        noEmit: true,
        skipLibCheck: true,
      },
      files: entryPoints,
    }),
  );
  writeFileSync(
    config,
    JSON.stringify({
      entryPoints,
      tsconfig,
      out: path.join(SOURCES, 'api'),
      plugin: ['typedoc-plugin-markdown', 'typedoc-vitepress-theme'].map((name) => path.join(tools, 'node_modules', name, 'dist/index.js')),
      docsRoot: SOURCES,
      readme: 'none',
      name: 'API',
      disableSources: true,
      excludeInternal: true,
      useCodeBlocks: true,
      hideBreadcrumbs: true,
      treatValidationWarningsAsErrors: false,
      validation: { notExported: false, invalidLink: true },
      logLevel: 'Warn',
    }),
  );
  tool('typedoc/bin/typedoc', ['--options', config]);
  return namedAsImported(JSON.parse(readFileSync(path.join(SOURCES, 'api/typedoc-sidebar.json'), 'utf8')));
}

/** TypeDoc calls modules by their folder; readers import them by another name. @param {{text: string}[]} sidebar */
function namedAsImported(sidebar) {
  const folderOf = (file) => path.basename(path.dirname(file)).replace(/^js$/, 'index');
  const names = new Map([...declarations].map(([name, file]) => [folderOf(file), name]));
  const rename = (file, pattern, by) => writeFileSync(file, readFileSync(file, 'utf8').replace(pattern, by));
  for (const [folder, name] of names) {
    rename(path.join(SOURCES, 'api', folder, 'index.md'), /^# .*$/m, `# ${name}`);
    rename(path.join(SOURCES, 'api/index.md'), `[${folder}]`, `[${name}]`);
  }
  return sidebar.map((group) => ({ ...group, text: names.get(group.text) ?? group.text, collapsed: true }));
}

for (const folder of [SOURCES, OUT]) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
}
const sidebar = writePages(ROOT, SOURCES);
const api = writeApi();
const settings = path.join(SOURCES, '.vitepress');
cpSync(path.join(HERE, 'theme'), path.join(settings, 'theme'), { recursive: true });
cpSync(path.join(HERE, 'config.mjs'), path.join(settings, 'config.mjs'));
writeFileSync(path.join(settings, 'contents.json'), JSON.stringify({ sidebar, api, version: own.version, base, out: OUT }));
mkdirSync(path.join(SOURCES, 'public'), { recursive: true });
cpSync(path.join(ROOT, 'js/view/page/icon.svg'), path.join(SOURCES, 'public/icon.svg'));
tool('vitepress/bin/vitepress.js', ['build', SOURCES]);
const dead = deadLinks(OUT, base);
if (!existsSync(path.join(OUT, 'index.html'))) throw new Error('no site was written');
if (dead.length) throw new Error(`${dead.length} links lead nowhere:\n${dead.join('\n')}`);
process.stdout.write(`${path.relative(ROOT, path.join(OUT, 'index.html'))}\n`);
