import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { HOURS, MODELS, SHOT, at, bytesOf, openPool, problemOf, serve } from './support.mjs';
import { TelarError } from '../../../js/error/index.mjs';
import { References } from '../../../js/server/references.mjs';
import { startHost } from '../../http_host.mjs';

// References: nothing is fetched but from hosts that the owner allows, and then no more than a model may have.

let pool, glb, drawn, host, origin;
const asked = [];
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  drawn = (await pool.render(glb, SHOT)).data;
  host = await startHost((request, response) => {
    asked.push({ url: request.url, headers: request.headers });
    HOST[request.url.split('?')[0]]?.(response) ?? response.writeHead(404).end();
  });
  ({ origin } = host);
});
after(async () => {
  host.stop();
  await pool.close();
});

const endWith = (status, headers, body) => (response) => response.writeHead(status, headers).end(body);
const HOST = {
  '/model.glb': (response) => response.end(glb),
  '/away': (response) => response.writeHead(302, { location: `${origin}/model.glb` }).end(),
  '/broken': endWith(500, {}, 'secret of the host'),
  '/much': (response) => {
    const flood = setInterval(() => response.write(Buffer.alloc(65_536)), 1);
    response.on('close', () => clearInterval(flood));
    return response;
  },
  '/short': (response) => {
    response.writeHead(200, { 'content-length': 1000 }).write('glTF');
    setTimeout(() => response.destroy(), 20);
    return response;
  },
  '/never': (response) => response,
};

/** Asks for a thumbnail of a reference, of a service of its own. */
async function ask(reference, options, headers) {
  const service = await serve({ pool, ...options });
  try {
    const response = await fetch(at(service.url, '/v1/thumbnails', { model: reference, shot: SHOT }), { headers });
    return response.status === 200 ? { status: 200, bytes: await bytesOf(response) } : await problemOf(response);
  } finally {
    await service.drain();
  }
}

const denied = async (reference, options) => {
  const before = asked.length;
  const { status, code, message } = await ask(reference, options);
  assert.deepEqual([status, code], [422, 'E_URI_DENIED'], reference);
  assert.equal(asked.length, before, 'nothing was asked of the host');
  return message;
};

test("without the owner's leave no reference is opened, and no address is asked", async () => {
  assert.equal(await denied('shirt'), 'request.model: "shirt" is not opened, as this service resolves no references; send the model in the request');
  assert.match(await denied(`${origin}/model.glb`), /as its host is not allowed/);
  for (const allowHosts of [['models.example.com'], [origin.replace('http:', 'https:')], ['http://127.0.0.1:1'], [origin.replace('127.0.0.1', 'localhost')]]) {
    await denied(`${origin}/model.glb`, { allowHosts });
  }
});

test('addresses that only look as if they were of an allowed host', async () => {
  const { port } = host;
  const allowHosts = [`http://models.test:${port}`];
  for (const reference of [
    `http://models.test:${port}@127.0.0.1:${port}/model.glb`,
    `http://127.0.0.1:${port}/model.glb#http://models.test:${port}`,
    `http://models.test:${port}.127.0.0.1.nip.test/`,
    `http:\\\\127.0.0.1:${port}\\model.glb`,
    'file:///etc/passwd',
    '//127.0.0.1/model.glb',
  ]) {
    await denied(reference, { allowHosts });
  }
  assert.equal(
    await denied(`http://name:w@rd@127.0.0.1:${port}/model.glb`, { allowHosts: [origin] }),
    `request.model: "${origin}/model.glb" is not opened, as addresses with a name or a password are not; send the model in the request`,
  );
});

test('a model of an allowed host is drawn; nothing of the request goes there', async () => {
  const { status, bytes } = await ask(`${origin}/model.glb?signature=1`, { allowHosts: [origin] }, { cookie: 'secret', authorization: 'secret' });
  assert.equal(status, 200);
  assert.ok(bytes.equals(drawn));
  const { url, headers } = asked.at(-1);
  assert.equal(url, '/model.glb?signature=1');
  assert.ok(!JSON.stringify(headers).includes('secret'));
});

const FAILURES = {
  '/none': [404, 'E_NOT_FOUND', /^request\.model: there is no model "http:\/\/127\.0\.0\.1:\d+\/none"$/],
  '/away': [502, 'X_SOURCE', /answers with 302, and redirects are not followed$/],
  '/broken': [502, 'X_SOURCE', /answers with 500$/],
  '/short': [502, 'X_SOURCE', /breaks off$/],
  '/much': [413, 'L_FILE_BYTES', /^the model has more than 1000000 bytes$/],
};
for (const [path, [status, code, message]] of Object.entries(FAILURES)) {
  test(`a host that answers with ${path}`, async () => {
    const before = asked.length;
    const problem = await ask(`${origin}${path}?signature=1`, { allowHosts: [origin], requestBytes: 1_000_000 });
    assert.deepEqual([problem.status, problem.code], [status, code], problem.message);
    assert.match(problem.message, message);
    assert.equal(asked.length, before + 1, 'asked once, and nothing else');
  });
}

test('a host that never answers, and one that is not there', async () => {
  const late = await ask(`${origin}/never`, { allowHosts: [origin], uploadMs: HOURS, deadlineMs: 300 });
  assert.deepEqual([late.status, late.code], [504, 'X_TIMEOUT']);
  const nobody = await ask('http://127.0.0.1:1/model.glb', { allowHosts: ['http://127.0.0.1:1'] });
  assert.deepEqual([nobody.status, nobody.code, nobody.message], [502, 'X_SOURCE', '"127.0.0.1:1" cannot be reached']);
});

test('bytes of a reference count as they come, not when all are there', async () => {
  const references = new References({ allowHosts: [origin], maxBytes: 1e9 });
  const grown = [];
  const grow = (bytes) => {
    grown.push(bytes);
    if (bytes > 300_000) throw new TelarError('X_BUSY', 'full');
  };
  await assert.rejects(references.bytes(`${origin}/much`, new AbortController().signal, { grow }), { code: 'X_BUSY' });
  assert.ok(grown.length > 1 && grown.at(-1) < 1_000_000, `${grown}`);
});

test("the owner's callback: bytes of any kind, none, too many, what it throws", async () => {
  const answers = { bytes: glb, buffer: new Uint8Array(glb).buffer, none: null, much: Buffer.alloc(2000), text: 'glTF' };
  const resolve = async (reference, { signal }) => {
    assert.equal(signal.aborted, false);
    return answers[reference];
  };
  for (const reference of ['bytes', 'buffer']) assert.ok((await ask(reference, { resolve })).bytes.equals(drawn));
  const told = async (reference, options) => {
    const { status, code } = await ask(reference, { resolve, ...options });
    return [status, code];
  };
  assert.deepEqual(await told('none'), [404, 'E_NOT_FOUND']);
  assert.deepEqual(await told('absent'), [404, 'E_NOT_FOUND']);
  assert.deepEqual(await told('much', { requestBytes: 1000 }), [413, 'L_FILE_BYTES']);
  assert.deepEqual(await told('text'), [500, 'X_RESOLVE']);
  assert.deepEqual(await told('text', { resolve: () => new Promise(() => {}), deadlineMs: 300 }), [504, 'X_TIMEOUT']);
  assert.deepEqual(await told('text', { resolve: () => Promise.reject(new Error('no')) }), [500, 'X_RESOLVE']);
});

for (const allowHosts of [['a host'], ['https://models.test/folder'], ['https://name@models.test'], ['ftp://models.test'], ['']]) {
  test(`allowHosts: ${JSON.stringify(allowHosts)} is refused`, async () => {
    const error = await serve({ pool, allowHosts }).then(
      () => undefined,
      (thrown) => thrown,
    );
    assert.equal(error?.code, 'E_OPTION');
    assert.match(error.message, /^options\.allowHosts/);
  });
}
