import assert from 'node:assert/strict';
import { test } from 'node:test';
import { putFiles } from '../../../js/queue/put.mjs';
import { startHost } from '../../http_host.mjs';

// Results that go to signed addresses; test/js/queue/same.test.mjs has what the queues make of it.

test('a host that says something without an end, once it has the file, holds nobody up', async (t) => {
  const host = await startHost(async (request, response) => {
    await request.toArray();
    response.writeHead(200).write('and so on');
  });
  t.after(host.stop);
  const [{ bytes, url }] = await putFiles([{ name: 'a.txt', type: 'text/plain', data: Buffer.from('text') }], [`${host.origin}/a.txt?signature=1`], {
    signal: AbortSignal.timeout(10_000),
  });
  assert.deepEqual([bytes, url], [4, `${host.origin}/a.txt`]);
});

test('an allowed host is the same in capitals and with the port of its scheme', async () => {
  const codeOf = (address, hosts) =>
    putFiles([{ name: 'a.txt', type: 'text/plain', data: Buffer.from('text') }], [address], { signal: AbortSignal.abort(new Error('allowed')), hosts }).catch(
      ({ code, message }) => code ?? message,
    );
  for (const [address, host] of [
    ['https://pictures.test/a', 'Pictures.Test'],
    ['https://pictures.test/a', 'pictures.test:443'],
    ['http://pictures.test:9000/a', 'PICTURES.test:9000'],
  ])
    assert.equal(await codeOf(address, [host]), 'allowed', host);
  for (const host of ['pictures.test:80', 'test', 'https://pictures.test', 'pictures.test.', 'name@other.test', ''])
    assert.equal(await codeOf('https://pictures.test/a', [host]), 'E_URI_DENIED', host);
});
