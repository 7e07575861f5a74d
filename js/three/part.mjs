import { Outline } from '../shot/outline.mjs';
import { visitDrawnPoints } from './drawn_points.mjs';
import { isLeftOut } from './ghost.mjs';
import { nodesOf } from './nodes.mjs';
import { materialIndexOf } from './variant.mjs';

/**
 * What a part of a model measures, as the server measures it (renderer/asset/scene/part.cpp). Nodes and materials go by the names and
 * numbers of the file; a scene without a parser has the names of its own objects.
 *
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave, world matrices up to date.
 * @param {{node: number | string} | {material: number | string}} frame - Of the shot.
 * @param {{THREE: typeof import('three'), variant: string, ghost: object[]}} options
 * @returns {import('../shot/part.mjs').PartFact}
 */
export function measurePart(model, frame, { THREE, variant, ghost }) {
  const [[kind, which]] = Object.entries(frame);
  const partsOf = kind === 'node' ? nodesOf : materialsOf;
  const isMeant = (part) => (typeof which === 'number' ? part.index === which : (part.name ?? '') === which); // the server knows no name as the empty one
  const outline = new Outline();
  const box = new THREE.Box3();
  const drawn = [];
  model.scene.traverse((object) => {
    if (!object.geometry?.attributes.position) return;
    const parts = partsOf(model, object, variant);
    drawn.push(...parts);
    if (!parts.some(isMeant) || isLeftOut(model, object, { ghost, variant })) return;
    visitDrawnPoints(object, THREE, (point) => {
      box.expandByPoint(point);
      outline.add(point.x, point.y, point.z);
    });
  });
  if (!box.isEmpty()) return { frame, found: true, bounds: { min: box.min.toArray(), max: box.max.toArray() }, outline: outline.points() };
  const found = listed(model, kind).some(isMeant);
  return { frame, found, bounds: null, outline: [], names: namesOf(drawn) };
}

/** In the file's order, each once. */
const namesOf = (parts) => [
  ...new Set(
    [...parts]
      .sort((a, b) => a.index - b.index)
      .map(({ name }) => name)
      .filter((name) => name),
  ),
];

/** The material that an object wears, where it is one of the file's. */
function materialsOf({ parser }, object, variant) {
  if (!parser) return [object.material].flat().map(({ id, name }) => ({ index: id, name }));
  const index = materialIndexOf(parser, object, variant);
  return index === undefined ? [] : [{ index, name: parser.json.materials[index].name }];
}

/** All of the file. */
function listed({ scene, parser }, kind) {
  const name = kind === 'node' ? 'nodes' : 'materials';
  if (parser) return (parser.json[name] ?? []).map((part, index) => ({ index, name: part.name }));
  const objects = [];
  scene.traverse((object) => objects.push({ index: object.id, name: object.name }));
  return kind === 'node' ? objects : [];
}
