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
  throw new RemoteError(isProblem ? await response.json() : { code: `HTTP ${response.status}`, message: await response.text() });
}

/** @returns {Promise<object>} what js/view/session.mjs describes */
export const session = async () => (await request('session')).json();

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

/** @returns {Promise<Uint8Array>} a PNG file of the pixels */
export async function png({ width, height, data }) {
  const response = await request(`png?width=${width}&height=${height}`, {
    method: 'POST',
    headers: { 'content-type': 'application/octet-stream' },
    body: data,
  });
  return new Uint8Array(await response.arrayBuffer());
}
