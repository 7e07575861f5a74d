// The declarations of the package document it: every function and method with an example, every option with its default.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { callOptions, drawAllOptions, drawOptions, inspectOptions, keyOptions, loadOptions, RENDERER_KEYS, rendererOptions } from '../../../js/api/options.mjs';
import { declarations } from '../../../js/build/declarations.mjs';
import { DEFAULTS } from '../../../js/pool/defaults.mjs';
import { poolOptions } from '../../../js/pool/options.mjs';
import { lobesOptions } from '../../../js/api/lobes_options.mjs';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const PARTS = ['index', 'pool/index', 'queue/index', 'shot/index', 'three/index', 'compare/index', 'sheet/index'];
/** Those of telar itself first, as other parts have types of the same names. */
const TEXT = [...declarations(PARTS).values()].join('\n');

/** Members of an interface, those that it extends included: name to comment. */
function membersOf(name, text = TEXT) {
  const [, parents, body = ''] = new RegExp(`^export interface ${name}(?: extends ([\\w, ]+))? \\{(?:\\}|\\n([\\s\\S]*?)^\\})`, 'm').exec(text);
  const own = [...body.matchAll(/^ {2}(?:\/\*\*((?:(?!\*\/)[\s\S])*?)\*\/\n {2})?(?:readonly )?(\w+)(\?)?[:(]/gm)].map(([, comment = '', member, optional]) => [
    member,
    { comment, optional: Boolean(optional) },
  ]);
  const inherited = parents?.split(', ').flatMap((parent) => [...membersOf(parent, text)]) ?? [];
  const members = new Map(inherited);
  // Of an overload the first is documented.
  for (const [member, fact] of own) if (!own.some(([other, { comment }]) => other === member && comment) || fact.comment) members.set(member, fact);
  return members;
}

/** More keys than a message names are listed by those who look for them. */
const LISTED = { PoolOptions: ['size', ...Object.keys(DEFAULTS), ...RENDERER_KEYS] };

/** What a reader of options says that it knows: its message names the keys. */
function knownBy(read) {
  try {
    read({ notAnOption: 1 });
  } catch (error) {
    return [...error.message.matchAll(/\b[a-z]\w*\b/gi)].map(([word]) => word);
  }
  throw new Error('an unknown option was let pass');
}

const READERS = {
  CallOptions: callOptions,
  LoadOptions: (options) => loadOptions(options, {}),
  DrawOptions: (options) => drawOptions(options, {}),
  DrawAllOptions: (options) => drawAllOptions(options, {}),
  RendererOptions: (options) => rendererOptions(options, []),
  InspectOptions: (options) => inspectOptions(options, []),
  PictureKeyOptions: (options) => keyOptions(options, []),
  PoolOptions: (options) => poolOptions(options, []),
  EvaluateShadingOptions: (options) => lobesOptions(options),
};

for (const [name, read] of Object.entries(READERS)) {
  test(`${name}: each option has a text and a default, and is read`, () => {
    const known = LISTED[name] ?? knownBy(read);
    for (const option of LISTED[name] ?? []) read({ [option]: undefined });
    for (const [option, { comment, optional }] of membersOf(name)) {
      assert.ok(known.includes(option), `${option} is documented, and refused`);
      assert.match(comment, /[A-Z][^@]{10,}/, `${option} has a text`);
      if (optional) assert.match(comment, /@default \S/, `${option} has a default`);
    }
  });
}

test('the defaults are those that are read', () => {
  const defaults = rendererOptions({}, []);
  const written = (option) => /@default (\S+?):?(?=\s)/.exec(membersOf('RendererOptions').get(option).comment)[1];
  for (const option of ['backend', 'cacheBytes', 'limits', 'maxWaiting', 'allFeatures']) {
    assert.deepEqual(JSON.parse(written(option).replaceAll("'", '"')), defaults[option], option);
  }
  for (const [option, value] of Object.entries(DEFAULTS)) {
    assert.deepEqual(JSON.parse(/@default (\S+)/.exec(membersOf('PoolOptions').get(option).comment)[1]), value, option);
  }
  assert.equal(written('failOn'), `'${defaults.loading.failOn}'`);
});

/** Examples of the page, with what stands before each. */
const EXAMPLES = [...TEXT.matchAll(/ \* @example\n((?: *\* [^\n]*\n)+?) *\*(?:\/| @)/g)].map(([, lines]) => lines.replaceAll(/^ *\* /gm, ''));

test('every method and function has an example', () => {
  for (const [method, { comment }] of ['Renderer', 'Model', 'Pool', 'Queue', 'Worker'].flatMap((name) => [...membersOf(name)])) {
    if (!['backend', 'gl', 'facts', 'workers', 'warnings', 'ready'].includes(method)) assert.match(comment, /@example\n/, method);
  }
  for (const [, comment, name] of TEXT.matchAll(/^(?:\/\*\*((?:(?!\*\/)[\s\S])*?)\*\/\n)?export function (\w+)/gm))
    assert.match(comment ?? '', /@example\n/, name);
  assert.ok(EXAMPLES.length >= 60, String(EXAMPLES.length));
});

const FOLDER = path.join(ROOT, 'out/examples');
after(() => rmSync(FOLDER, { recursive: true, force: true }));

/** What a part declares, for an import: functions, and the types that examples name. */
const namesOf = (part) => [
  ...[
    ...declarations([`${part}/index`])
      .get(`${part}/index`)
      .matchAll(/^export function (\w+)/gm),
  ].map(([, name]) => name),
  ...({ compare: ['type Compared'], queue: ['type Queue', 'type Task', 'type Worker'] }[part] ?? []),
];

function typeErrors(examples) {
  mkdirSync(FOLDER, { recursive: true });
  const config = { extends: '../../test/types/tsconfig.json', files: ['../../test/types/globals.d.ts', 'all.mts'] };
  writeFileSync(path.join(FOLDER, 'tsconfig.json'), JSON.stringify(config));
  writeFileSync(
    path.join(FOLDER, 'all.mts'),
    [
      "import { animateWebp, bake, createRenderer, doctor, evaluateShading, inspect, pictureKey, toTelarError, type Model, type Renderer, type Resolve, type Shot } from 'telar';",
      "import { createPool, type Pool, type PoolModel } from 'telar/pool';",
      ...['compare', 'queue', 'sheet', 'shot', 'three'].map((part) => `import { ${namesOf(part).join(', ')} } from 'telar/${part}';`),
      'declare function writeFile(path: string, data: Uint8Array): Promise<void>;',
      ...['THREE', 'HDRLoader', 'gltf', 'process'].map((name) => `declare const ${name}: any;`),
      'declare const queue: Queue, worker: Worker, id: string, bytes: Uint8Array;',
      ...examples.map(
        (example, i) =>
          `export async function example${i}(${/(using|const) pool\b/.test(example) ? '' : 'pool: Pool, poolModel: PoolModel, '}${example.includes('const renderer') || example.includes('using renderer') ? '' : 'renderer: Renderer, '}${example.includes('const model') ? '' : 'model: Model'}) {\n${example}}`,
      ),
      'export const all = [animateWebp, bake, createPool, createRenderer, doctor, evaluateShading, inspect, pictureKey];',
      'export type All = [Model, Renderer, Resolve, Shot];',
    ].join('\n'),
  );
  const { stdout } = spawnSync(process.execPath, [path.join(ROOT, 'node_modules/typescript/bin/tsc'), '-p', FOLDER], { encoding: 'utf8' });
  return stdout;
}

test('the examples are right by their types; a planted fault is found', () => {
  assert.equal(typeErrors(EXAMPLES), '');
  assert.match(typeErrors([...EXAMPLES, "await renderer.render('shirt.glb', {}, { timeout: 5 });\n"]), /'timeout' does not exist/);
});
