import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { shadingText } from '../../../js/build/shading/translate.mjs';
import { glb, quad } from '../../robust/glb.mjs';
import { applyShading, loadFabricMaterial } from '../../../js/three/index.mjs';
import { namesOf } from '../../../js/three/cloths.mjs';
import { restoreMaterials } from '../../../js/three/shading.mjs';
import { clothOf, extensionsOf, finishBack } from '../../../js/three/shading/fabric_layers.mjs';
import { loadShading } from '../../../js/three/shading/index.mjs';
import { definesOfTerms } from '../../../js/three/shading/terms.mjs';
import '../built.mjs';

const NO_YARNS = { warp: { coverage: 0 }, weft: { coverage: 0 } };

/** A quad with a material; images do not load in Node, so textures stand for them. */
async function load(material, textures = 0) {
  const { doc, bin } = quad();
  const json = { ...doc, extensionsUsed: ['KHR_texture_transform'], materials: [material], textures: Array.from({ length: textures }, () => ({ source: 0 })) };
  const loader = new GLTFLoader();
  loader.register(() => ({ name: 'textures', loadTexture: async (index) => Object.assign(new THREE.Texture(), { name: `texture ${index}` }) }));
  const bytes = glb({ doc: json, bin });
  const model = await loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  return { parser: model.parser, model, mesh: model.scene.getObjectByProperty('isMesh', true) };
}

const PRESETS = {
  felt: {
    material: {
      pbrMetallicRoughness: { roughnessFactor: 0.9, metallicFactor: 0 },
      extensions: { KHR_materials_sheen: { sheenColorFactor: [0.2, 0.2, 0.2], sheenRoughnessFactor: 0.5 }, TELAR_materials_fabric: { flatness: 0.4 } },
    },
  },
};
const loadPresets = async () => ({ PRESETS });

test('what the file says of cloth reaches the material, textures loaded in their colour spaces', async () => {
  const { model, mesh } = await load(
    {
      extensions: {
        TELAR_materials_fabric: {
          flatness: 0.25,
          weave: {
            warp: { coverage: 0.6, roughnessFactor: 0.3 },
            weft: { specularColorFactor: [1, 0, 0] },
            threadsPerUv: [40, 30],
            weaveTexture: { index: 0, texCoord: 1 },
          },
          back: { baseColorTexture: { index: 1 } },
        },
        KHR_materials_diffuse_transmission: {
          diffuseTransmissionFactor: 0.3,
          diffuseTransmissionColorTexture: { index: 2, extensions: { KHR_texture_transform: { scale: [2, 2] } } },
        },
      },
      pbrMetallicRoughness: { roughnessFactor: 0.7 },
    },
    3,
  );
  const stock = mesh.material;
  await applyShading(model, 'fabric', { THREE });
  const { fabric, diffuseTransmission } = mesh.material;
  assert.ok(mesh.material.isFabricMaterial);
  assert.deepEqual([fabric.flatness, fabric.weave.warp.coverage, fabric.back.roughnessFactor], [0.25, 0.6, 0.7]);
  assert.deepEqual([fabric.weave.weaveTexture.channel, fabric.weave.weaveTexture.colorSpace], [1, THREE.NoColorSpace]);
  assert.equal(fabric.back.baseColorTexture.colorSpace, THREE.SRGBColorSpace);
  assert.equal(diffuseTransmission.diffuseTransmissionColorTexture.repeat.x, 2);
  restoreMaterials(model.scene);
  assert.equal(mesh.material, stock);
});

test('extras stand for the extension, which wins', async () => {
  const inExtras = await load({ extras: { TELAR_materials_fabric: { flatness: 0.5 } } });
  await applyShading(inExtras.model, 'fabric', { THREE });
  assert.equal(inExtras.mesh.material.fabric.flatness, 0.5);
  const both = await load({ extras: { TELAR_materials_fabric: { flatness: 0.5 } }, extensions: { TELAR_materials_fabric: { flatness: 0.1 } } });
  await applyShading(both.model, 'fabric', { THREE });
  assert.equal(both.mesh.material.fabric.flatness, 0.1);
});

test('a preset gives what the material leaves out, as GLTFLoader would load it', async () => {
  const { parser, mesh } = await load({
    name: 'collar',
    pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1], roughnessFactor: 0.6 },
    extensions: { TELAR_materials_fabric: { preset: 'felt' } },
  });
  const { material, definition } = await clothOf(parser, mesh, mesh.material, loadPresets);
  assert.deepEqual([material.name, material.roughness, material.metalness, material.sheen, material.sheenRoughness], ['collar', 0.6, 0, 1, 0.5]);
  assert.deepEqual(material.color.toArray(), [1, 0, 0]);
  assert.equal(material.flatShading, true);
  assert.notEqual(material, mesh.material);
  assert.equal((await extensionsOf(parser, definition, THREE)).fabric.flatness, 0.4);
  const again = await clothOf(parser, mesh, mesh.material, loadPresets);
  assert.equal(again.material, material);
});

test("a preset's material is none of the file's: numbers of materials mean the same before and after", async () => {
  const { model } = await load({ name: 'cloth', extensions: { TELAR_materials_fabric: { preset: 'denim' } } });
  await applyShading(model, 'fabric', { THREE });
  assert.equal(model.scene.getObjectByProperty('isMesh', true).material.isFabricMaterial, true);
  assert.deepEqual(namesOf(model).materials, ['cloth']);
});

test("a back without a colour of its own has the front's", async () => {
  const { parser, mesh } = await load(
    {
      pbrMetallicRoughness: { baseColorFactor: [0.1, 0.2, 0.3, 0.5], baseColorTexture: { index: 0 }, roughnessFactor: 0.8 },
      extensions: { TELAR_materials_fabric: { back: {} } },
    },
    1,
  );
  const { definition } = await clothOf(parser, mesh, mesh.material, loadPresets);
  const backOf = async () => {
    const { fabric } = await extensionsOf(parser, definition, THREE);
    finishBack(fabric, mesh.material);
    return fabric.back;
  };
  const back = await backOf();
  const close = (a, b) => a.length === b.length && a.every((x, i) => Math.abs(x - b[i]) < 1e-6);
  assert.ok(close(back.baseColorFactor, [0.1, 0.2, 0.3]), `${back.baseColorFactor}`);
  assert.deepEqual([back.baseColorTexture.name, back.roughnessFactor], ['texture 0', 0.8]);
  // Also where the front is dyed.
  mesh.material.color.setRGB(0.7, 0.1, 0.2);
  mesh.material.map = null;
  const dyed = await backOf();
  assert.ok(close(dyed.baseColorFactor, [0.7, 0.1, 0.2]) && dyed.baseColorTexture === null, `${dyed.baseColorFactor}`);
  definition.extensions.TELAR_materials_fabric.back.baseColorFactor = [0.2, 0.5, 0.1];
  assert.deepEqual((await backOf()).baseColorFactor, [0.2, 0.5, 0.1], 'its own stays');
});

test('FabricMaterial by hand: parameters, clones, programs that differ by what is there', async () => {
  const FabricMaterial = await loadFabricMaterial(THREE);
  const plain = new FabricMaterial({ color: 0x884422, roughness: 0.4 });
  assert.deepEqual([plain.fabric, plain.diffuseTransmission, plain.roughness], [null, null, 0.4]);
  const thin = new FabricMaterial({ diffuseTransmission: { diffuseTransmissionFactor: 0.4 } });
  assert.notEqual(thin.customProgramCacheKey(), plain.customProgramCacheKey());
  assert.equal(thin.clone().customProgramCacheKey(), thin.customProgramCacheKey());
  const uniforms = thin.textUniforms();
  assert.equal(uniforms.diffuseTransmissionFactor.value, 0.4);
  thin.diffuseTransmission.diffuseTransmissionFactor = 0.6;
  thin.textUniforms();
  assert.equal(uniforms.diffuseTransmissionFactor.value, 0.6);
});

test('a material that becomes polished, or no longer is, is drawn by the program that reads what its normal map is made as', async () => {
  const material = new (await loadFabricMaterial(THREE))({ normalMap: new THREE.Texture(), fabric: { weave: NO_YARNS }, metalness: 1, roughness: 0.2 });
  const seen = [];
  for (const roughness of [0.2, 0.25, 0.5, 0.6, 0.2]) {
    material.roughness = roughness;
    const { version } = material;
    material.onBeforeRender({});
    const { NORMAL_FACETS } = material.textDefines();
    seen.push([NORMAL_FACETS, material.version - version]);
  }
  assert.deepEqual(seen, [
    [1, 1],
    [1, 0],
    [0, 1],
    [0, 0],
    [1, 1],
  ]);
});

test('factors that begin at 0 need another program as soon as they are more, in every family', async () => {
  const zeros = () => ({ fabric: { flatness: 0, weave: NO_YARNS }, diffuseTransmission: { diffuseTransmissionFactor: 0 } });
  const cases = {
    fabric: [
      ['DIFFUSE_TRANSMISSION', ({ diffuseTransmission }) => (diffuseTransmission.diffuseTransmissionFactor = 0.4)],
      ['FLATNESS', ({ fabric }) => (fabric.flatness = 0.5)],
      ['WEAVE', ({ fabric }) => (fabric.weave = { warp: { coverage: 0.5 }, weft: { coverage: 0.3 } })],
    ],
    principled: [['DIFFUSE_TRANSMISSION', ({ diffuseTransmission }) => (diffuseTransmission.diffuseTransmissionFactor = 0.4)]],
  };
  for (const [family, changes] of Object.entries(cases)) {
    const Material = await loadShading(THREE, family);
    for (const [define, change] of changes) {
      const material = new Material(zeros());
      if (family === 'principled') material.shadingDefines = definesOfTerms({ base: 'disney-2012', diffuse: 'disney-2015-thin' });
      const drawn = () => {
        const { version } = material;
        material.onBeforeRender({});
        return [material.textDefines()[define], material.version > version];
      };
      assert.deepEqual(
        [drawn(), drawn()],
        [
          [0, true],
          [0, false],
        ],
      );
      change(material);
      assert.deepEqual(drawn(), [1, true], `${family} ${define}`);
    }
  }
});

test('texels are read beyond the map as its sampler finds them', async () => {
  const material = new (await loadFabricMaterial(THREE))();
  const periodOf = () => material.textUniforms().normalMapPeriod.value.toArray();
  material.normalMap = Object.assign(new THREE.Texture(), { wrapS: THREE.RepeatWrapping, wrapT: THREE.MirroredRepeatWrapping });
  assert.deepEqual(periodOf(), [1, 2]);
  material.normalMap.wrapS = THREE.ClampToEdgeWrapping;
  assert.deepEqual(periodOf(), [0, 2]);
});

for (const family of ['fabric', 'principled']) {
  test(`${family}: whatever its text asks of the material is given`, async () => {
    const [weaveTexture, baseColorTexture, diffuseTransmissionTexture, diffuseTransmissionColorTexture] = Array.from({ length: 4 }, () => new THREE.Texture());
    const material = new (await loadShading(THREE, family))({
      fabric: { flatness: 0.5, weave: { weaveTexture }, back: { baseColorTexture } },
      diffuseTransmission: { diffuseTransmissionFactor: 0.5, diffuseTransmissionTexture, diffuseTransmissionColorTexture },
    });
    const { uniforms, features } = shadingText(family);
    const given = Object.keys(material.textDefines());
    assert.deepEqual(
      features.filter((name) => !given.includes(name)),
      [],
    );
    assert.deepEqual(
      uniforms.filter((name) => !(name in material.textUniforms())),
      [],
    );
  });
}

test('a FabricMaterial that a client has put into the scene stays', async () => {
  const own = new (await loadFabricMaterial(THREE))();
  const scene = new THREE.Group().add(new THREE.Mesh(new THREE.BufferGeometry(), own));
  await applyShading({ scene }, 'fabric', { THREE });
  assert.equal(scene.children[0].material, own);
});

test('cut-out cloth is blended in part, and by masks where a part of the model transmits', async () => {
  for (const transmission of [0, 0.5]) {
    const scene = new THREE.Group();
    const lace = new THREE.MeshStandardMaterial({ map: new THREE.Texture(), alphaTest: 0.5 });
    const pane = new THREE.MeshPhysicalMaterial({ transmission });
    for (const material of [lace, pane]) scene.add(new THREE.Mesh(new THREE.BufferGeometry(), material));
    await applyShading({ scene }, 'fabric', { THREE });
    const [{ transparent, depthWrite }, other] = scene.children.map(({ material }) => material);
    assert.deepEqual([transparent, depthWrite, other.transparent], transmission > 0 ? [false, true, false] : [true, false, false]);
    restoreMaterials(scene);
    assert.equal(scene.children[0].material.transparent, false);
  }
});
