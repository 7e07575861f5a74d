import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Color } from 'three';
import { parseColour, srgbToLinear } from '../../../js/shot/colour.mjs';

const three = (text) => new Color(text).toArray();

test('each CSS name is what three.js makes of it', () => {
  const names = Object.keys(Color.NAMES);
  assert.equal(names.length, 148);
  for (const name of names) assert.deepEqual(parseColour(name), three(name), name);
});

test('forms that three.js reads give the same bits', () => {
  const forms = [
    '#fff',
    '#0a7',
    '#123456',
    '#FEDCBA',
    'rgb(1, 2, 3)',
    'rgb(255,0,128)',
    'rgb(10%, 20%, 99%)',
    'rgb(300, 0, 0)',
    'rgba(9, 8, 7, 1)',
    'hsl(0, 0%, 50%)',
    'hsl(120, 100%, 25%)',
    'hsl(359.5, 33%, 77%)',
    'hsl(210, 60%, 40%)',
    'Red',
    ' navy ',
  ];
  for (let hue = 0; hue < 360; hue += 7) forms.push(`hsl(${hue}, ${hue % 101}%, ${(hue * 3) % 101}%)`);
  for (const form of forms) assert.deepEqual(parseColour(form), three(form.trim()), form);
});

test('all bytes pass the transfer function as in three.js', () => {
  for (let byte = 0; byte < 256; ++byte) assert.equal(srgbToLinear(byte / 255), three(`rgb(${byte},0,0)`)[0]);
});

test('modern CSS forms equal their old spelling', () => {
  assert.deepEqual(parseColour('rgb(1 2 3)'), parseColour('rgb(1,2,3)'));
  assert.deepEqual(parseColour('rgb(1 2 3 / 100%)'), parseColour('rgb(1,2,3)'));
  assert.deepEqual(parseColour('hsl(120deg 100% 25%)'), parseColour('hsl(120, 100%, 25%)'));
  assert.deepEqual(parseColour('hsl(-270, 100%, 25%)'), parseColour('hsl(90, 100%, 25%)'));
  assert.deepEqual(parseColour('#123456ff'), parseColour('#123456'));
  assert.deepEqual(parseColour('#123f'), parseColour('#123'));
});

test('what is no opaque colour is refused', () => {
  for (const text of [
    '',
    'bleu',
    '#12',
    '#12345',
    '#12345g',
    '#12345680',
    '#1238',
    'rgb(1,2)',
    'rgb(1,2,3,0.5)',
    'rgb(1%,2,3)',
    'hsl(1,2,3)',
    'transparent',
    'currentcolor',
    'constructor',
    '__proto__',
    'rgb(1,2,3',
    'url(x)',
    'rgb(NaN,0,0)',
    'hsl(1 2% 3% / 50%)',
  ]) {
    assert.equal(parseColour(text), undefined, text);
  }
});
