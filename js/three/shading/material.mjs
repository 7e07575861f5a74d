/** Chunk of three.js, and where its loops over the lights begin in it. */
const LIGHT_CHUNK = 'lights_fragment_begin';
const LIGHT_LOOPS = 'IncidentLight directLight;';
const MAIN = 'void main() {';

/** What a MeshPhysicalMaterial has and telar's text does not read: glTF has no such thing. */
const UNSUPPORTED = {
  bumpMap: 'a bump map: bake it into a normal map',
  retroreflectivity: 'retroreflectivity',
};

/**
 * A class of materials that three.js lights, skins, maps and shadows as its own MeshPhysicalMaterial, and that telar's text
 * shades.
 * @param {typeof import('three')} THREE - The client's own three.js module.
 * @param {{declarations: string, main: string}} text - Module of js/dist/shading.
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

    customProgramCacheKey() {
      return `telar ${family} ${JSON.stringify(this.shadingDefines)}`;
    }

    onBeforeCompile(shader) {
      for (const [key, what] of Object.entries(UNSUPPORTED)) {
        if (this[key]) throw new Error(`material ${this.name || this.uuid}: the shading ${family} does not draw ${what}`);
      }
      shader.fragmentShader = shadedFragment(THREE, shader.fragmentShader, text, this.shadingDefines);
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
 * @param {{declarations: string, main: string}} text
 * @param {Record<string, number>} defines
 */
function shadedFragment(THREE, fragment, { declarations, main }, defines) {
  const chunk = THREE.ShaderChunk[LIGHT_CHUNK] ?? '';
  const [head, loops] = [fragment.indexOf(MAIN), chunk.indexOf(LIGHT_LOOPS)];
  if (head < 0 || loops < 0) throw new Error(`telar/three is written for three.js 0.187: this one, r${THREE.REVISION}, lights its materials otherwise`);
  const defined = Object.entries(defines).map(([name, value]) => `#define telar_${name} ${value}\n`).join('');
  return `${fragment.slice(0, head)}${defined}${declarations}\n${main.replace('TELAR_LIGHT_LOOPS', () => chunk.slice(loops))}`;
}
