// app/thumbnails/route.js
import { toTelarError } from 'telar';
import { createPool } from 'telar/pool';

export const runtime = 'nodejs';
export const maxDuration = 30;

const MAX_BYTES = 32 * 2 ** 20;

/** `next dev` loads this file anew at each change; the pool stays. */
const pool = () => (globalThis.telarPool ??= createPool({ timeoutMs: 10_000 }));

export async function POST(request) {
  const length = Number(request.headers.get('content-length'));
  if (!(length > 0 && length <= MAX_BYTES)) return new Response('too large, or of unknown length', { status: 413 });
  const view = new URL(request.url).searchParams.get('view') ?? 'front';
  try {
    const model = await request.arrayBuffer();
    const drawer = await pool();
    const { data, info } = await drawer.render(model, { size: { width: 512, height: 512 }, camera: { view } }, { signal: request.signal });
    return new Response(data, { headers: { 'content-type': 'image/png', etag: `"${info.key}"` } });
  } catch (error) {
    const told = toTelarError(error);
    return Response.json(told, { status: told.http, headers: told.retryable ? { 'retry-after': '1' } : {} });
  }
}
