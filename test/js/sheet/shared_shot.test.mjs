// What a sheet takes of a shot, by each way that one may be given.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { sheetOptions } from '../../../js/pool/options_of_calls.mjs';
import { REQUESTS } from '../../../js/server/requests.mjs';
import { readOptions } from '../../../js/sheet/options.mjs';
import { SHARED, checkShared } from '../../../js/sheet/shared_shot.mjs';
import { SHOT } from '../../../js/shot/table/index.mjs';

const renderer = { renderAll: () => {} };

/** A value that a key of a shot may have; it need not be one. */
const VALUES = { size: { width: 8, height: 8 }, materials: { cloth: { preset: 'denim' } }, pose: { animation: 0 }, ghost: [], layers: ['depth'] };

test('each key of a shot is shared by the pictures, or refused with what to do', () => {
  const keys = Object.keys(SHOT.shape);
  assert.deepEqual(
    SHARED.filter((key) => !keys.includes(key)),
    [],
  );
  for (const key of keys) {
    const shot = { [key]: VALUES[key] ?? 'given' };
    const ways = [
      [() => readOptions({ renderer, shot }), 'options.shot'],
      [() => sheetOptions({}, { shot }, {}), 'options.shot'],
      [() => REQUESTS.sheet.keys.shot.check(shot, 'request.shot'), 'request.shot'],
    ];
    for (const [read, name] of ways) {
      if (SHARED.includes(key)) read();
      else assert.throws(read, ({ code, message }) => code === 'E_OPTION' && message.startsWith(`${name}.${key}: a sheet does not take it; `), key);
    }
  }
});

test('what is undefined is not given, and what is unknown is left to the shot', () => {
  checkShared({ materials: undefined, camra: {}, ...JSON.parse('{"__proto__": 1}') });
  assert.deepEqual(readOptions({ renderer, shot: undefined }).shot, {});
  assert.throws(() => sheetOptions({}, { shot: 'flat' }, {}), { code: 'E_OPTION', message: /^options\.shot: expected an object/ });
});

test('messages say what to do', () => {
  const refused = (shot, message) => assert.throws(() => checkShared(shot), { code: 'E_OPTION', message });
  refused({ ghost: [] }, /^options\.shot\.ghost: .*; give `ghost` to the views of the spec\. Of a shot it takes environment, /);
  assert.throws(() => checkShared({ pose: {} }), { pointer: '/shot/pose' });
  refused({ materials: {} }, /; write the cloth into the model: flats, lengths and colours are taken of the file\./);
});

test('the types have the same keys', () => {
  const types = readFileSync(new URL('../../../js/sheet/index.d.ts', import.meta.url), 'utf8');
  const [, keys] = /shot\?: Pick<Shot, ([^>]*)>/.exec(types);
  assert.deepEqual(
    keys.split(' | ').map((key) => key.slice(1, -1)),
    [...SHARED],
  );
});
