import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { createHmac } from 'node:crypto';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { signThumbnail } from '../../../js/server/index.mjs';
import { Signatures, readSigningKeys } from '../../../js/server/signature.mjs';
import { importMutant } from './mutants.mjs';
import { MODELS, SHOT, at, bytesOf, logLines, openPool, post, problemOf, serve } from './support.mjs';

// Signed addresses of thumbnails: who may make them, what they say, and that neither answers nor log have a key.

const run = promisify(execFile);
const BIN = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const NEW = { key: '00112233445566778899aabbccddeeff', salt: 'a0a1' };
const OLD = { key: 'ffeeddccbbaa99887766554433221100', salt: 'b0' };
const OTHER = { key: '0123456789abcdef0123456789abcdef', salt: 'a0a1' };
const NOW = 2_000_000_000_000;
const ASKED = { shot: SHOT };

const pathOf = (address) => address.replace('/v1/thumbnails/', '');
const changed = (text, i) => `${text.slice(0, i)}${text[i] === 'A' ? 'B' : 'A'}${text.slice(i + 1)}`;

/** Checks of a module by what they say. */
const CHECKS = {
  'the signature is HMAC-SHA256 of salt, options and source': ({ signThumbnail: sign }) => {
    const [, , , signature, options, source, ...rest] = sign('shirt', ASKED, NEW).split('/');
    assert.deepEqual([JSON.parse(Buffer.from(options, 'base64url')), Buffer.from(source, 'base64url').toString(), rest], [ASKED, 'shirt', []]);
    const own = createHmac('sha256', Buffer.from(NEW.key, 'hex')).update(Buffer.concat([Buffer.from(NEW.salt, 'hex'), Buffer.from(`/${options}/${source}`)]));
    assert.equal(signature, own.digest('base64url'));
  },
  'what a key of the service has signed is opened, by the new key and by the old one'({ signThumbnail: sign, Signatures: Of, readSigningKeys: read }) {
    const signatures = new Of(read([NEW, OLD]));
    const query = [
      ['shot', JSON.stringify(SHOT)],
      ['failOn', 'none'],
      ['model', 'a/b?c=d'],
    ];
    for (const pair of [NEW, OLD]) assert.deepEqual(signatures.open(pathOf(sign('a/b?c=d', { ...ASKED, failOn: 'none' }, pair)), NOW).query, query);
  },
  'nothing else is opened: another key, another salt, another text, a part of the signature'({ signThumbnail: sign, Signatures: Of, readSigningKeys: read }) {
    const signatures = new Of(read([NEW, OLD]));
    const path = pathOf(sign('shirt', ASKED, NEW));
    const [signature, options, source] = path.split('/');
    const wrong = [
      pathOf(sign('shirt', ASKED, OTHER)),
      pathOf(sign('shirt', ASKED, { ...NEW, salt: OLD.salt })),
      ...[0, 20, signature.length + 2, path.length - 1].map((i) => changed(path, i)),
      `${signature.slice(0, 20)}/${options}/${source}`,
      `${signature}AAAA/${options}/${source}`,
      `${signature}/${options}${source}`,
      `${path}/more`,
      `/${options}/${source}`,
      '',
    ];
    for (const one of wrong) assert.throws(() => signatures.open(one, NOW), { code: 'E_SIGNATURE' }, one);
  },
  'an address has its time'({ signThumbnail: sign, Signatures: Of, readSigningKeys: read }) {
    const signatures = new Of(read([NEW]));
    const of = (expires) => pathOf(sign('shirt', { expires }, NEW));
    assert.equal(signatures.open(of(NOW / 1000 + 1), NOW).expires, NOW / 1000 + 1);
    for (const expires of [NOW / 1000, 0]) assert.throws(() => signatures.open(of(expires), NOW), { code: 'E_SIGNATURE', message: /its time|the time of/ });
  },
  'a wrong key is refused, and not told': ({ readSigningKeys: read }) => {
    const secret = 'deadbeef';
    for (const keys of [
      secret,
      [secret],
      [{ key: secret, salt: 'aa' }],
      [{ ...NEW, salt: '' }],
      [{ ...NEW, key: `${NEW.key}${secret}x` }],
      Array(17).fill(NEW),
    ]) {
      assert.throws(
        () => read(keys),
        (error) => error.code === 'E_OPTION' && !error.message.includes(secret),
      );
    }
  },
};
/** What is wrong in js/server/signature.mjs, by the check that must find it. */
const FAULTS = [
  [0, '.update(salt)', ''],
  [1, 'const matches = this.#keys.map', 'const matches = this.#keys.slice(0, 1).map'],
  [2, 'given.length === own.length && timingSafeEqual(given, own)', 'own.subarray(0, given.length).equals(given.subarray(0, own.length))'],
  [2, '`/${options}/${source}`))', '`/${options}/${source.slice(0, -1)}${source.at(-1)}`) && false)'],
  [2, 'parts.length !== 3', 'parts.length < 3'],
  [3, '!(expires * 1000 > now)', 'expires * 1000 + 1000 < now'],
  [4, 'key.length < 2 * KEY_BYTES', 'key.length < KEY_BYTES / 2'],
  [4, "throw wrong(at, '{key, salt}')", "throw wrongOption(at, '{key, salt}', pair)"],
];
for (const [i, [name, check]] of Object.entries(CHECKS).entries()) {
  test(name, async () => {
    check({ signThumbnail, Signatures, readSigningKeys });
    for (const [, right, wrong] of FAULTS.filter(([of]) => of === i)) {
      const planted = await importMutant([['signature.mjs', right, wrong]], 'signature.mjs');
      assert.throws(() => check(planted), undefined, `planted: ${wrong}`);
    }
  });
}

let pool, service, url, glb, drawn;
const log = logLines();
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  service = await serve({ pool, signingKeys: [NEW, OLD], resolve: (name) => (name === 'cloth' ? glb : null), logLevel: 'debug' }, { log });
  ({ url } = service);
  drawn = (await pool.render(glb, SHOT)).data;
});
after(async () => {
  await service.drain();
  await pool.close();
});

const get = (address, options) => fetch(new URL(address, url), options);

test('GET of a signed address: the picture, its tag, and caches until its time is over', async () => {
  const expires = Math.floor(Date.now() / 1000) + 100;
  const address = signThumbnail('cloth', { shot: { ...SHOT, materials: {} }, expires }, OLD);
  const response = await get(address);
  assert.equal(response.status, 200);
  assert.ok((await bytesOf(response)).equals(drawn));
  const [, seconds] = /^public, max-age=(\d+)$/.exec(response.headers.get('cache-control'));
  assert.ok(Number(seconds) <= 100, 'of 300');
  const unchanged = await get(address, { headers: { 'if-none-match': response.headers.get('etag') } });
  assert.equal(unchanged.status, 304);
  assert.ok(Number(/\d+$/.exec(unchanged.headers.get('cache-control'))[0]) <= 100);
  const head = await get(address, { method: 'HEAD' });
  assert.deepEqual([head.status, head.headers.get('content-length')], [200, String(drawn.length)]);
  assert.equal((await get(address, { method: 'POST' })).status, 405);
});

test('a long shot fits into an address', async () => {
  const shot = { ...SHOT, lights: Array.from({ length: 20 }, () => ({ type: 'ambient', intensity: 0.01, color: [0.1, 0.2, 0.3] })) };
  const address = signThumbnail('cloth', { shot }, NEW);
  assert.ok(address.length > 1000);
  assert.equal((await get(address)).status, 200);
});

test('references are taken from signed addresses alone, models in the request from anybody', async () => {
  const refused = [
    get(changed(signThumbnail('cloth', ASKED, NEW), 30)),
    get(signThumbnail('cloth', ASKED, OTHER)),
    get(signThumbnail('cloth', { ...ASKED, expires: 1 }, NEW)),
    fetch(at(url, '/v1/thumbnails', { model: 'cloth', shot: SHOT })),
    fetch(at(url, '/v1/inspect'), { method: 'POST', body: '{"model":"cloth"}', headers: { 'content-type': 'application/json' } }),
  ];
  for (const asking of refused) {
    const { status, code } = await problemOf(await asking);
    assert.deepEqual([status, code], [403, 'E_SIGNATURE']);
  }
  assert.equal((await post(url, '/v1/thumbnails', glb, { shot: SHOT })).status, 200);
});

test('what is signed is a request like any other', async () => {
  const told = async (model, asked) => {
    const { status, code } = await problemOf(await get(signThumbnail(model, asked, NEW)));
    return [status, code];
  };
  assert.deepEqual(await told('none', ASKED), [404, 'E_NOT_FOUND']);
  assert.deepEqual(await told('cloth', { shot: { exposure: -1 } }), [400, 'E_SHOT']);
  assert.deepEqual(await told('cloth', { shot: { environment: '/etc/passwd' } }), [400, 'E_SHOT']);
  assert.deepEqual(await told('cloth', { failOn: 'never' }), [400, 'E_REQUEST']);
});

test('a service without keys takes no signed addresses, and references as before', async () => {
  const other = await serve({ pool, resolve: () => glb });
  const { status, code } = await problemOf(await fetch(new URL(signThumbnail('cloth', ASKED, NEW), other.url)));
  assert.deepEqual([status, code], [403, 'E_SIGNATURE']);
  assert.equal((await fetch(at(other.url, '/v1/thumbnails', { model: 'cloth', shot: SHOT }))).status, 200);
  await other.drain();
});

test('the log has no key, no salt and no signature', () => {
  const text = JSON.stringify(log.lines);
  assert.ok(text.includes('E_SIGNATURE') && text.includes('"route":"/v1/thumbnails/*"'));
  const address = signThumbnail('cloth', ASKED, NEW);
  for (const secret of [NEW.key, OLD.key, ...pathOf(address).split('/')]) assert.ok(!text.includes(secret));
});

const sign = (argv, env = { TELAR_SIGN_KEY: `${NEW.key},${OLD.key}`, TELAR_SIGN_SALT: `${NEW.salt}, ${OLD.salt}` }) =>
  run(process.execPath, [BIN, 'sign', ...argv], { env: { ...process.env, ...env } });

test('telar sign: the address by the first key, with the shot of its flags', async () => {
  const { stdout } = await sign(['cloth', '--size', '48', '--url', `${url}/`, '--json']);
  const told = JSON.parse(stdout);
  assert.deepEqual(told, { ok: true, url: `${url}${signThumbnail('cloth', ASKED, NEW)}` });
  assert.ok((await bytesOf(await fetch(told.url))).equals(drawn));
  const timed = JSON.parse((await sign(['cloth', '--expires', '60', '--json'])).stdout);
  assert.ok(timed.expires > Date.now() / 1000 && timed.url.startsWith('/v1/thumbnails/'));
});

test('telar sign: what is wrong is told without the key', async () => {
  const WRONG = [
    [['cloth'], { TELAR_SIGN_KEY: '', TELAR_SIGN_SALT: '' }, /expected key and salt in TELAR_SIGN_KEY/],
    [['cloth'], { TELAR_SIGN_KEY: NEW.key, TELAR_SIGN_SALT: '' }, /expected as many keys as salts, got 1 and 0/],
    [['cloth'], { TELAR_SIGN_KEY: 'secret', TELAR_SIGN_SALT: 'aa' }, /at least 16 bytes in hexadecimal/],
    [['cloth', '--set', 'exposure=-1'], undefined, /shot\.exposure/],
    [['cloth', '--expires', 'soon'], undefined, /--expires: expected whole seconds, got "soon"/],
  ];
  for (const [argv, env, message] of WRONG) {
    const { code, stderr } = await sign(argv, env).catch((error) => error);
    assert.deepEqual([code, message.test(stderr)], [2, true], stderr);
    assert.ok(!stderr.includes('secret') && !stderr.includes(NEW.key));
  }
});
