import { readFileSync } from 'node:fs';
import { SLOTS } from '../../shot/shading_terms.mjs';
import { PREFIX } from '../../three/shading/material.mjs';
import { termDefine } from '../../three/shading/terms.mjs';
import { ARRAYS, CLOTH_EXPRESSIONS, COUNTS, EXPRESSIONS, FEATURES, FIXED, INPUTS, LEFT_OUT, OF_CLOTH } from './names.mjs';
import { conditionNames, decided, included, withoutComments } from './preprocess.mjs';

const SHADERS = new URL('../../../shaders/', import.meta.url);
const ADAPTER = new URL('../../three/shading/', import.meta.url);

/** The shadings that shaders/surface.frag tells apart by SHADING_X. */
export const FAMILIES = ['three', 'principled', 'fabric'];

/** Integers that a material of the principled shadings is compiled with. */
const TERMS = Object.keys(SLOTS).map(termDefine);

/** three.js declares the second set where a map has it. */
const SECOND_UV = `#ifdef USE_UV1\n#define ${PREFIX}uv1 uv1\n#else\n#define ${PREFIX}uv1 uv\n#endif`;

const VARYING = /^v[A-Z]/;
const VERTEX_DECLARATION = /^(?:uniform|out) \w+ (\w+);$/;

/** Where the part of surface.frag ends that declares. */
const MAIN = 'out vec4 fragmentColor;';

const DEFINITIONS = [/^struct (\w+)/gm, /^(?:const )?\w+ (\w+)\(/gm, /^const \w+ (\w+)/gm, /^#define (\w+)/gm];
const DECLARATION = /^(?:uniform|(?:flat )?in) \w+ (\w+)(?:\[.*\])?;$/;

const readAdapter = (file) => withoutComments(readFileSync(new URL(file, ADAPTER), 'utf8'));

const readShader = (file) => (LEFT_OUT.includes(file) ? '' : readFileSync(new URL(file, SHADERS), 'utf8'));

/** Texture coordinates that the vertex stage gives for what three.js has no map of: declarations, assignments. */
const VERTEX_FILES = ['material/fabric_varyings.glsl', 'material/fabric_uvs.glsl'];

/**
 * Text of one family of shadings for a MeshPhysicalMaterial of three.js: what surface.frag declares, under names of our own,
 * and js/three/shading/main.glsl.
 * @param {string} family - One of FAMILIES.
 * @returns {{declarations: string, main: string, vertexDeclarations: string, vertexMain: string, uniforms: string[],
 *   features: string[]}} `uniforms` and `features` (0 or 1) that a material has to give: three.js does not know them.
 */
export function shadingText(family) {
  const root = readShader('surface.frag');
  const source = root.slice(0, root.indexOf(MAIN)).replace(/^precision .*$/gm, '');
  const adapter = readAdapter('adapter.glsl');
  const main = readAdapter('main.glsl');
  const isCloth = family === 'fabric';
  const absent = Object.keys(OF_CLOTH).filter((name) => !OF_CLOTH[name].includes(family));
  const known = { ...FIXED, ...Object.fromEntries(absent.map((name) => [name, 0])), ...Object.fromEntries(FAMILIES.map((name) => [`SHADING_${name.toUpperCase()}`, Number(name === family)])) };
  const text = decided(`${adapter}\n${withoutComments(included(source, readShader))}`, known);
  const defined = new Set([...text.matchAll(/^#define (\w+)/gm)].map(([, name]) => name));
  const features = [...conditionNames(text)].filter((name) => !FEATURES[name] && !COUNTS[name] && !defined.has(name) && !TERMS.includes(name));
  const { kept, inputs } = withoutInputs(throughExpressions(text, isCloth ? { ...EXPRESSIONS, ...CLOTH_EXPRESSIONS } : EXPRESSIONS));
  const vertex = vertexText(inputs, features, known);
  const names = new Set([...namesIn(kept), ...inputs, ...features, ...vertex.inputs, ...vertex.features, ...Object.keys(FEATURES), ...Object.keys(COUNTS), ...TERMS]);
  const translate = (part) => renamed(part, names);
  return {
    declarations: [featureText(), ownFeatureText(features), translate(kept)].join('\n'),
    main: translate(decided(main, known)),
    vertexDeclarations: [ownFeatureText([...features, ...vertex.features]), translate(vertex.declarations)].join('\n'),
    vertexMain: translate(vertex.main),
    uniforms: [...inputs, ...vertex.inputs].filter((name) => !VARYING.test(name)),
    features: [...features, ...vertex.features],
  };
}

/** What the vertex stage adds for the varyings among `inputs`. */
function vertexText(inputs, features, known) {
  if (!inputs.some((name) => VARYING.test(name))) return { declarations: '', main: '', inputs: [], features: [] };
  const [declarations, main] = VERTEX_FILES.map((file) => decided(withoutComments(readShader(file)), known));
  return {
    declarations,
    main: `${SECOND_UV}\n${main.replaceAll(/\buv0\b/g, 'uv').replaceAll(/\buv1\b/g, `${PREFIX}uv1`)}`,
    inputs: declarations.split('\n').map((line) => VERTEX_DECLARATION.exec(line)?.[1]).filter(Boolean),
    features: [...main.matchAll(/\b(\w+_UV1) ==/g)].map(([, name]) => name).filter((name) => !features.includes(name)),
  };
}

/** Features that the material defines where it has them. */
const ownFeatureText = (features) => features.map((name) => `#ifndef ${PREFIX}${name}\n#define ${PREFIX}${name} 0\n#endif`).join('\n');

/**
 * The shaders that make mip levels (shaders/texture), as they are: for RawShaderMaterial.
 * @returns {Record<string, string>}
 */
export function textureShaders() {
  const files = {
    vertex: 'level.vert', slopeMoments: 'slope_moments.frag', slopeLevel: 'slope_level.frag', coverageMoments: 'coverage_moments.frag', coverageLevel: 'coverage_level.frag',
  };
  return Object.fromEntries(Object.entries(files).map(([name, file]) => [name, withoutComments(included(readShader(`texture/${file}`), readShader))]));
}

/** three.js's conditions as the 0 or 1 that shaders/ asks for. */
function featureText() {
  const features = Object.entries(FEATURES).map(([name, condition]) =>
    `#if ${condition}\n#define ${PREFIX}${name} 1\n#else\n#define ${PREFIX}${name} 0\n#endif`);
  return [...features, ...Object.entries(COUNTS).map(([name, count]) => `#define ${PREFIX}${name} ${count}`)].join('\n');
}

function throughExpressions(text, expressions) {
  let result = text;
  for (const [from, to] of Object.entries(expressions)) {
    if (!result.includes(from)) throw new Error(`js/build/shading/names.mjs: no shader reads ${from} any more`);
    result = result.replaceAll(from, to);
  }
  return result;
}

/** Leaves out the declarations of what three.js declares; names those that are left. */
function withoutInputs(text) {
  const inputs = [];
  const kept = text.split('\n').filter((line) => {
    const name = DECLARATION.exec(line)?.[1];
    if (!name) return true;
    if (Object.hasOwn(INPUTS, name) || Object.hasOwn(ARRAYS, name)) return false;
    inputs.push(name);
    return true;
  });
  return { kept: kept.join('\n'), inputs };
}

/** Everything that a text defines outside of functions. */
function namesIn(text) {
  return DEFINITIONS.flatMap((pattern) => [...text.matchAll(pattern)].map(([, name]) => name));
}

function renamed(text, names) {
  let result = text;
  for (const [from, [array, member]] of Object.entries(ARRAYS)) {
    result = result.replace(new RegExp(`\\b${from}\\[(\\w+)\\]`, 'g'), `${array}[$1].${member}`);
  }
  return result.replace(/(\.?)\b([A-Za-z_]\w*)\b/g, (whole, dot, name) => {
    if (names.has(name)) return dot + PREFIX + name;
    return !dot && Object.hasOwn(INPUTS, name) ? INPUTS[name] : whole;
  });
}
