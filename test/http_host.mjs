import { once } from 'node:events';
import { createServer } from 'node:http';

/**
 * An HTTP server of a test, on a free port of this machine.
 * @param {import('node:http').RequestListener} answer
 * @returns {Promise<{port: number, host: string, origin: string, stop: () => void}>}
 */
export async function startHost(answer) {
  const server = createServer(answer).listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  const host = `127.0.0.1:${port}`;
  const stop = () => {
    server.closeAllConnections();
    server.close();
  };
  return { port, host, origin: `http://${host}`, stop };
}
