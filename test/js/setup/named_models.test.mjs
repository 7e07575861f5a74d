import assert from 'node:assert/strict';
import { test } from 'node:test';
import { nameModels } from '../../../js/setup/named_models.mjs';

test('npm run thumbnail draws the bundled garment where nothing else is named', () => {
  for (const line of ['', '--view back', '-o x.png', '--shot -', '-o -', '--output - --shot shot.json', '--size 256']) {
    assert.equal(nameModels(line.split(' ')), false, line);
  }
  for (const line of [
    'shirt.glb',
    'file:///a/Shirt.GLTF -o x.png',
    '- -o x.png',
    '-o x.png -',
    '--shot s.json -',
    '-r models -o out',
    'models --recursive',
    '--manifest list.jsonl',
    '--manifest=list.jsonl',
    '--manifest -',
  ]) {
    assert.equal(nameModels(line.split(' ')), true, line);
  }
});
