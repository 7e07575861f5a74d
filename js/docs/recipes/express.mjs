import express from 'express';
import { toTelarError } from 'telar';
import { createPool } from 'telar/pool';

const pool = await createPool({ timeoutMs: 10_000, maxWaiting: 32 });
const app = express();

app.post('/thumbnails', express.raw({ type: 'model/gltf-binary', limit: '32mb' }), async (request, response) => {
  const gone = new AbortController();
  response.on('close', () => gone.abort());
  const shot = { size: { width: 512, height: 512 }, camera: { view: request.query.view ?? 'front' } };
  const { data, info } = await pool.render(request.body, shot, { signal: gone.signal });
  response.set({ 'content-type': 'image/png', etag: `"${info.key}"`, 'x-content-type-options': 'nosniff' }).send(data);
});

app.use((error, request, response, next) => {
  if (response.headersSent || error.status) return next(error); // of express itself, as 413 for a body that is too large
  const told = toTelarError(error);
  if (told.retryable) response.set('retry-after', '1');
  response.status(told.http).json(told);
});

export const server = app.listen(Number(process.env.PORT ?? 3000), '127.0.0.1');

process.once('SIGTERM', () => server.close(() => pool.close()));
