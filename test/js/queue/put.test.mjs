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
