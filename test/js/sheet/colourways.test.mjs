// Colourways of a sheet: each is shown in its own variant, or in the materials that the file has without one.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { readImage } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { readOptions } from '../../../js/sheet/options.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { CHEAP } from './square.mjs';

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const cloth = (name, baseColor) => builder.material({ name, unlit: true, baseColor, doubleSided: true });
  const [jersey, dyed] = [cloth('jersey', [1, 0, 0, 1]), cloth('jersey_indigo', [0, 0, 1, 1])];
  const primitive = builder.add(plane(0.3, 0.3), jersey, { name: 'square' }).getMesh().listPrimitives()[0];
  const extension = builder.extension('KHR_materials_variants');
  const mapping = extension.createMapping().setMaterial(dyed).addVariant(extension.createVariant('indigo'));
  primitive.setExtension('KHR_materials_variants', extension.createMappingList().addMapping(mapping));
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const NATURAL = { name: 'Natural', swatches: [{ material: 'jersey' }] };
const INDIGO = { name: 'Indigo', variant: 'indigo', swatches: [{ material: 'jersey_indigo' }] };

/** "red" or "blue" of each picture: in the views of the first page, and in the cells of the colourways. */
async function shown(spec) {
  const { sections, engine, pictures } = await layOut(model, { ppi: 36, ...spec }, readOptions({ renderer, shot: CHEAP }));
  engine.close();
  const drawn = await pictures.draw();
  const colourOf = async ({ file }) => {
    const { width, height, data } = await readImage(drawn.get(file).data);
    const at = 4 * (Math.floor(height / 2) * width + Math.floor(width / 2));
    return data[at] > 200 ? 'red' : data[at + 2] > 200 ? 'blue' : 'neither';
  };
  const [cover] = sections;
  const { cells } = sections.find(({ kind }) => kind === 'colourways');
  return {
    views: await Promise.all(cover.figure.pictures.map(colourOf)),
    cells: await Promise.all(cells.map(async ({ name, pictures: own }) => [name, ...(await Promise.all(own.map(colourOf)))])),
  };
}

test('a colourway without a variant is shown in the materials of the file, and so are the views where it is the first', async () => {
  assert.deepEqual(await shown({ colourways: [NATURAL, INDIGO] }), {
    views: ['red', 'red'],
    cells: [
      ['Natural', 'red', 'red'],
      ['Indigo', 'blue', 'blue'],
    ],
  });
  assert.deepEqual(await shown({ colourways: [INDIGO, NATURAL] }), {
    views: ['blue', 'blue'],
    cells: [
      ['Indigo', 'blue', 'blue'],
      ['Natural', 'red', 'red'],
    ],
  });
});

test('the variant of a view is not that of a colourway; "" is the materials of the file in views, colourways and swatches', async () => {
  const views = [
    { name: 'a', variant: 'indigo', cover: true },
    { name: 'b', variant: '', cover: true },
  ];
  const spec = { views, colourways: [INDIGO, { ...NATURAL, variant: '' }], swatches: [{ title: 'Own', node: 'square', variant: '', draped: false }] };
  assert.deepEqual(await shown(spec), {
    views: ['blue', 'red'],
    cells: [
      ['Indigo', 'blue', 'blue'],
      ['Natural', 'red', 'red'],
    ],
  });
});
