import assert from 'node:assert/strict';
import { once } from 'node:events';
import net from 'node:net';
import { after, before, test } from 'node:test';
import { startServer } from '../../../js/view/server.mjs';
import './support.mjs';
import '../built.mjs';

// Clients that are slow on purpose: their connections end, however alive they are.

let view;
before(async () => {
  const session = { hasBasis: false, hasSpec: false, draw: assert.fail };
  view = await startServer({ session, times: { headersMs: 300, requestMs: 600, lookMs: 50 } });
});
after(() => view?.close());

/** What comes of a beginning, and a piece every 20 ms after it. */
async function drip(beginning, piece) {
  const socket = net.connect(view.port, '127.0.0.1');
  let said = '';
  socket.on('data', (chunk) => {
    said += chunk;
  });
  socket.on('error', () => {});
  await once(socket, 'connect');
  socket.write(beginning);
  const dripping = setInterval(() => socket.write(piece), 20);
  await once(socket, 'close');
  clearInterval(dripping);
  return said.split('\r\n')[0];
}

const headOf = (route, headers) => `POST ${new URL(view.url).pathname}${route} HTTP/1.1\r\nhost: 127.0.0.1:${view.port}\r\n${headers}`;

test('headers that never end', async () => {
  assert.equal(await drip(headOf('draw', ''), 'x-drip: 1\r\n'), 'HTTP/1.1 408 Request Timeout');
});

for (const [name, headers, piece] of [
  ['with its length', 'content-length: 1000000', ' '],
  ['in chunks', 'transfer-encoding: chunked', '1\r\n \r\n'],
]) {
  test(`a body ${name} that never ends`, async () => {
    const beginning = headOf('draw', `content-type: application/json\r\n${headers}\r\n\r\n`);
    assert.equal(await drip(beginning, piece), 'HTTP/1.1 408 Request Timeout');
  });
}
