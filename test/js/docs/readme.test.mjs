import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const DOCUMENTS = [
  'README.md',
  'ARCHITECTURE.md',
  'SECURITY.md',
  'CONTRIBUTING.md',
  'CHANGELOG.md',
  ...readdirSync(new URL('../../../js/docs/', import.meta.url), { recursive: true })
    .filter((name) => name.endsWith('.md'))
    .map((name) => `js/docs/${name}`),
];
const read = (file) => readFileSync(path.join(ROOT, file), 'utf8');
const { bin, scripts } = JSON.parse(read('package.json'));

/** First bytes by extension. */
const MAGIC = { '.png': [0x89, 0x50, 0x4e, 0x47], '.jpg': [0xff, 0xd8, 0xff], '.json': ['{'.charCodeAt(0)] };

/** A project that has telar installed and a model beside it, as the examples assume. */
function userProject(t) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-readme-'));
  t.after(() => rmSync(folder, { recursive: true }));
  mkdirSync(path.join(folder, 'node_modules/.bin'), { recursive: true });
  symlinkSync(ROOT, path.join(folder, 'node_modules/telar'));
  symlinkSync(path.join(ROOT, bin.telar), path.join(folder, 'node_modules/.bin/telar'));
  copyFileSync(path.join(ROOT, 'js/assets/tshirt.glb'), path.join(folder, 'shirt.glb'));
  return folder;
}

/** Runs one example to its end; its standard output. */
async function run(language, text, folder) {
  const env = { ...process.env, PATH: `${path.join(folder, 'node_modules/.bin')}:${process.env.PATH}` };
  if (language === 'js') writeFileSync(path.join(folder, 'example.mjs'), text);
  const [command, args] = language === 'js' ? [process.execPath, ['example.mjs']] : ['bash', ['-euc', text]];
  const child = spawn(command, args, { cwd: folder, env, stdio: ['ignore', 'pipe', 'pipe'] });
  const out = { stdout: '', stderr: '' };
  for (const name of ['stdout', 'stderr']) child[name].setEncoding('utf8').on('data', (chunk) => (out[name] += chunk));
  const [code, signal] = await once(child, 'close');
  assert.equal(code, 0, `${signal ?? ''}\n${out.stdout}\n${out.stderr}`);
  return out.stdout;
}

const pages = `${read('README.md')}\n${read('js/docs/examples.md')}`;
const examples = [...pages.matchAll(/^```(js|sh)\n([\s\S]*?)^```$/gm)].map(([, language, text]) => ({ language, text }));

test('there are ten examples', () => assert.ok(examples.length >= 10, String(examples.length)));

examples.forEach(({ language, text }, index) => {
  test(`example ${index + 1} runs and writes what it names`, async (t) => {
    const folder = userProject(t);
    const stdout = await run(language, text, folder);
    const written = [...text.matchAll(/(?:writeFile\('|-o |> )([\w.-]+\.\w+)/g)].map(([, file]) => file);
    assert.ok(written.length > 0, 'an example writes a file');
    for (const file of written) {
      const bytes = readFileSync(path.join(folder, file));
      assert.deepEqual([...bytes.subarray(0, MAGIC[path.extname(file)].length)], MAGIC[path.extname(file)], file);
    }
    if (text.includes('error.code')) assert.match(stdout, /^E_SHOT .*exposure/m);
  });
});

test('every link to a file leads somewhere', () => {
  for (const document of DOCUMENTS) {
    for (const [, target] of read(document).matchAll(/\]\((?!https?:|#)([^)#]+)[^)]*\)/g)) {
      assert.ok(existsSync(path.join(ROOT, path.dirname(document), target)), `${document}: ${target}`);
    }
  }
});

/** Ids of a document's headings, as GitHub, npm and `npm run site` make them. */
const idsOf = (text) =>
  [...text.replace(/^```[\s\S]*?^```/gm, '').matchAll(/^#+ (.+)$/gm)].map(([, heading]) =>
    heading
      .trim()
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\p{M} _-]/gu, '')
      .replaceAll(' ', '-'),
  );

/** Links to headings that are not there: `document: link`. */
const lostHeadings = (document, text) =>
  [...text.matchAll(/\]\((?!https?:)([^)#\s]*)#([^)\s]+)\)/g)]
    .filter(([, target, id]) => !idsOf(target ? read(path.join(path.dirname(document), target)) : text).includes(id))
    .map(([link]) => `${document}: ${link}`);

test('every link to a heading leads to one', () => {
  assert.deepEqual(
    DOCUMENTS.flatMap((document) => lostHeadings(document, read(document))),
    [],
  );
  assert.equal(lostHeadings('README.md', '[a](js/docs/install.md#planted), [b](js/docs/install.md#arm64)').length, 1);
});

test('every npm script that a document names exists', () => {
  for (const document of DOCUMENTS) {
    for (const [, name] of read(document).matchAll(/npm run ([\w:-]+)/g)) assert.ok(scripts[name], `${document}: npm run ${name}`);
  }
});

test('every path in code marks exists', () => {
  for (const document of DOCUMENTS) {
    for (const [, name] of read(document).matchAll(/`((?:js|renderer|addon|shaders|test)\/[\w./-]+)`/g)) {
      assert.ok(existsSync(path.join(ROOT, name)), `${document}: ${name}`);
    }
  }
});

test('the pictures are there and small', () => {
  const pictures = [...read('README.md').matchAll(/!\[[^\]]*\]\(([^)]+)\)/g)].map(([, file]) => file);
  assert.ok(pictures.length > 0);
  for (const picture of pictures) assert.ok(statSync(path.join(ROOT, picture)).size < 300_000, picture);
});
