import { createPool } from 'telar/pool';

const MODEL_BYTES = 64 * 2 ** 20;
const pool = await createPool({ timeoutMs: 20_000 });

async function read(url, signal) {
  const answer = await fetch(url, { signal, redirect: 'error' });
  if (answer.status === 404) return null;
  if (!answer.ok) throw new Error(`the store answered ${answer.status}`);
  if (Number(answer.headers.get('content-length') ?? Number.POSITIVE_INFINITY) > MODEL_BYTES)
    throw new Error('the object is too large, or does not tell its length');
  return new Uint8Array(await answer.arrayBuffer());
}

/**
 * Draws a model of a bucket into the bucket.
 * @param {string} key - Of the model, as garments/1234/shirt.gltf
 * @param {object} shot
 * @param {{sign: (method: 'GET' | 'PUT', key: string) => Promise<string>, signal?: AbortSignal}} options - sign: a presigned URL
 * @returns {Promise<string>} Key of the picture: the same bytes and shot have the same key, so that it may be cached for ever.
 */
export async function thumbnail(key, shot, { sign, signal }) {
  const folder = key.slice(0, key.lastIndexOf('/') + 1);
  const model = await read(await sign('GET', key), signal);
  if (!model) throw new Error(`${key} is not in the bucket`);
  const { data, info } = await pool.render(model, shot, {
    signal,
    // What a .gltf names lies beside it; names that lead out of its folder were refused before this is called.
    resolve: async (uri, options) => read(await sign('GET', folder + uri), options.signal),
  });
  const picture = `thumbnails/${info.key}.png`;
  const headers = { 'content-type': 'image/png', 'cache-control': 'public, max-age=31536000, immutable' };
  const put = await fetch(await sign('PUT', picture), { method: 'PUT', body: data, headers, signal });
  if (!put.ok) throw new Error(`the store answered ${put.status}`);
  return picture;
}

export const close = () => pool.close();
