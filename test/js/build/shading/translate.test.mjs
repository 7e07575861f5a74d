import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import * as THREE from 'three';
import { shadingModule } from '../../../../js/build/shading/index.mjs';
import { conditionNames, withoutComments } from '../../../../js/build/shading/preprocess.mjs';
import { FAMILIES, shadingText } from '../../../../js/build/shading/translate.mjs';
import { LAYERS, texturesOf, textureName } from '../../../../js/material/table.mjs';
import { SLOTS } from '../../../../js/shot/shading_terms.mjs';
import { termDefine } from '../../../../js/three/shading/terms.mjs';

/** Texts in which three.js's own names stand for telar's. */
const hostText = ['host', 'host_maps', 'host_cloth', 'host_lights', 'host_area']
  .map((name) => withoutComments(readFileSync(new URL(`../../../../js/three/shading/${name}.glsl`, import.meta.url), 'utf8')))
  .join('\n');
const declared = new Set([...hostText.matchAll(/^(?:uniform \w+|in \w+|#define) (\w+)/gm)].map(([, name]) => name));

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
    assert.deepEqual(
      [...names].filter((name) => !name.startsWith('telar_')),
      [],
    );
    assert.doesNotMatch(threeText, /telar/);
  });

  test(`${family}: what it reads of three.js is there`, () => {
    const read = [...hostText.matchAll(/\b(?:USE_\w+|v[A-Z]\w+|\w+(?:Map|LUT|Color|Lights)|metalness|roughness|alphaTest|ltc_\d)\b/g)]
      .map(([word]) => word)
      .filter((word) => !declared.has(word));
    assert.ok(read.length > 20, `${read.length}`);
    assert.deepEqual(
      [...new Set(read)].filter((word) => !new RegExp(`\\b${word}\\b`).test(threeText)),
      [],
    );
    const cloth = new Set(
      LAYERS.filter(({ shadings }) => shadings)
        .flatMap(texturesOf)
        .map((texture) => `${textureName(texture)}Map`),
    );
    const inputs = [...declarations.matchAll(/(?<![\w.])(?:USE_\w+|v\w+MapUv|[a-z]\w*Map(?=, v))\b/g)]
      .map(([word]) => word)
      .filter((word) => !word.startsWith('telar_') && !cloth.has(word));
    assert.ok(inputs.length > 30, `${inputs.length}`);
    assert.deepEqual(
      [...new Set(inputs)].filter((word) => !new RegExp(`\\b${word}\\b`).test(threeText)),
      [],
    );
  });

  test(`${family}: has its own shading and no other, and every condition has a value`, () => {
    assert.equal(/\btelar_composedRadiance\(/.test(main), true);
    assert.equal(declarations.match(/^\w+ telar_composedRadiance\(/gm).length, 1);
    assert.match(declarations, new RegExp(`#define telar_SHADING_${family.toUpperCase()} 1\n`));
    assert.doesNotMatch(declarations, /#include/);
    const given = new Set([...declarations.matchAll(/^#define (\w+)/gm)].map(([, name]) => name));
    const terms = family === 'principled' ? Object.keys(SLOTS).map((slot) => `telar_${termDefine(slot)}`) : [];
    assert.doesNotMatch(declarations, /\b(?<!telar_)[A-Z]+_TERM\b/);
    assert.deepEqual(
      [...conditionNames(`${declarations}\n${main}`)].filter((name) => !given.has(name) && !terms.includes(name)),
      [],
    );
  });

  test(`${family}: js/dist has what shaders/ says`, { skip: !existsSync(new URL('../../../../js/dist/shading', import.meta.url)) && 'no js/dist' }, () => {
    const isFresh = readFileSync(new URL(`../../../../js/dist/shading/${family}.mjs`, import.meta.url), 'utf8') === shadingModule(family);
    assert.ok(isFresh, 'js/dist/shading is stale: node js/build/dist.mjs');
  });
}
