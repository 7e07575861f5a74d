import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { errorsWithoutCode, layersWithoutTests, layerViolations, longFiles, testsOutsideRooms } from './layers/rules.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const MAX_LINES = 400;
const { dependencies = {}, optionalDependencies = {}, peerDependencies = {} } = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));
const PACKAGES = new Set([...Object.keys(dependencies), ...Object.keys(optionalDependencies), ...Object.keys(peerDependencies)]);

function sources(folders, pattern) {
  const files = folders.flatMap((folder) =>
    readdirSync(path.join(ROOT, folder), { recursive: true })
      .map((name) => `${folder}/${name}`)
      .filter((name) => pattern.test(name) && !name.startsWith('js/dist/')),
  );
  return new Map(files.map((file) => [file, readFileSync(path.join(ROOT, file), 'utf8')]));
}

const SOURCES = sources(['renderer', 'addon', 'js'], /\.(h|cpp|inl|mjs|cjs)$/);

test('every file depends downwards only', () => {
  assert.ok(SOURCES.size > 40, 'the sources were found');
  assert.deepEqual(layerViolations(SOURCES, PACKAGES), []);
});

test('planted violations are found, one each', async (t) => {
  const planted = {
    'renderer/core/planted.cpp': '#include "gl/context.h"\n',
    'renderer/asset/planted.h': '#include <GLES3/gl3.h>\n',
    'renderer/asset/accessor/planted.h': '#include "asset/material/material.h"\n',
    'renderer/pass/plan/planted.h': '#include "pass/surface/ltc.h"\n',
    'renderer/shot/planted.h': '#include "image/bytes.h"\n',
    'renderer/image/planted.cpp': '#include <OpenImageIO/imageio.h>\n',
    'renderer/pass/planted.cpp': 'void f(const telar::gl::Functions& gl) { GLuint n; gl.GenTextures(1, &n); }\n',
    'renderer/ibl/planted.cpp': 'void f(const telar::gl::Functions* gl) { gl->DeleteProgram(1); }\n',
    'renderer/gl/planted.cpp': 'void f() { std::cerr << 1; }\n',
    'renderer/brdf/planted.cpp': 'void f() { printf("x"); }\n',
    'renderer/newlayer/planted.cpp': '\n',
    'addon/planted.cpp': '#include "core/text.h"\n',
    'js/shot/planted.mjs': "import fs from 'node:fs';\n",
    'js/error/planted.mjs': "import { resolveShot } from '../shot/index.mjs';\n",
    'js/three/planted.mjs': "import ajv from 'ajv';\n",
    'js/cli/planted.mjs': "import { addon } from '../api/native.mjs';\n",
    'js/build/planted.mjs': "import { setUp } from '../setup/index.mjs';\n",
    'js/setup/planted.mjs': "const { z } = await import('zod');\n",
    'js/api/planted.mjs': "import { x } from '../../test/x.mjs';\n",
    'js/pool/planted.mjs': "import { run } from '../cli/run.mjs';\n",
    'js/compare/planted.mjs': "import {\n  // of the command line\n  one,\n  two as three,\n} from '../cli/run.mjs';\n",
    'js/analyse/planted.mjs': "export {\n  one,\n  two,\n}\n  from '../cli/run.mjs';\n",
    'js/sheet/planted.mjs': "import { loadNative } from '../api/native.mjs';\n",
    'js/sheet/place/planted.mjs': "import { readFile } from 'node:fs/promises';\n",
    'js/view/planted.mjs': "const late = () => import(\n  '../cli/run.mjs',\n);\n",
  };
  const helpers = new Map([
    ['renderer/gl/context.h', ''],
    ['renderer/asset/material/material.h', ''],
    ['renderer/image/bytes.h', ''],
    ['renderer/pass/surface/ltc.h', ''],
    ['renderer/core/text.h', ''],
  ]);
  for (const [file, text] of Object.entries(planted)) {
    await t.test(file, () => {
      const found = layerViolations(new Map([...helpers, [file, text]]), PACKAGES);
      assert.equal(found.length, 1, found.join('\n'));
      assert.ok(found[0].startsWith(`${file}:1: `), found[0]);
    });
  }
});

test('comments and strings are no violations', () => {
  const file = new Map([
    [
      'renderer/pass/fine.cpp',
      '// gl.GenTextures, printf(\nconst char* f() { return "printf("; } /* std::cout */\nint g() { return std::snprintf(a, 1, "x"); }\n',
    ],
  ]);
  assert.deepEqual(layerViolations(file, PACKAGES), []);
});

test('every layer has its tests', () => {
  const tests = ['cpp', 'js']
    .flatMap((kind) => readdirSync(path.join(ROOT, 'test', kind), { recursive: true }).map((name) => `test/${kind}/${name}`))
    .filter((name) => /_test\.cpp$|\.test\.mjs$/.test(name));
  assert.deepEqual(layersWithoutTests(tests), []);
  const planted = tests.filter((name) => !name.startsWith('test/cpp/gl/'));
  assert.deepEqual(layersWithoutTests(planted), ['renderer/gl: no test in test/cpp/gl']);
  const roomless = tests.filter((name) => !name.startsWith('test/cpp/asset/pose/'));
  assert.deepEqual(layersWithoutTests(roomless), ['renderer/asset/pose: no test in test/cpp/asset/pose']);
  assert.deepEqual(testsOutsideRooms(tests), []);
  const stray = 'test/cpp/asset/planted_test.cpp';
  assert.deepEqual(testsOutsideRooms([...tests, stray]), [stray]);
});

test('a test of C++ names the code of the error that it wants', () => {
  assert.deepEqual(errorsWithoutCode(sources(['test/cpp'], /\.(h|cpp)$/)), []);
  const planted = [
    'EXPECT_THROW(f(), Error);',
    'ASSERT_THROW(\n  f({1, 2}),\n  telar::Error)',
    'EXPECT_ANY_THROW(f());',
    'EXPECT_THROW(f(), std::bad_alloc);',
    '// EXPECT_THROW(f(), Error);',
  ];
  assert.deepEqual(
    planted.map((text) => errorsWithoutCode(new Map([['a.cpp', `\n${text}`]])).length),
    [1, 1, 1, 0, 0],
  );
});

/** What is written by hand: not data, nor pages of documentation. */
const LONG = /\.(h|cpp|inl|inc|mjs|cjs|d\.ts|mts|cts|css|html|typ|glsl|vert|frag)$/;
/** Written by a program, as the first lines say. */
const isGenerated = (text) => /^\/\/ (?:Generated by |.*\bwritten by js\/)/m.test(text.slice(0, 500));

test('ARCHITECTURE.md has a row for each folder of js and of renderer, shaders/README.md for each of shaders', () => {
  const folders = (parent) => readdirSync(path.join(ROOT, parent), { withFileTypes: true }).filter((entry) => entry.isDirectory());
  const missing = (page, names) =>
    names.filter((name) => !page.split('\n').some((line) => line.startsWith('| `') && line.split(' | ')[0].includes(`\`${name}`)));
  const architecture = readFileSync(path.join(ROOT, 'ARCHITECTURE.md'), 'utf8');
  const rooms = ['js', 'renderer'].flatMap((parent) => folders(parent).map(({ name }) => `${parent}/${name}`));
  const wanted = [...rooms.filter((room) => !['js/dist', 'js/docs', 'renderer/include'].includes(room)), 'renderer/include/telar', 'js/docs/recipes'];
  assert.deepEqual(missing(architecture, wanted), []);
  assert.deepEqual(missing(architecture.replace(/^\| `js\/error` .*\n/m, ''), wanted), ['js/error']);
  const shaders = readFileSync(path.join(ROOT, 'shaders/README.md'), 'utf8');
  const entries = readdirSync(path.join(ROOT, 'shaders')).filter((name) => name !== 'README.md');
  assert.deepEqual(missing(shaders, entries), []);
  assert.deepEqual(missing(shaders.replace(/^\| `layers\/` .*\n/m, ''), entries), ['layers']);
});

/** The folders of the code, and what the ecosystem puts at a root. */
const AT_ROOT =
  /^(addon|renderer|shaders|js|test|\.ci|binding\.gyp|CMake(Lists\.txt|Presets\.json)|package(-lock)?\.json|biome\.json|compose\.yaml|Dockerfile|NOTICE|[A-Z]+\.md|\.(clang|git|docker|npm|editor)[\w-]*)$/;

test('nothing else lies at the root', () => {
  const foreign = (files) => [...new Set(files.map((file) => file.split('/')[0]))].filter((name) => !AT_ROOT.test(name));
  const kept = execFileSync('git', ['ls-files'], { cwd: ROOT, encoding: 'utf8' }).trim().split('\n');
  assert.ok(kept.includes('package.json'));
  assert.deepEqual(foreign(kept), []);
  assert.deepEqual(foreign(['README.md', 'isolate-0x1-2-v8.log', 'scratch/a.mjs']), ['isolate-0x1-2-v8.log', 'scratch'], 'planted');
});

test('no file is long', () => {
  const texts = new Map([...sources(['js', 'renderer', 'addon', 'shaders', 'test'], LONG)].filter(([, text]) => !isGenerated(text)));
  for (const file of ['js/index.d.ts', 'js/view/page/index.html', 'renderer/brdf/declarations.inl']) assert.ok(texts.has(file), file);
  assert.ok(texts.size > 500, String(texts.size));
  assert.deepEqual(longFiles(texts, MAX_LINES), []);
  assert.deepEqual(
    longFiles(
      new Map([
        ['a.h', '\n'.repeat(MAX_LINES + 1)],
        ['b.h', '\n'.repeat(MAX_LINES)],
      ]),
      MAX_LINES,
    ),
    [`a.h has ${MAX_LINES + 1} lines, more than ${MAX_LINES}`],
  );
});
