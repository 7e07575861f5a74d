/** The server behind the page. */

/** A failure that the server names: {code, message, ...} of the error table. */
class RemoteError extends Error {
  constructor(problem) {
    super(problem.message);
    this.code = problem.code;
  }
}

async function request(path, options) {
  let response;
  try {
    response = await fetch(path, options);
  } catch (cause) {
    if (cause.name === 'AbortError') throw cause;
    throw new RemoteError({ code: 'X_CLOSED', message: 'telar view does not answer: it has ended' });
  }
  if (response.ok) return response;
  const isProblem = response.headers.get('content-type')?.startsWith('application/problem+json');
  throw new RemoteError(isProblem ? await response.json() : { code: `HTTP ${response.status}`, message: `${path}: ${await response.text()}` });
}

/** @returns {Promise<object>} what js/view/session.mjs describes */
export const session = async () => (await request('session')).json();

/**
 * A file of the server, as a loader of three.js gives it.
 * @param {{loadAsync: (url: string) => Promise<object>}} loader
 * @param {string} path
 */
export async function loadedBy(loader, path) {
  const url = URL.createObjectURL(await (await request(path)).blob());
  try {
    return await loader.loadAsync(url);
  } finally {
    URL.revokeObjectURL(url);
  }
}

const post = async (path, body, signal) =>
  (await request(path, { method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(body), signal })).json();

/** @returns {Promise<object>} what SpecFile.describe in js/view/spec_file.mjs gives */
export const spec = async () => (await request('spec')).json();

/**
 * The length of a point of measure, by the server.
 * @param {{measure: object, index: number}} body
 * @param {AbortSignal} signal
 */
export const measure = (body, signal) => post('measure', body, signal);

/** @param {{version: string, callouts: object[], measures: object[]}} body @returns {Promise<{version: string}>} */
export const saveSpec = (body) => post('spec', body);

/**
 * The server's picture of a shot.
 * @param {object} shot not resolved
 * @param {AbortSignal} signal
 * @returns {Promise<{image: import('../../compare/image.mjs').Image, info: object}>}
 */
export async function draw(shot, signal) {
  const response = await request('draw', { method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(shot), signal });
  const form = await response.formData();
  const info = JSON.parse(form.get('info'));
  const data = new Uint8ClampedArray(await form.get('pixels').arrayBuffer());
  return { image: { width: info.width, height: info.height, data }, info };
}

/** Lines of JSON, each with as many bytes behind it as it says, from a stream of chunks. */
async function* toldOf(stream) {
  let held = new Uint8Array(0);
  const more = (chunk) => {
    const joined = new Uint8Array(held.length + chunk.length);
    joined.set(held);
    joined.set(chunk, held.length);
    held = joined;
  };
  const reader = stream.getReader();
  let line;
  for (;;) {
    const end = line ? line.bytes : held.indexOf(10);
    if (end >= 0 && held.length >= end) {
      const part = held.slice(0, end);
      held = held.slice(line ? end : end + 1);
      if (line) yield { ...line, data: part };
      line = line ? undefined : JSON.parse(new TextDecoder().decode(part));
      continue;
    }
    const { done, value } = await reader.read();
    if (done) return;
    more(value);
  }
}

/**
 * The same of a shot that takes long, with each picture so far.
 * @param {object} shot not resolved
 * @param {AbortSignal} signal
 * @param {(image: import('../../compare/image.mjs').Image, samples: number) => void} show
 * @returns {Promise<{image: import('../../compare/image.mjs').Image, info: object}>}
 */
export async function grow(shot, signal, show) {
  const response = await request('grow', { method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(shot), signal });
  const imageOf = ({ width, height }, data) => ({ width, height, data: new Uint8ClampedArray(data.buffer, data.byteOffset, data.length) });
  for await (const { preview, info, problem, data } of toldOf(response.body)) {
    if (problem) throw new RemoteError(problem);
    if (info) return { image: imageOf(info, data), info };
    if (!signal.aborted) show(imageOf(preview, data), preview.samples);
  }
  throw new RemoteError({ code: 'X_CLOSED', message: 'telar view does not answer: it has ended' });
}

/** @returns {Promise<Uint8Array>} a PNG file of the pixels */
export async function png({ width, height, data }) {
  const response = await request(`png?width=${width}&height=${height}`, {
    method: 'POST',
    headers: { 'content-type': 'application/octet-stream' },
    body: data,
  });
  return new Uint8Array(await response.arrayBuffer());
}
