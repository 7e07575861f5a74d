import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import {
  chmodSync,
  copyFileSync,
  createReadStream,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parse } from 'yaml';
import { withCode } from '../../../js/build/docs/recipes.mjs';
import { embedShot } from '../../../js/compare/index.mjs';
import '../built.mjs';
import { startHost } from '../../http_host.mjs';

// The files of js/docs/recipes run as a reader runs them: in a project of their own that has telar installed.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const RECIPES = path.join(ROOT, 'js/docs/recipes');
const TSHIRT = path.join(ROOT, 'js/assets/tshirt.glb');
const VELVET = path.join(ROOT, 'js/assets/cloths/velvet.glb');
const isPng = (bytes) => Buffer.from(bytes).toString('latin1', 1, 4) === 'PNG';

/** A project with the recipes, packages by name, and shirt.glb. */
function project(t, { packages = [] } = {}) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-recipe-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  mkdirSync(path.join(folder, 'node_modules/.bin'), { recursive: true });
  symlinkSync(ROOT, path.join(folder, 'node_modules/telar'));
  symlinkSync(path.join(ROOT, 'js/cli/telar.mjs'), path.join(folder, 'node_modules/.bin/telar'));
  for (const name of packages) symlinkSync(path.join(ROOT, 'node_modules', name), path.join(folder, 'node_modules', name));
  for (const name of readdirSync(RECIPES)) copyFileSync(path.join(RECIPES, name), path.join(folder, name));
  copyFileSync(TSHIRT, path.join(folder, 'shirt.glb'));
  return folder;
}

/** Runs a program to its end. @returns {Promise<{code: number, stdout: string, stderr: string}>} */
async function run(command, args, cwd, env = {}) {
  const child = spawn(command, args, { cwd, env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
  const out = { stdout: '', stderr: '' };
  for (const name of ['stdout', 'stderr']) child[name].setEncoding('utf8').on('data', (text) => (out[name] += text));
  const [code] = await once(child, 'close');
  return { code, ...out };
}

/** Runs JavaScript in a project; what it writes with console.log(JSON). */
async function driven(folder, text, { flags = [], env } = {}) {
  const { code, stdout, stderr } = await run(process.execPath, [...flags, '--input-type=module', '-e', text], folder, env);
  assert.equal(code, 0, stderr);
  return JSON.parse(stdout.trim().split('\n').at(-1));
}

test('each file is shown by a page, and each page shows what lies there', () => {
  const names = readdirSync(RECIPES);
  const pages = names.filter((name) => name.endsWith('.md')).map((name) => readFileSync(path.join(RECIPES, name), 'utf8'));
  const shown = pages.flatMap((page) => [...page.matchAll(/<!-- code: (\S+) -->/g)].map(([, name]) => name));
  assert.deepEqual(shown.sort(), names.filter((name) => !name.endsWith('.md')).sort());
  const textOf = (name) => readFileSync(path.join(RECIPES, name), 'utf8');
  for (const page of pages) assert.equal(withCode(page, textOf), page, 'npm run docs');
  assert.notEqual(
    withCode(pages[0], () => 'planted'),
    pages[0],
  );
});

test('Express: a picture, an error with its status, a body that is too large', async (t) => {
  const folder = project(t, { packages: ['express'] });
  const answers = await driven(
    folder,
    `import { readFileSync } from 'node:fs';
     import { once } from 'node:events';
     const { server } = await import('./express.mjs');
     if (!server.listening) await once(server, 'listening');
     const url = 'http://127.0.0.1:' + server.address().port + '/thumbnails?view=';
     const post = async (view, body) => {
       const answer = await fetch(url + view, { method: 'POST', headers: { 'content-type': 'model/gltf-binary' }, body });
       const bytes = Buffer.from(await answer.arrayBuffer());
       return [answer.status, answer.headers.get('etag')?.length ?? 0, bytes.toString('latin1', 1, 4), bytes.toString('utf8').slice(0, 200)];
     };
     const shirt = readFileSync('shirt.glb');
     console.log(JSON.stringify([await post('back', shirt), await post('front', shirt.subarray(0, 1000)), await post('sideways', shirt), await post('front', Buffer.alloc(33 * 2 ** 20))]));
     process.emit('SIGTERM');`,
    { env: { PORT: '0' } },
  );
  assert.deepEqual(
    answers.map(([status]) => status),
    [200, 422, 400, 413],
  );
  assert.deepEqual(answers[0].slice(1, 3), [66, 'PNG']);
  assert.match(answers[1][3], /"code":"E_GLB/);
  assert.match(answers[2][3], /"code":"E_SHOT".*camera/);
});

test('Next.js: the handler answers requests, and the configuration names what is not bundled', async (t) => {
  const folder = project(t);
  const answers = await driven(
    folder,
    `import { readFileSync } from 'node:fs';
     const route = await import('./next_route.mjs');
     const { default: config } = await import('./next_config.mjs');
     const post = async (body, length = body.length) => {
       const request = new Request('http://localhost/thumbnails?view=back', { method: 'POST', body, headers: length ? { 'content-length': String(length) } : {} });
       const answer = await route.POST(request);
       return [answer.status, Buffer.from(await answer.arrayBuffer()).toString('latin1', 1, 4)];
     };
     const shirt = readFileSync('shirt.glb');
     const told = [await post(shirt), await post(shirt.subarray(0, 500)), await post(shirt, 2 ** 30), await post(shirt, 0)];
     await (await globalThis.telarPool).close();
     console.log(JSON.stringify([told, route.runtime, config]));`,
  );
  const [told, runtime, config] = answers;
  assert.deepEqual(
    told.map(([status]) => status),
    [200, 422, 413, 413],
  );
  assert.equal(told[0][1], 'PNG');
  assert.equal(runtime, 'nodejs');
  assert.deepEqual(config.serverExternalPackages, ['telar']);
});

test('Lambda: a picture within 512 MB, with nothing to write to but /tmp; time that is over is 504', async (t) => {
  const folder = project(t);
  const [drawn, late, damaged, megabytes] = await driven(
    folder,
    `import { readFileSync } from 'node:fs';
     const { handler } = await import('./lambda.mjs');
     const event = (bytes) => ({ isBase64Encoded: true, body: bytes.toString('base64'), queryStringParameters: { view: 'back' } });
     const within = (ms) => ({ getRemainingTimeInMillis: () => ms });
     const shirt = readFileSync('shirt.glb');
     const drawn = await handler(event(shirt), within(60000));
     const late = await handler(event(shirt), within(1501));
     const damaged = await handler(event(shirt.subarray(0, 999)), within(60000));
     console.log(JSON.stringify([{ ...drawn, body: Buffer.from(drawn.body, 'base64').toString('latin1', 1, 4) }, late, damaged, process.resourceUsage().maxRSS / 1000]));
     process.exit(0);`,
    { env: { HOME: '/nonexistent', XDG_CACHE_HOME: '/tmp/cache' } },
  );
  assert.deepEqual([drawn.statusCode, drawn.body, drawn.isBase64Encoded], [200, 'PNG', true]);
  assert.equal(late.statusCode, 504);
  assert.match(late.body, /X_TIMEOUT/);
  assert.equal(damaged.statusCode, 422);
  assert.ok(megabytes < 512, `${megabytes} MB`);
});

test('S3: the model is read, its parts too, and the picture put under its key', async (t) => {
  const folder = project(t);
  const { json, binary } = splitGlb(readFileSync(VELVET));
  json.buffers[0].uri = 'velvet.bin';
  const store = new Map([
    ['/garments/1/velvet.gltf', Buffer.from(JSON.stringify(json))],
    ['/garments/1/velvet.bin', binary],
  ]);
  const { origin, stop } = await startHost(async (request, response) => {
    const url = new URL(request.url, 'http://store');
    if (url.searchParams.get('signed') !== `${request.method}${url.pathname}`) return response.writeHead(403).end();
    if (request.method === 'PUT') {
      store.set(url.pathname, Buffer.concat(await request.toArray()));
      return response.end();
    }
    const bytes = store.get(url.pathname);
    return bytes ? response.writeHead(200, { 'content-length': bytes.length }).end(bytes) : response.writeHead(404).end();
  });
  t.after(stop);
  const outcome = await driven(
    folder,
    `const { thumbnail, close } = await import('./s3.mjs');
     const sign = async (method, key) => '${origin}/' + key + '?signed=' + method + '/' + key;
     const key = await thumbnail('garments/1/velvet.gltf', { size: { width: 64, height: 64 } }, { sign });
     const missing = await thumbnail('garments/1/none.glb', {}, { sign }).catch((error) => error.message);
     const denied = await thumbnail('garments/1/velvet.gltf', {}, { sign: async (method, key) => (await sign(method, key)) + 'x' }).catch((error) => error.message);
     await close();
     console.log(JSON.stringify([key, missing, denied]));`,
  );
  assert.match(outcome[0], /^thumbnails\/[0-9a-f]{64}\.png$/);
  assert.ok(isPng(store.get(`/${outcome[0]}`)));
  assert.deepEqual(outcome.slice(1), ['garments/1/none.glb is not in the bucket', 'the store answered 403']);
});

/** JSON and binary chunk of a GLB. */
function splitGlb(glb) {
  const length = glb.readUInt32LE(12);
  return { json: JSON.parse(glb.toString('utf8', 20, 20 + length)), binary: glb.subarray(28 + length) };
}

test("the client's CI: within the gate for the same shot, over it where the model is another", async (t) => {
  const folder = project(t);
  for (const name of ['screenshots', 'models']) mkdirSync(path.join(folder, name));
  copyFileSync(VELVET, path.join(folder, 'models/velvet.glb'));
  chmodSync(path.join(folder, 'client_check.sh'), 0o755);
  const shot = { size: { width: 64, height: 64 }, camera: { view: 'front' } };
  writeFileSync(path.join(folder, 'shot.json'), JSON.stringify(shot));
  const drawn = await run('npx', ['telar', 'thumbnail', 'models/velvet.glb', '-o', 'velvet.png', '--shot', 'shot.json', '--json'], folder);
  assert.equal(drawn.code, 0, drawn.stderr);
  const resolved = JSON.parse(drawn.stdout).images[0].info.shot;
  writeFileSync(path.join(folder, 'screenshots/velvet.png'), embedShot(readFileSync(path.join(folder, 'velvet.png')), resolved));
  const same = await run('./client_check.sh', [], folder, { GATE: 'parity' });
  assert.equal(same.code, 0, same.stdout + same.stderr);
  assert.ok(existsSync(path.join(folder, 'report/velvet/index.html')));
  copyFileSync(path.join(ROOT, 'js/assets/cloths/denim.glb'), path.join(folder, 'models/velvet.glb'));
  const planted = await run('./client_check.sh', [], folder);
  assert.equal(planted.code, 1, planted.stdout + planted.stderr);
  const { jobs } = parse(readFileSync(path.join(folder, 'client_ci.yaml'), 'utf8'));
  assert.ok(jobs.pictures.steps.some(({ run: line }) => line === './client_check.sh'));
});

/** What the recipe takes of puppeteer, by playwright-core: its API is the same there. */
const PUPPETEER = `import { chromium } from 'playwright-core';
export default { launch: (options) => chromium.launch({ ...options, executablePath: process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium' }) };\n`;

test('from puppeteer: the picture before and the one after are the same', async (t) => {
  const folder = project(t, { packages: ['playwright-core'] });
  mkdirSync(path.join(folder, 'node_modules/puppeteer'));
  writeFileSync(path.join(folder, 'node_modules/puppeteer/package.json'), '{"name": "puppeteer", "type": "module", "main": "index.js"}');
  writeFileSync(path.join(folder, 'node_modules/puppeteer/index.js'), PUPPETEER);
  const { origin, stop } = await startHost((request, response) => {
    if (!request.url.startsWith('/three/')) return response.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html>');
    response.setHeader('content-type', 'text/javascript');
    return createReadStream(path.join(ROOT, 'node_modules', new URL(request.url, 'http://a').pathname)).pipe(response);
  });
  t.after(stop);
  for (const name of ['puppeteer_before.mjs', 'puppeteer_after.mjs']) {
    const { code, stderr } = await run(process.execPath, [name], folder, { PAGES: `${origin}/` });
    assert.equal(code, 0, stderr);
  }
  const compare = (actual) => run('npx', ['telar', 'compare', 'before.png', actual, '--gate', 'parity'], folder);
  const same = await compare('after.png');
  assert.equal(same.code, 0, same.stdout);
  writeFileSync(
    path.join(folder, 'planted.mjs'),
    readFileSync(path.join(folder, 'puppeteer_after.mjs'), 'utf8').replace('intensity: 3', 'intensity: 2.8').replace('after.png', 'planted.png'),
  );
  await run(process.execPath, ['planted.mjs'], folder);
  assert.equal((await compare('planted.png')).code, 1);
});

test('from screenshot-glb: each line draws what the line above it names', async (t) => {
  const folder = project(t);
  const { code, stderr } = await run('bash', ['screenshot_glb.sh'], folder);
  assert.equal(code, 0, stderr);
  const text = readFileSync(path.join(folder, 'screenshot_glb.sh'), 'utf8');
  const lines = [...text.matchAll(/^# screenshot-glb .*-o (\S+).*\n(npx telar .*-o (\S+).*)$/gm)];
  assert.equal(lines.length, 4);
  for (const [, wanted, , made] of lines) {
    assert.equal(made, wanted);
    assert.ok(readFileSync(path.join(folder, made)).length > 5000, made);
  }
});
