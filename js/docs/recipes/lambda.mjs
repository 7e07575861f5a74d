import { createRenderer, toTelarError } from 'telar';

const LIMIT_BYTES = 6 * 2 ** 20; // of an answer, as base64
const SPARE_MS = 1500; // for the answer, and for what is looked at only between two steps

/** One a running environment: it has one request at a time, and opening GL and the first picture take the most time. */
const renderer = await createRenderer({ cacheDirectory: '/tmp/telar', maxWaiting: 1 });

const answer = (statusCode, body) => ({ statusCode, headers: { 'content-type': 'application/json' }, body: JSON.stringify(body) });

/** An event of an HTTP API (payload 2.0): the model is the body. */
export async function handler(event, context) {
  try {
    const model = Buffer.from(event.body ?? '', event.isBase64Encoded ? 'base64' : 'utf8');
    const timeoutMs = Math.max(1, context.getRemainingTimeInMillis() - SPARE_MS);
    const view = event.queryStringParameters?.view ?? 'front';
    const { data, info } = await renderer.render(model, { size: { width: 512, height: 512 }, camera: { view } }, { timeoutMs });
    const body = data.toString('base64');
    if (body.length > LIMIT_BYTES) return answer(413, { message: 'the picture is larger than an answer may be: put it into a bucket' });
    return { statusCode: 200, headers: { 'content-type': 'image/png', etag: `"${info.key}"` }, isBase64Encoded: true, body };
  } catch (error) {
    const told = toTelarError(error);
    return answer(told.http, told);
  }
}
