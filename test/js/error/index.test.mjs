import assert from 'node:assert/strict';
import { test } from 'node:test';
import { TelarError, fromNative, toTelarError } from '../../../js/error/index.mjs';

test('an error has the facts of its row', () => {
  const error = new TelarError('L_NODES', 'too many', { pointer: '/nodes', limit: { name: 'L_NODES', max: 1, actual: 2 } });
  assert.ok(error instanceof Error);
  assert.ok(error instanceof TelarError);
  assert.equal(String(error), 'TelarError: too many');
  assert.equal(error.exit, 4);
  assert.equal(error.http, 413);
  assert.deepEqual(JSON.parse(JSON.stringify(error)), {
    code: 'L_NODES',
    kind: 'limit',
    message: 'too many',
    retryable: false,
    pointer: '/nodes',
    limit: { name: 'L_NODES', max: 1, actual: 2 },
  });
});

test('facts that are absent are absent from JSON, offset 0 is not absent', () => {
  assert.deepEqual(new TelarError('E_EMPTY', 'm').toJSON(), { code: 'E_EMPTY', kind: 'input', message: 'm', retryable: false });
  assert.equal(new TelarError('E_EMPTY', 'm', { offset: 0 }).toJSON().offset, 0);
});

test("a second copy of the module recognises the first one's errors", async () => {
  const copy = await import('../../../js/error/index.mjs?copy');
  assert.notEqual(copy.TelarError, TelarError);
  assert.ok(new copy.TelarError('E_JSON', 'm') instanceof TelarError);
  assert.ok(new TelarError('E_JSON', 'm') instanceof copy.TelarError);
  assert.ok(!(new Error('m') instanceof TelarError));
  assert.ok(!(null instanceof TelarError));
  assert.ok(!('text' instanceof TelarError));
});

test('a subclass keeps the ordinary meaning of instanceof', () => {
  class Narrow extends TelarError {}
  assert.ok(new Narrow('E_JSON', 'm') instanceof Narrow);
  assert.ok(new Narrow('E_JSON', 'm') instanceof TelarError);
  assert.ok(!(new TelarError('E_JSON', 'm') instanceof Narrow));
});

test('fromNative restores what toJSON wrote', () => {
  const error = new TelarError('E_ACCESSOR', 'bad', { pointer: '/accessors/1', offset: 12 });
  const restored = fromNative(JSON.parse(JSON.stringify(error)));
  assert.ok(restored instanceof TelarError);
  assert.deepEqual(restored.toJSON(), error.toJSON());
  assert.equal(fromNative(error), error);
});

test('an unknown code is internal and not lost', () => {
  assert.deepEqual(fromNative({ code: 'E_NEW', message: 'm' }).toJSON(), { code: 'X_INTERNAL', kind: 'internal', message: 'E_NEW: m', retryable: false });
  assert.equal(fromNative({ code: 'toString', message: 'm' }).code, 'X_INTERNAL');
  assert.equal(fromNative(undefined).code, 'X_INTERNAL');
});

test('messages are cut at 300 characters', () => {
  const { message } = new TelarError('E_JSON', 'x'.repeat(500));
  assert.equal(message.length, 300);
  assert.ok(message.endsWith('x...'));
});

test('foreign throws are classed and keep their cause', () => {
  assert.equal(toTelarError(AbortSignal.abort().reason).code, 'X_CANCELLED');
  assert.equal(toTelarError(new DOMException('late', 'TimeoutError')).code, 'X_TIMEOUT');
  const cause = new RangeError('r');
  assert.equal(toTelarError(cause).code, 'X_INTERNAL');
  assert.equal(toTelarError(cause).cause, cause);
  assert.equal(toTelarError('text').message, 'text');
  assert.equal(toTelarError(new Error('std::bad_alloc')).code, 'X_MEMORY');
  assert.equal(fromNative(new Error('std::bad_alloc')).code, 'X_MEMORY');
});
