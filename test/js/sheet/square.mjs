import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';

/** A black square of 300 mm in the plane of the picture, its lower edge 0.15 m above the ground. */
export async function squareModel() {
  const builder = new GlbBuilder();
  const material = builder.material({ name: 'black', unlit: true, baseColor: [0, 0, 0, 1], doubleSided: true });
  builder.add(plane(0.3, 0.3), material, { name: 'square', translation: [0, 0.3, 0] });
  return builder.bytes();
}

/** Cheap pictures, where it is tested where they stand and not how they look. */
export const CHEAP = { environment: 'none', quality: 'draft' };

/** The square, loaded; the renderer is to be closed. */
export async function openSquare() {
  const renderer = await createRenderer();
  return { renderer, model: await renderer.load(await squareModel()) };
}
