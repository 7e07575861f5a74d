import path from 'node:path';

// The direction of dependency (ARCHITECTURE.md draws it), as data, and the check of source texts against it.
// Folders not named here are violations themselves: a new layer gets a row.

/** The rooms of a layer, lowest first. */
const ASSET_ORDER = ['check', 'container', 'document', 'accessor', 'geometry', 'pose', 'material', 'scene'].map((room) => `renderer/asset/${room}`);
const PASS_ORDER = ['texture', 'model', 'target', 'plan', 'visible', 'shadow', 'surface', 'layer'].map((room) => `renderer/pass/${room}`);

/** Rows of a layer with rooms: each may use those before it. What lies beside them uses them all. */
const roomsOf = (layer, order, uses) => Object.fromEntries([...order, layer].map((room, at) => [room, [...uses, ...order.slice(0, at)]]));

/** C++ layers: which folders' headers a file in the folder may include by quotes. `include` is renderer/include/telar. */
const CPP_LAYERS = {
  'renderer/include': [],
  'renderer/core': ['renderer/include'],
  'renderer/brdf': ['renderer/include'],
  // image/ opens the library of oiio/ at run time by the C interface of oiio/plugin.h, and links nothing of it.
  'renderer/image': ['renderer/include', 'renderer/core', 'renderer/ktx2', 'renderer/oiio/plugin.h'],
  'renderer/ktx2': ['renderer/include', 'renderer/core'],
  'renderer/oiio/plugin.h': [],
  'renderer/oiio': ['renderer/include', 'renderer/core', 'renderer/oiio/plugin.h'],
  ...roomsOf('renderer/asset', ASSET_ORDER, ['renderer/include', 'renderer/core']),
  'renderer/shot': ['renderer/include', 'renderer/core'],
  'renderer/gl': ['renderer/include', 'renderer/core'],
  'renderer/shader': ['renderer/include', 'renderer/core', 'renderer/gl'],
  'renderer/ibl': ['renderer/include', 'renderer/core', 'renderer/brdf', 'renderer/gl', 'renderer/shader'],
  'renderer/lobes': ['renderer/include', 'renderer/core', 'renderer/brdf'],
  'renderer/frame': ['renderer/include', 'renderer/core', 'renderer/brdf', 'renderer/shader'],
  'renderer/surface': ['renderer/include', 'renderer/core'],
  'renderer/visibility': ['renderer/include'],
  'renderer/measure': ['renderer/include', 'renderer/core', 'renderer/frame', 'renderer/surface'],
  'renderer/flat': ['renderer/include', 'renderer/core', 'renderer/frame', 'renderer/surface'],
  'renderer/swatch': ['renderer/include', 'renderer/core', 'renderer/frame', 'renderer/surface'],
  ...roomsOf('renderer/pass', PASS_ORDER, [
    'renderer/include',
    'renderer/core',
    'renderer/brdf',
    'renderer/gl',
    'renderer/shader',
    'renderer/ibl',
    'renderer/frame',
    'renderer/visibility',
  ]),
  'renderer/reference/plugin.h': ['renderer/include'],
  // trace/ opens the library of reference/ at run time, and links nothing of it.
  'renderer/trace': ['renderer/include', 'renderer/core', 'renderer/frame', 'renderer/reference/plugin.h'],
  'renderer/render': ['renderer/include'],
  'renderer/reference': ['renderer/reference/plugin.h', 'renderer/include', 'renderer/core', 'renderer/brdf', 'renderer/shader', 'renderer/frame'],
  addon: ['renderer/include'],
};

/** Libraries that live behind one layer: header pattern, and the folders that may include it. */
const OWNED_HEADERS = [
  { header: /^EGL\//, folders: ['renderer/gl'] },
  { header: /^(GLES\d|GL)\//, folders: ['renderer/gl', 'renderer/shader', 'renderer/ibl', 'renderer/pass'] },
  { header: /^(png\.h|jpeglib\.h|jerror\.h|webp\/.*)$/, folders: ['renderer/image'] },
  { header: /^lcms2\.h$/, folders: ['renderer/oiio'] },
  { header: /^nettle\//, folders: ['renderer/core'] },
  { header: /^(libdeflate|zlib)\.h$/, folders: ['renderer/image', 'renderer/ibl'] },
  { header: /^(tiny_gltf\.h|draco\/.*)$/, folders: ['renderer/asset'] },
  { header: /^embree3\//, folders: ['renderer/reference'] },
  { header: /^zstd\.h$/, folders: ['renderer/ktx2'] },
  { header: /^meshoptimizer\.h$/, folders: ['renderer/asset'] },
  { header: /^(OpenImageIO|OpenEXR|Imath)\//, folders: ['renderer/oiio'] },
  { header: /^(napi|node_api|js_native_api|uv|node)\.h$/, folders: ['addon'] },
  { header: /^iostream$/, folders: [] },
];

/** Calls that belong to one folder; the pattern is matched on text without comments and strings. */
const OWNED_CALLS = [
  {
    call: /\b(gl)?(Gen|Delete)(Buffers|Textures|Framebuffers|Renderbuffers|Samplers|VertexArrays|Queries)\b|\b(gl)?(Create|Delete)(Program|Shader)\b/,
    folders: ['renderer/gl'],
    why: 'GL names are made and destroyed by the classes of renderer/gl/gl_object.h alone',
  },
  // make_*.cpp are programs of the build.
  {
    call: /\bstd::(cout|cerr|clog)\b|(?<![\w:])(std::)?f?(printf|puts|putchar)\s*\(/,
    folders: [],
    unless: /\/make_\w+\.cpp$/,
    why: 'a library prints nothing',
  },
  { call: /\bdlopen\s*\(/, folders: ['renderer/core', 'renderer/gl', 'renderer/oiio'], why: 'libraries are loaded in few places' },
];

/**
 * JavaScript layers: which folders (or files) under js/ a module may import, and whether it must run in a browser; `bundled`:
 * its packages are built in.
 */
const JS_LAYERS = {
  'js/index.mjs': { imports: ['js/api', 'js/error'] },
  'js/error': { imports: [], browser: true },
  'js/shot': { imports: ['js/error', 'js/dist/zod.mjs'], browser: true },
  'js/material': { imports: [], browser: true },
  'js/three': { imports: ['js/error', 'js/shot', 'js/material', 'js/dist/shading'], browser: true },
  'js/api': { imports: ['js/error', 'js/shot', 'js/predict'] },
  'js/api/atomic_file.mjs': { imports: ['js/error', 'js/shot', 'js/api/is_alive.mjs'] },
  'js/api/is_alive.mjs': { imports: [] },
  'js/pool': { imports: ['js/error', 'js/shot', 'js/api', 'js/compare', 'js/sheet'] },
  'js/queue': { imports: ['js/error', 'js/shot', 'js/api', 'js/compare'] },
  'js/server': { imports: ['js/error', 'js/shot', 'js/api', 'js/pool', 'js/queue', 'js/compare', 'js/sheet'] },
  'js/server/page': { imports: [], browser: true },
  'js/compare': { imports: ['js/error', 'js/shot', 'js/api'] },
  'js/analyse': { imports: ['js/error', 'js/shot', 'js/compare'] },
  'js/predict': { imports: ['js/error', 'js/shot', 'js/compare'] },
  'js/trade': { imports: ['js/error', 'js/shot', 'js/compare', 'js/analyse', 'js/predict'] },
  'js/sheet': { imports: ['js/error', 'js/shot', 'js/compare', 'js/dist/zod.mjs'] },
  'js/sheet/table': { imports: ['js/shot', 'js/sheet/care.mjs'], browser: true },
  'js/sheet/care.mjs': { imports: [], browser: true },
  'js/sheet/scale.mjs': { imports: ['js/shot'], browser: true },
  'js/sheet/place': { imports: [], browser: true },
  'js/view': { imports: ['js/error', 'js/shot', 'js/compare', 'js/sheet', 'js/api/native.mjs'] },
  'js/view/page': { imports: ['js/error', 'js/shot', 'js/three', 'js/compare', 'js/dist/zod.mjs'], browser: true, bundled: true },
  'js/cli': {
    imports: [
      'js/error',
      'js/shot',
      'js/api/atomic_file.mjs',
      'js/api/fail_on.mjs',
      'js/api/early.mjs',
      'js/api/renderer.mjs',
      'js/api/sha256.mjs',
      'js/compare',
      'js/analyse',
      'js/sheet',
      'js/view',
      'js/pool',
      'js/queue',
      'js/server',
      'js/trade',
      'js/predict',
      'js/index.mjs',
    ],
  },
  'js/machine': { imports: [], builtinsOnly: true },
  'js/build': { imports: ['js/build/shading'], development: true },
  'js/build/addon.mjs': { imports: ['js/machine'], builtinsOnly: true },
  'js/build/install.mjs': { imports: ['js/machine'], builtinsOnly: true },
  'js/build/package': { imports: ['js/machine'], builtinsOnly: true, development: true },
  'js/build/site': { imports: ['js/machine'], builtinsOnly: true, development: true },
  'js/build/material': { imports: ['js/material'], builtinsOnly: true },
  'js/build/shading': { imports: ['js/shot', 'js/three', 'js/material', 'js/build/material'], development: true },
  'js/build/docs': {
    imports: ['js/error', 'js/material', 'js/shot', 'js/cli', 'js/analyse', 'js/sheet', 'js/queue', 'js/server', 'js/index.mjs', 'js/dist/zod.mjs'],
    development: true,
  },
  // What readers copy: it imports telar by its name.
  'js/docs/recipes': { imports: [], development: true },
  'js/setup': { imports: ['js/machine', 'js/build/addon.mjs', 'js/build/package'], builtinsOnly: true },
  'js/assets/make': { imports: ['js/index.mjs', 'js/sheet'], development: true },
};

const QUOTED_INCLUDE = /^\s*#\s*include\s*"([^"]+)"/;
const ANGLE_INCLUDE = /^\s*#\s*include\s*<([^>]+)>/;
/** A statement may take many lines; nothing between its first word and `from` is a string, a call or another statement. */
const JS_IMPORT = /(?:^[ \t]*(?:import|export)\b[^'"`;()=]*?\bfrom\s*|^[ \t]*import\s*|\bimport\s*\(\s*|\brequire\s*\(\s*)['"]([^'"]+)['"]/gm;

/** Where the tests of a layer lie that has no folder of its own under test/cpp or test/js. */
const TESTED_IN = {
  'renderer/include': 'test/cpp/core',
  'renderer/frame': 'test/cpp/renderer',
  'renderer/lobes': 'test/js/api/lobes.test.mjs',
  'renderer/oiio': 'test/cpp/image',
  ...Object.fromEntries([...PASS_ORDER, 'renderer/pass'].map((room) => [room, 'test/cpp/renderer'])),
  'renderer/shader': 'test/cpp/brdf/shared_text_test.cpp',
  'renderer/surface': 'test/cpp/measure',
  'renderer/swatch': 'test/js/api/swatch.test.mjs',
  'renderer/trace': 'test/cpp/reference',
};

const within = (file, folder) => file === folder || file.startsWith(`${folder}/`);

/** The longest row that the file lies in. */
function layerOf(file, table) {
  return Object.keys(table)
    .filter((folder) => within(file, folder))
    .sort((a, b) => b.length - a.length)[0];
}

/** Text with comments and string contents blanked, line numbers kept. */
function codeOnly(text) {
  return text
    .replace(/\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' '))
    .replace(/\/\/[^\n]*/g, '')
    .replace(/"(?:[^"\\\n]|\\.)*"/g, '""');
}

/** Where a quoted include leads: beside the file, under renderer/include, renderer/ or addon/, or nowhere of ours. */
function includedFile(file, name, files) {
  const candidates = [path.posix.join(path.posix.dirname(file), name), `renderer/include/${name}`, `renderer/${name}`, `addon/${name}`];
  return candidates.find((candidate) => files.has(candidate));
}

function checkCpp(file, text, files, report) {
  const layer = layerOf(file, CPP_LAYERS);
  if (!layer) return report(file, 1, 'this folder has no row in CPP_LAYERS');
  text.split('\n').forEach((line, index) => {
    const name = (QUOTED_INCLUDE.exec(line) ?? ANGLE_INCLUDE.exec(line))?.[1];
    if (!name || name.endsWith('.glsl')) return;
    for (const rule of OWNED_HEADERS) {
      if (rule.header.test(name) && !rule.folders.some((folder) => within(file, folder))) {
        report(file, index + 1, `includes ${name}; only these may: ${rule.folders.join(', ') || 'none'}`);
      }
    }
    const target = includedFile(file, name, files);
    const targetLayer = target && layerOf(target, CPP_LAYERS);
    if (targetLayer && targetLayer !== layer && !CPP_LAYERS[layer].includes(targetLayer)) {
      report(file, index + 1, `${layer} includes ${target}; it may include: ${CPP_LAYERS[layer].join(', ') || 'nothing of ours'}`);
    }
  });
  codeOnly(text)
    .split('\n')
    .forEach((line, index) => {
      for (const rule of OWNED_CALLS) {
        const found = rule.call.exec(line);
        if (found && !rule.unless?.test(file) && !rule.folders.some((folder) => within(file, folder))) report(file, index + 1, `${found[0]}: ${rule.why}`);
      }
    });
}

/** What a module imports, with the lines where the statements begin. */
function importsOf(text) {
  const code = text.replace(/\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' ')).replace(/^[ \t]*\/\/.*/gm, '');
  return [...code.matchAll(JS_IMPORT)].map((found) => ({ name: found[1], index: code.slice(0, found.index).split('\n').length - 1 }));
}

/** @returns {string[]} Names of the modules that a module imports, as it names them. */
export const importedNames = (text) => importsOf(text).map(({ name }) => name);

function checkJs(file, text, dependencies, report) {
  const layer = layerOf(file, JS_LAYERS);
  if (!layer) return report(file, 1, 'this folder has no row in JS_LAYERS');
  const rule = JS_LAYERS[layer];
  for (const { name, index } of importsOf(text)) {
    if (name.startsWith('node:')) {
      if (rule.browser) report(file, index + 1, `imports ${name}, but runs in browsers too`);
    } else if (!name.startsWith('.')) {
      const packageName = name
        .split('/')
        .slice(0, name.startsWith('@') ? 2 : 1)
        .join('/');
      if (rule.builtinsOnly) report(file, index + 1, `imports ${name}, but runs before npm packages are there`);
      else if (!rule.development && !rule.bundled && packageName !== 'telar' && !dependencies.has(packageName))
        report(file, index + 1, `imports ${name}, which is not in dependencies`);
    } else {
      const target = path.posix.join(path.posix.dirname(file), name);
      if (!within(target, 'js')) {
        if (!rule.development && !target.endsWith('.json') && !target.endsWith('.node')) report(file, index + 1, `imports ${target} from outside js/`);
      } else if (!within(target, layer) && !rule.imports.some((folder) => within(target, folder))) {
        report(file, index + 1, `${layer} imports ${target}; it may import: ${rule.imports.join(', ') || 'nothing of ours'}`);
      }
    }
  }
}

/**
 * @param {Map<string, string>} files - Path from the root (with /) to text: sources under renderer/, addon/ and js/.
 * @param {Set<string>} dependencies - Names in package.json's dependencies and peerDependencies.
 * @returns {string[]} `path:line: what is wrong`
 */
export function layerViolations(files, dependencies) {
  const found = [];
  const report = (file, line, text) => found.push(`${file}:${line}: ${text}`);
  for (const [file, text] of files) {
    if (/\.(h|cpp|inl)$/.test(file)) checkCpp(file, text, files, report);
    else if (/\.(mjs|cjs)$/.test(file)) checkJs(file, text, dependencies, report);
  }
  return found;
}

/** Folder (or file) of a layer's tests: of the same name under test/cpp or test/js, else as TESTED_IN has it. */
const testsOf = (layer) => TESTED_IN[layer] ?? (layer.startsWith('js/') ? `test/${layer}` : `test/cpp/${layer.replace('renderer/', '')}`);

/**
 * @param {string[]} tests - Paths of the test files from the root.
 * @returns {string[]} The layers that nothing tests. A room of C++ has a folder of tests too; one of JavaScript is tested with its layer.
 */
export function layersWithoutTests(tests) {
  const folders = [...Object.keys(CPP_LAYERS), ...Object.keys(JS_LAYERS).map((layer) => layer.split('/').slice(0, 2).join('/'))];
  const layers = [...new Set(folders.filter((layer) => !/\.\w+$/.test(layer)))];
  return layers.filter((layer) => !tests.some((file) => within(file, testsOf(layer)))).map((layer) => `${layer}: no test in ${testsOf(layer)}`);
}

/**
 * @param {string[]} tests - Paths of the test files from the root.
 * @returns {string[]} Tests of a layer with rooms that lie in none of them.
 */
export function testsOutsideRooms(tests) {
  const rooms = ASSET_ORDER.map(testsOf);
  return tests.filter((file) => within(file, testsOf('renderer/asset')) && !rooms.some((room) => within(file, room)));
}

/**
 * @param {Map<string, string>} files
 * @returns {string[]} `path:line: what is wrong` in tests of C++: a test that takes any Error takes one of another cause as well.
 */
export function errorsWithoutCode(files) {
  return [...files].flatMap(([file, text]) =>
    [...codeOnly(text).matchAll(/\b(?:EXPECT|ASSERT)_(?:THROW\s*\([^;]*?\bError\s*\)|ANY_THROW\b)/g)].map(
      (found) => `${file}:${codeOnly(text).slice(0, found.index).split('\n').length}: name the code, with EXPECT_ERROR of test/cpp/expect_error.h`,
    ),
  );
}

/**
 * @param {Map<string, string>} files
 * @param {number} limit
 * @returns {string[]} The files that have more lines.
 */
export function longFiles(files, limit) {
  const lines = (text) => text.split('\n').length - 1;
  return [...files].filter(([, text]) => lines(text) > limit).map(([file, text]) => `${file} has ${lines(text)} lines, more than ${limit}`);
}
