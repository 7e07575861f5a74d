import { readFileSync } from 'node:fs';
import { texturesOf } from '../../material/table.mjs';
import { SLOTS } from '../../shot/shading_terms.mjs';
import { THREE_SLOTS } from '../../shot/three_terms.mjs';
import { PREFIX } from '../../three/shading/material.mjs';
import { termDefine, threeDefine } from '../../three/shading/terms.mjs';
import { fragmentDeclarations, inputsFunction, shaderFiles, vertexDeclarations, vertexMain } from '../material/glsl.mjs';
import { COUNTS, FEATURES, fixedFeatures, INPUT_NAMES, ownLayers } from './names.mjs';
import { conditionNames, included, withoutComments } from './preprocess.mjs';

const SHADERS = new URL('../../../shaders/', import.meta.url);
const HOST = new URL('../../three/shading/', import.meta.url);

/** The shadings that shaders/surface.frag tells apart by SHADING_X. */
export const FAMILIES = ['three', 'principled', 'fabric'];

/** Integers that a material of the principled shadings is compiled with. */
const TERMS = Object.keys(SLOTS).map(termDefine);

/** A browser has its own release of three.js: the terms of others are not drawn there. */
const THREE_TERMS = Object.fromEntries(Object.keys(THREE_SLOTS).map((slot) => [threeDefine(slot), 0]));

/** three.js declares the second set where a map has it. */
const SECOND_UV = `#ifdef USE_UV1\n#define ${PREFIX}uv1 uv1\n#else\n#define ${PREFIX}uv1 uv\n#endif`;

const DEFINITIONS = [
  /^struct (\w+)/gm,
  /^(?:const )?\w+ (\w+)\(/gm,
  /^const \w+ (\w+)/gm,
  /^(?:bool|int|float|vec[234]) (\w+)(?:\[\w+\])?(?: =|;)/gm,
  /^#define (\w+)/gm,
];
const DECLARATION = /^(uniform|in|out) \w+ (\w+)(?:\[\w+\])?;/gm;
const SECOND_SET = /\b(\w+_UV1) ==/g;

const readHost = (file) => readFileSync(new URL(file, HOST), 'utf8');

/** Text beneath shaders/; the files that know who calls them are three.js's own. */
function readerOf(family) {
  const host = {
    'material/fragment_inputs.glsl': () =>
      [readHost('host.glsl'), readHost(family === 'fabric' ? 'host_cloth.glsl' : 'host_maps.glsl'), ...fragmentDeclarations(ownLayers(family))].join('\n'),
    'material/layer_inputs.glsl': () => inputsFunction(INPUT_NAMES, ({ shadings }) => !shadings || shadings.includes(family)).join('\n'),
    'light/indirect_inputs.glsl': () => `${readHost('host_lights.glsl')}${family === 'three' ? '' : readHost('host_suns.glsl')}`,
    'light/area_inputs.glsl': () => readHost('host_area.glsl'),
    'light/sampled_environment.glsl': () => '',
    'brdf/importance.glsl': () => '',
    ...(family !== 'fabric' && { 'pixel_noise.glsl': () => '', 'material/coverage.glsl': () => '' }),
  };
  const written = shaderFiles();
  return (file) => host[file]?.() ?? written[file] ?? readFileSync(new URL(file, SHADERS), 'utf8');
}

/**
 * Text of one family of shadings for a MeshPhysicalMaterial of three.js: what surface.frag declares, under names of our own,
 * and js/three/shading/main.glsl.
 * @param {string} family - One of FAMILIES.
 * @returns {{declarations: string, main: string, vertexDeclarations: string, vertexMain: string, uniforms: string[],
 *   features: string[]}} `uniforms` and `features` (0, 1 or a count) that a material has to give: three.js does not know them.
 */
export function shadingText(family) {
  const text = withoutComments(included(readHost('declarations.glsl').replaceAll('FAMILY', family), readerOf(family)));
  const main = withoutComments(readHost('main.glsl'));
  const textures = ownLayers(family).flatMap(texturesOf);
  const cloth = family === 'fabric' ? clothVertex() : { declarations: [], main: [], shadow: '' };
  const vertex = {
    declarations: [...vertexDeclarations(textures), ...cloth.declarations].join('\n'),
    main: [...vertexMain(textures), ...cloth.main].join('\n'),
  };

  const fixed = {
    ...fixedFeatures(family),
    ...THREE_TERMS,
    ...(family !== 'principled' && Object.fromEntries(TERMS.map((name) => [name, 0]))),
    ...Object.fromEntries(FAMILIES.map((name) => [`SHADING_${name.toUpperCase()}`, Number(name === family)])),
  };
  const asked = [...conditionNames(`${text}\n${main}\n${vertex.declarations}`), ...matches(vertex.main, SECOND_SET, 1)];
  const defined = new Set(matches(text, /^#define (\w+)/gm, 1));
  const features = [...new Set(asked)].filter((name) => !(name in FEATURES || name in COUNTS || name in fixed || defined.has(name) || TERMS.includes(name)));

  const inputs = [...new Set(matches(`${text}\n${vertex.declarations}`, DECLARATION, 2))];
  const names = new Set([...namesIn(`${text}\n${vertex.declarations}`), ...inputs, ...asked, ...TERMS]);
  const translate = (part) => renamed(part, names);
  return {
    declarations: [knownFeatureText(fixed, asked), ownFeatureText(features), translate(text)].join('\n'),
    main: translate(main),
    vertexDeclarations: [knownFeatureText(fixed, conditionNames(vertex.declarations)), ownFeatureText(features), translate(vertex.declarations)].join('\n'),
    vertexMain:
      textures.length > 0
        ? `${SECOND_UV}\n${translate(vertex.main)
            .replaceAll(/\buv0\b/g, 'uv')
            .replaceAll(/\buv1\b/g, `${PREFIX}uv1`)}`
        : '',
    vertexShadow: translate(withoutComments(cloth.shadow)),
    ...(family === 'fabric' && { layerThreshold: thresholdText() }),
    uniforms: inputs.filter((name) => !/^v[A-Z]/.test(name)),
    features,
  };
}

/** What alpha must pass in a shadow map of sheer cloth. */
function thresholdText() {
  const read = readerOf('fabric');
  const text = withoutComments(included(read('shadow/layer_threshold.glsl'), read));
  return renamed(text, new Set(namesIn(text)));
}

/** What the vertex stage does for cloth alone: shaders/surface.vert in the names of three.js. */
function clothVertex() {
  return {
    declarations: [
      readHost('host_cloth_vertex.glsl'),
      ...['material/visibility_vertex.glsl', 'shadow/offset.glsl'].map((file) => withoutComments(readFileSync(new URL(file, SHADERS), 'utf8'))),
    ],
    main: [readHost('host_cloth_vertex_main.glsl')],
    shadow: readHost('host_cloth_shadow.glsl'),
  };
}

const matches = (text, pattern, group) => [...text.matchAll(pattern)].map((match) => match[group]);

/** Features that the material defines where it has them. */
const ownFeatureText = (features) => features.map((name) => `#ifndef ${PREFIX}${name}\n#define ${PREFIX}${name} 0\n#endif`).join('\n');

/** Of those that the text asks for: three.js's conditions as 0 or 1, its counts, and what is always so. */
function knownFeatureText(fixed, asked) {
  const lines = [...new Set(asked)].map((name) => {
    if (name in FEATURES) return `#if ${FEATURES[name]}\n#define ${PREFIX}${name} 1\n#else\n#define ${PREFIX}${name} 0\n#endif`;
    if (name in COUNTS) return `#define ${PREFIX}${name} ${COUNTS[name]}`;
    return name in fixed ? `#define ${PREFIX}${name} ${fixed[name]}` : '';
  });
  return lines.filter(Boolean).join('\n');
}

/**
 * The shaders that make mip levels (shaders/texture), as they are: for RawShaderMaterial.
 * @returns {Record<string, string>}
 */
export function textureShaders() {
  const files = {
    vertex: 'level.vert',
    reliefMoments: 'relief_moments.frag',
    reliefLevel: 'relief_level.frag',
    reliefAxis: 'relief_axis.frag',
    facetsMoments: 'facets_moments.frag',
    facetsLevel: 'facets_level.frag',
    yarnsMoments: 'yarns_moments.frag',
    yarnsLevel: 'yarns_level.frag',
    metalMoments: 'metal_moments.frag',
    metalLevel: 'metal_level.frag',
    coverageMoments: 'coverage_moments.frag',
    coverageLevel: 'coverage_level.frag',
  };
  const read = readerOf('fabric');
  return Object.fromEntries(Object.entries(files).map(([name, file]) => [name, withoutComments(included(read(`texture/${file}`), read))]));
}

/** Everything that a text defines outside of functions. */
const namesIn = (text) => DEFINITIONS.flatMap((pattern) => matches(text, pattern, 1));

/** A name of the text's own gets a prefix, wherever it stands. */
const renamed = (text, names) => text.replace(/\b[A-Za-z_]\w*\b/g, (name) => (names.has(name) ? PREFIX + name : name));
