/** Chunk of three.js, and where its loops over the lights begin in it. */
const LIGHT_CHUNK = 'lights_fragment_begin';
const LIGHT_LOOPS = 'IncidentLight directLight;';
const MAIN = 'void main() {';

/** Where the vertex stage of three.js declares and gives texture coordinates. */
const UV_DECLARATIONS = '#include <uv_pars_vertex>';
const UV_ASSIGNMENTS = '#include <uv_vertex>';
const SHADOW_POINTS = '#include <shadowmap_vertex>';

/** What a MeshPhysicalMaterial has and telar's text does not read. */
const NOT_READ = { retroreflectivity: 'retroreflectivity' };

/** In front of every name of telar's text, so that none meets one of three.js or of the client's. */
export const PREFIX = 'telar_';

/**
 * Module of js/dist/shading, written by js/build/shading.
 * @typedef {object} ShadingText
 * @property {string} declarations - Of the fragment stage.
 * @property {string} main
 * @property {string} vertexDeclarations
 * @property {string} vertexMain
 * @property {string} [layerThreshold] - Of fabric: shaders/shadow/layer_threshold.glsl.
 * @property {string[]} uniforms - That three.js does not know.
 * @property {string[]} features - Defines of 0, 1 or a count that three.js does not know; 0 where they are left out.
 */

/**
 * A class of materials that three.js lights, skins, maps and shadows as its own MeshPhysicalMaterial, and that telar's text
 * shades.
 * @param {typeof import('three')} THREE - The client's own three.js module.
 * @param {ShadingText} text
 * @param {string} family - Its name.
 * @returns {new (parameters?: object) => import('three').MeshPhysicalMaterial}
 */
export function shadingMaterialClass(THREE, text, family) {
  return class ShadingMaterial extends THREE.MeshPhysicalMaterial {
    isTelarShadingMaterial = true;

    /** Integers that the text is compiled with, by the name of their define. */
    shadingDefines = {};

    /** @param {object} [parameters] - As of MeshPhysicalMaterial. */
    constructor(parameters) {
      super();
      if (parameters) this.setValues(parameters);
    }

    /** Everything that the text is compiled with. */
    textDefines() {
      return this.shadingDefines;
    }

    /** @returns {Record<string, {value: unknown}>} Uniforms of the text by name; the objects stay the same. */
    textUniforms() {
      return {};
    }

    customProgramCacheKey() {
      return `telar ${family} ${JSON.stringify(this.textDefines())}`;
    }

    onBeforeCompile(shader) {
      for (const [key, what] of Object.entries(NOT_READ)) {
        if (this[key]) throw new Error(`material ${this.name || this.uuid}: the shading ${family} does not draw ${what}`);
      }
      const defines = Object.entries(this.textDefines())
        .map(([name, value]) => `#define ${PREFIX}${name} ${value}\n`)
        .join('');
      shader.fragmentShader = shadedFragment(THREE, shader.fragmentShader, text, defines);
      shader.vertexShader = shadedVertex(shader.vertexShader, text, defines);
      for (const [name, uniform] of Object.entries(this.textUniforms())) shader.uniforms[PREFIX + name] = uniform;
    }

    /** Takes over a MeshPhysicalMaterial, a MeshStandardMaterial or one of its own kind. */
    copy(source) {
      if (source.isMeshPhysicalMaterial) super.copy(source);
      else {
        THREE.MeshStandardMaterial.prototype.copy.call(this, source);
        this.defines = { STANDARD: '', PHYSICAL: '' };
      }
      if (source.isTelarShadingMaterial) this.shadingDefines = { ...source.shadingDefines };
      return this;
    }
  };
}

/**
 * The fragment shader of three.js with telar's text in place of its lighting.
 * @param {typeof import('three')} THREE
 * @param {string} fragment - Of ShaderLib.physical, includes as they are.
 * @param {ShadingText} text
 * @param {string} defines
 */
function shadedFragment(THREE, fragment, { declarations, main }, defines) {
  const chunk = THREE.ShaderChunk[LIGHT_CHUNK] ?? '';
  const [head, loops] = [fragment.indexOf(MAIN), chunk.indexOf(LIGHT_LOOPS)];
  if (head < 0 || loops < 0) throw new Error(`telar/three is written for three.js 0.187: this one, r${THREE.REVISION}, lights its materials otherwise`);
  return `${fragment.slice(0, head)}${defines}${declarations}\n${main.replace('TELAR_LIGHT_LOOPS', () => chunk.slice(loops))}`;
}

/** The vertex shader of three.js, which gives the texture coordinates of telar's own maps as well, and the points of shadow maps that cloth has. */
function shadedVertex(vertex, { vertexDeclarations, vertexMain, vertexShadow }, defines) {
  if (!vertexMain) return vertex;
  return vertex
    .replace(UV_DECLARATIONS, (chunk) => `${chunk}\n${defines}${vertexDeclarations}\n`)
    .replace(UV_ASSIGNMENTS, (chunk) => `${chunk}\n${vertexMain}\n`)
    .replace(SHADOW_POINTS, (chunk) => `${chunk}\n${vertexShadow}\n`);
}
