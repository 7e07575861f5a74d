import assert from 'node:assert/strict';
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { ResultFolder } from '../../../js/queue/result_folder.mjs';
import { listen } from '../../../js/server/index.mjs';
import { importMutant, outcomeOf } from './mutants.mjs';
import { ENDLESS, HOURS, MODELS, SHOT, bytesOf, openPool, post, problemOf } from './support.mjs';
import { startHost } from '../../http_host.mjs';
import { until } from '../../until.mjs';

// The store of results: what was drawn once is not drawn again, and a store that is damaged, full or gone costs no answer.

const THUMBNAILS = '/v1/thumbnails';

let pool, glb, root, host, origin;
/** Pictures that the pool was asked for. */
let drawn = 0;
/** What the host keeps, and how it answers. */
const bucket = new Map();
let mood = 'well';
/** What writings wait for. */
let held = Promise.resolve();
before(async () => {
  const [real, cloth] = await Promise.all([openPool(), MODELS.cloth()]);
  glb = cloth;
  const render = (...args) => {
    drawn += 1;
    return real.render(...args);
  };
  const sizing = Object.fromEntries(['load', 'factsOf', 'release'].map((name) => [name, (...args) => real[name](...args)]));
  pool = Object.defineProperty({ render, ...sizing, close: () => real.close() }, 'workers', { get: () => real.workers });
  root = mkdtempSync(path.join(tmpdir(), 'telar-store-'));
  host = await startHost(async (request, response) => {
    const { pathname, searchParams } = new URL(request.url, 'http://host');
    if (mood === 'never') return;
    if (mood === 'broken' || searchParams.get('signed') !== request.method) return response.writeHead(500).end();
    if (request.method === 'GET') return bucket.has(pathname) ? response.end(bucket.get(pathname)) : response.writeHead(403).end();
    const chunks = await request.toArray();
    await held;
    bucket.set(pathname, Buffer.concat(chunks));
    response.end();
  });
  ({ origin } = host);
});
after(async () => {
  host.stop();
  await pool.close();
  rmSync(root, { recursive: true });
});

const folder = () => mkdtempSync(path.join(root, 's'));
const addresses = () => ({ get: (name) => `${origin}/${name}?signed=GET`, put: async (name) => ({ url: `${origin}/${name}?signed=PUT` }) });
const shotOf = (exposure) => ({ ...SHOT, exposure });

/** A service for one use, of the module that is checked. */
async function withService(serve, options, use) {
  const service = await serve({ port: 0, pool, ...options });
  const ask = async (shot, headers) => {
    const before = drawn;
    const response = await post(service.url, THUMBNAILS, glb, { shot }, headers);
    const { status } = response;
    const facts = { type: response.headers.get('content-type'), tag: response.headers.get('etag'), name: response.headers.get('content-disposition') };
    return { status, facts, bytes: await bytesOf(response), isDrawn: drawn > before };
  };
  const counted = async (outcome) => {
    const text = await (await fetch(new URL('/metrics', service.url))).text();
    return Number(new RegExp(`^telar_store_total\\{outcome="${outcome}"\\} (\\d+)$`, 'm').exec(text)?.[1] ?? 0);
  };
  try {
    return await use({ ask, counted, url: service.url });
  } finally {
    await service.drain();
  }
}

/** What was stored before is there for the next service: the first one ended, and so has written all. */
async function twice(serve, store, between = () => {}) {
  const first = await withService(serve, { store }, ({ ask }) => ask(SHOT));
  between();
  return withService(serve, { store }, async ({ ask, counted }) => ({ first, second: await ask(SHOT), counted: await counted('damaged') }));
}

const onlyFile = (store) => path.join(store, ...readdirSync(store));

/** Checks by what they say, of `serve`. */
const CHECKS = {
  async 'in a folder: drawn once, then the same answer'(serve) {
    const { first, second } = await twice(serve, folder());
    assert.deepEqual([first.status, first.isDrawn, second.isDrawn], [200, true, false]);
    assert.deepEqual(second, { ...first, isDrawn: false });
  },
  async 'at addresses: drawn once, then the same answer'(serve) {
    bucket.clear();
    const { first, second } = await twice(serve, addresses());
    assert.deepEqual([first.isDrawn, second.isDrawn, bucket.size], [true, false, 1]);
    assert.deepEqual(second, { ...first, isDrawn: false });
  },
  async 'the end of the service waits for what is being written'(serve) {
    bucket.clear();
    let release;
    held = new Promise((resolve) => {
      release = resolve;
    });
    const service = await serve({ port: 0, pool, store: addresses() });
    await bytesOf(await post(service.url, THUMBNAILS, glb, { shot: SHOT }));
    const order = [];
    const draining = service.drain().then(() => order.push('ended'));
    await until(() =>
      fetch(service.url).then(
        () => false,
        () => true,
      ),
    );
    await sleep(300);
    order.push('written');
    release();
    await draining;
    assert.deepEqual([order, bucket.size], [['written', 'ended'], 1]);
  },
  async 'each shot and each type has its own'(serve) {
    await withService(serve, { store: folder() }, async ({ ask, counted }) => {
      const layered = { ...SHOT, layers: ['beauty', 'normal'] };
      const asked = [[SHOT], [layered, { accept: 'application/json' }], [SHOT, { accept: 'image/webp' }]];
      const all = [];
      for (const one of asked) all.push(await ask(...one));
      assert.deepEqual(
        all.map(({ isDrawn }) => isDrawn),
        [true, true, true],
      );
      await until(async () => (await counted('stored')) === 3);
      const before = drawn;
      for (const [i, one] of asked.entries()) assert.ok((await ask(...one)).bytes.equals(all[i].bytes));
      assert.deepEqual([drawn, await counted('hit')], [before, 3]);
    });
  },
  async 'a file that is damaged or cut is drawn again, and replaced'(serve) {
    const store = folder();
    let good;
    for (const damage of [
      (bytes) => bytes.subarray(0, -1),
      (bytes) => bytes.fill(0, bytes.length - 9),
      (bytes) => bytes.subarray(0, 20),
      () => Buffer.alloc(0),
    ]) {
      const { first, second } = await twice(serve, store, () => {
        good ??= readFileSync(onlyFile(store));
        writeFileSync(onlyFile(store), damage(Buffer.from(good)));
      });
      assert.deepEqual([second.isDrawn, second.status], [true, 200]);
      assert.ok(second.bytes.equals(first.bytes));
      const { bytes, isDrawn } = await withService(serve, { store }, ({ ask }) => ask(SHOT));
      assert.deepEqual([bytes.equals(first.bytes), isDrawn], [true, false]);
    }
  },
  async 'a folder is bounded: what was read longest ago goes'(serve) {
    const store = folder();
    await withService(serve, { store }, ({ ask }) => ask(shotOf(1)));
    const { size } = statSync(onlyFile(store));
    const oldest = onlyFile(store);
    utimesSync(oldest, 1, 1);
    await withService(serve, { store, storeBytes: Math.floor(3.5 * size) }, async ({ ask, counted }) => {
      // Whatever stands behind the key, files count.
      for (const ending of ['-avif', '-avif80', '-none', '-avif80-warning'])
        writeFileSync(path.join(store, `${'0'.repeat(64)}${ending}.result`), Buffer.alloc(size));
      for (const name of readdirSync(store)) utimesSync(path.join(store, name), 1, 1);
      for (const exposure of [1, 2, 3, 4, 5]) {
        await ask(shotOf(exposure));
        await until(async () => (await counted('stored')) + (await counted('hit')) >= exposure);
        // Files of one tick of the clock have no order.
        for (const name of readdirSync(store)) {
          const file = path.join(store, name);
          if (statSync(file).mtimeMs > 1e6 * exposure + 1e6) utimesSync(file, 1000 * exposure, 1000 * exposure);
        }
      }
      assert.ok(readdirSync(store).length <= 3);
      assert.deepEqual([(await ask(shotOf(5))).isDrawn, (await ask(shotOf(1))).isDrawn], [false, true]);
    });
  },
  async 'several that share a folder keep it within the bound and a tenth for each'() {
    const [store, maxBytes, size] = [folder(), 1e6, 20_000];
    const all = await Promise.all(Array.from({ length: 4 }, () => ResultFolder.open(store, maxBytes)));
    const taken = () => readdirSync(store).reduce((sum, name) => sum + statSync(path.join(store, name)).size, 0);
    for (let i = 0; i < 80; ++i) {
      await all[i % 4].put(String(i).padStart(64, '0'), Buffer.alloc(size));
      assert.ok(taken() <= maxBytes + 4 * (maxBytes / 10 + size), `${taken()}`);
    }
  },
  async 'a store that fails costs no answer, and is counted'(serve) {
    const store = folder();
    await withService(serve, { store }, async ({ ask, counted }) => {
      rmSync(store, { recursive: true });
      writeFileSync(store, 'a file where the folder was');
      assert.deepEqual([(await ask(SHOT)).status, (await ask(shotOf(2))).status], [200, 200]);
      await until(async () => (await counted('failed')) === 4);
    });
    mood = 'broken';
    try {
      await withService(serve, { store: addresses() }, async ({ ask, counted }) => {
        assert.equal((await ask(SHOT)).status, 200);
        await until(async () => (await counted('failed')) === 2);
      });
    } finally {
      mood = 'well';
    }
  },
  async 'a store that never answers is part of the time of the answer'(serve) {
    mood = 'never';
    try {
      await withService(serve, { store: addresses(), deadlineMs: 300 }, async ({ url }) => {
        const { status, code } = await problemOf(await post(url, THUMBNAILS, glb, { shot: ENDLESS }));
        assert.deepEqual([status, code], [504, 'X_TIMEOUT']);
      });
    } finally {
      mood = 'well';
    }
  },
  async 'callbacks that never give an address are part of the time of the answer, and keep no service from ending'(serve) {
    const never = () => new Promise(() => {});
    await withService(serve, { store: { get: never }, deadlineMs: 300 }, async ({ url }) => {
      const { status, code } = await problemOf(await post(url, THUMBNAILS, glb, { shot: SHOT }));
      assert.deepEqual([status, code], [504, 'X_TIMEOUT']);
    });
    const { status, isDrawn } = await withService(serve, { store: { put: never } }, ({ ask }) => ask(SHOT));
    assert.deepEqual([status, isDrawn], [200, true]);
  },
  async 'what another service stored is no larger than this one draws'(serve) {
    const store = folder();
    const shot = { ...SHOT, size: undefined, scale: '1:10', output: { ppi: 20 } };
    const wide = await withService(serve, { store }, ({ ask }) => ask(shot));
    const width = wide.bytes.readUInt32BE(16);
    const asked = await withService(serve, { store, side: width - 1 }, async ({ ask, url }) => {
      const { links } = await (await post(url, THUMBNAILS, glb, { shot }, { prefer: 'respond-async' })).json();
      const job = await until(async () => {
        const told = await (await fetch(new URL(links.self, url))).json();
        return ['failed', 'done'].includes(told.state) && told;
      });
      return [await ask(shot), job];
    });
    assert.deepEqual([wide.status, asked[0].status, JSON.parse(asked[0].bytes).code, asked[1].error?.code], [200, 413, 'L_OUTPUT_SIZE', 'L_OUTPUT_SIZE']);
    const same = await withService(serve, { store, side: 4096 }, ({ ask }) => ask(shot));
    assert.deepEqual([same.status, same.isDrawn, same.bytes.equals(wide.bytes)], [200, false, true]);
  },
  async 'jobs have it too'(serve) {
    const store = folder();
    const { bytes } = await withService(serve, { store }, ({ ask }) => ask(SHOT));
    await withService(serve, { store, jobMs: HOURS }, async ({ url }) => {
      const before = drawn;
      const { links } = await (await post(url, THUMBNAILS, glb, { shot: SHOT }, { prefer: 'respond-async' })).json();
      await until(async () => (await (await fetch(new URL(links.self, url))).json()).state === 'done');
      assert.ok((await bytesOf(await fetch(new URL(`${links.self}/result`, url)))).equals(bytes));
      assert.equal(drawn, before);
    });
  },
};
/** Milliseconds after which a check that passes would have passed. */
const HANG_MS = 2500;

/** What is wrong in js/server, by the beginning of the check that must find it. */
const FAULTS = [
  ['in a folder', 'result_folder.mjs', 'await writeFileAtomically(this.#file(name), bytes);', ''],
  ['each shot', 'stored_result.mjs', 'at += length;', 'at += length + 1;'],
  ['the end of the service', 'service.mjs', 'await this.#store?.idle();', 'this.#store = undefined;'],
  ['at addresses', 'result_addresses.mjs', "method: 'PUT'", "method: 'POST'"],
  ['at addresses', 'result_addresses.mjs', 'response.status === 404 || response.status === 403', 'true'],
  ['each shot', 'result_folder.mjs', '`${name}${ENDING}`', '`one${ENDING}`'],
  ['a file that is damaged', 'stored_result.mjs', '!bytes.subarray(MAGIC.length, BEGIN).equals(sha256([rest]))', 'bytes.length < BEGIN'],
  ['a folder is bounded', 'result_folder.mjs', 'this.#written += bytes.byteLength;', ''],
  ['a folder is bounded', 'result_folder.mjs', 'a.mtimeMs - b.mtimeMs', 'b.mtimeMs - a.mtimeMs'],
  ['a store that fails', 'result_store.mjs', "this.#count('failed', error);\n      return undefined;", 'throw error;'],
  ['a store that never', 'result_addresses.mjs', 'AbortSignal.any([signal, AbortSignal.timeout(MOST_MS)])', 'AbortSignal.timeout(MOST_MS)'],
  ['what another service', 'service.mjs', 'checkStored(task, kept);', ''],
  ['jobs have it', 'service.mjs', 'const key = this.#store && (await keyOf(task));', 'const key = undefined;'],
];
for (const [name, check] of Object.entries(CHECKS)) {
  test(name, () => check(listen));
  for (const [beginning, file, right, wrong] of FAULTS) {
    if (!name.startsWith(beginning)) continue;
    test(`planted: ${wrong || `no ${right}`}. Found by: ${name}`, async () => {
      const planted = await importMutant([[file, right, wrong]]);
      assert.notEqual(await outcomeOf(() => check(planted.listen), { hangMs: HANG_MS }), 'passes');
    });
  }
}

test('a folder from which nothing can be removed keeps no service from starting', async () => {
  const store = folder();
  mkdirSync(path.join(store, `${'0'.repeat(64)}.result`));
  writeFileSync(path.join(store, `${'1'.repeat(64)}.result`), Buffer.alloc(2000));
  assert.equal((await withService(listen, { store, storeBytes: 1 }, ({ ask }) => ask(SHOT))).status, 200);
});

test('refused: a folder that may not be read', async (t) => {
  const store = folder();
  chmodSync(root, 0o711);
  chmodSync(store, 0);
  if (process.getuid() === 0) process.seteuid(65534);
  t.after(() => process.getuid() === 0 && process.seteuid(0));
  await assert.rejects(ResultFolder.open(store, 1e6), { code: 'E_OPTION', message: /^options\.store: the folder cannot be read \(EACCES\)$/ });
});

for (const [store, message] of [
  ['', /^options\.store: expected a folder, or \{get, put\}/],
  [{}, /^options\.store: expected a folder, or \{get, put\}/],
  [{ get: 'x' }, /^options\.store: expected a folder, or \{get, put\}/],
  ['/dev/null/store', /^options\.store: the folder cannot be made \(ENOTDIR\)$/],
]) {
  test(`refused: ${JSON.stringify(store)}`, () => assert.rejects(listen({ port: 0, pool, store }), { code: 'E_OPTION', message }));
}
