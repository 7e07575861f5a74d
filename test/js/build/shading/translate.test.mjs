import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import * as THREE from 'three';
import { shadingModule } from '../../../../js/build/shading/index.mjs';
import { INPUTS } from '../../../../js/build/shading/names.mjs';
import { FAMILIES, shadingText } from '../../../../js/build/shading/translate.mjs';

/** Every chunk and program of three.js that a MeshPhysicalMaterial may take in. */
const threeText = [...Object.values(THREE.ShaderChunk), THREE.ShaderLib.physical.fragmentShader].join('\n');

test('stock three.js gives all that its own shading reads', () => {
  const { uniforms, features, vertexMain } = shadingText('three');
  assert.deepEqual({ uniforms, features, vertexMain }, { uniforms: [], features: [], vertexMain: '' });
});

for (const family of FAMILIES) {
  const { declarations, main } = shadingText(family);

  test(`${family}: no name of its own is one of three.js`, () => {
    const names = new Set([...declarations.matchAll(/^(?:struct|(?:const )?\w+) (\w+)(?=\(| \{| =)/gm)].map(([, name]) => name));
    assert.ok(names.size > 50, `${names.size}`);
    assert.deepEqual([...names].filter((name) => !name.startsWith('telar_')), []);
    assert.doesNotMatch(threeText, /telar/);
  });

  test(`${family}: what it reads of three.js is there`, () => {
    const words = new Set(Object.values(INPUTS).flatMap((text) => text.match(/[a-zA-Z]\w+/g)));
    const read = [...words].filter((word) => new RegExp(`\\b${word}\\b`).test(declarations));
    assert.ok(read.length > 30, `${read.length}`);
    const missing = read.filter((word) => !new RegExp(`\\b${word}\\b`).test(threeText));
    assert.deepEqual(missing.filter((word) => !['float', 'vec2', 'vec4'].includes(word) && !word.startsWith('telar_')), []);
  });

  test(`${family}: has its own shading and no other`, () => {
    assert.equal(/\btelar_composedRadiance\(/.test(main), true);
    assert.doesNotMatch(declarations, /SHADING_|UNLIT|#include/);
  });

  test(`${family}: js/dist has what shaders/ says`, { skip: !existsSync(new URL('../../../../js/dist/shading', import.meta.url)) && 'no js/dist' }, () => {
    const isFresh = readFileSync(new URL(`../../../../js/dist/shading/${family}.mjs`, import.meta.url), 'utf8') === shadingModule(family);
    assert.ok(isFresh, 'js/dist/shading is stale: node js/build/dist.mjs');
  });
}
