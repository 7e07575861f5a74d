// evaluateShading({albedo: true}) against integrals of the same lobes by another way: a grid over the slopes of the microfacets.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { evaluateShading } from '../../../js/index.mjs';
import './support/real.mjs';

const LOBES = ['diffuse', 'specular', 'sheen', 'coat', 'total'];
const FEWEST = 0.045; // perceptual roughness below which nothing is shaded

const materialOf = ({ metallic = 0, roughness = 0.5, anisotropy, coat, sheen, weave, color = 1 }) => ({
  pbrMetallicRoughness: { baseColorFactor: [color, color, color, 1], metallicFactor: metallic, roughnessFactor: roughness },
  extensions: {
    ...(anisotropy && { KHR_materials_anisotropy: { anisotropyStrength: anisotropy[0], anisotropyRotation: anisotropy[1] } }),
    ...(coat !== undefined && { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: coat } }),
    ...(sheen !== undefined && { KHR_materials_sheen: { sheenColorFactor: [1, 1, 1], sheenRoughnessFactor: sheen } }),
    ...(weave && { TELAR_materials_fabric: { weave: { warp: weave[0], weft: weave[1] } } }),
  },
});

const alphaOf = (roughness) => Math.max(roughness, FEWEST) ** 2;

/** The GGX lobes of a material: widths along an axis turned by `turn` out of x, and across it. */
function lobesOf({ roughness = 0.5, anisotropy = [0, 0], weave }) {
  if (weave) {
    return weave.map(({ roughnessFactor, anisotropyStrength = 0 }, i) => {
      const along = alphaOf(roughnessFactor);
      return { turn: i ? 0 : Math.PI / 2, widths: [along, along + (1 - along) * anisotropyStrength ** 2] };
    });
  }
  const across = alphaOf(roughness);
  return [{ turn: anisotropy[1], widths: [across + (1 - across) * anisotropy[0] ** 2, across] }];
}

/**
 * Directions and their weights dl: normals of a GGX lobe, whose slopes are r (width cos, width sin) with r² = u / (1 - u) for an even u, about
 * which the viewer is mirrored. They are dense where the lobe is narrow and reach all of the hemisphere. Some rings at once: no more
 * of them are held than are asked for together.
 */
function* slopeGrid({ turn, widths: [a, b] }, v, rings, sectors) {
  for (let first = 0; first < rings; first += RINGS_AT_ONCE) {
    const directions = [];
    const weights = [];
    for (let i = first; i < Math.min(first + RINGS_AT_ONCE, rings); i += 1) {
      // Both ends are drawn out, where the lobe's centre and its far slopes lie.
      const s = (i + 0.5) / rings;
      const u = s * s * s * (s * (6 * s - 15) + 10);
      const du = (30 * s * s * (1 - s) ** 2) / rings;
      const r = Math.sqrt(u / (1 - u));
      for (let j = 0; j < sectors; j += 1) {
        const phi = (2 * Math.PI * (j + 0.5)) / sectors;
        const [x, y] = [a * r * Math.cos(phi), b * r * Math.sin(phi)];
        const length = Math.hypot(x, y, 1);
        const h = [(x * Math.cos(turn) - y * Math.sin(turn)) / length, (x * Math.sin(turn) + y * Math.cos(turn)) / length, 1 / length];
        const VoH = h[0] * v[0] + h[2] * v[2];
        const l = [2 * VoH * h[0] - v[0], 2 * VoH * h[1] - v[1], 2 * VoH * h[2] - v[2]];
        if (!(VoH > 0) || !(l[2] > 0)) continue;
        const norm = Math.hypot(l[0], l[1], l[2]);
        directions.push([l[0] / norm, l[1] / norm, l[2] / norm]);
        // dx dy = a b r dr dphi, dr² = du / (1 - u)²; dh = h.z³ dx dy; dl = 4 VoH dh.
        weights.push((4 * VoH * a * b * du * Math.PI) / ((1 - u) ** 2 * sectors * length ** 3));
      }
    }
    yield { directions, weights };
  }
}

const RINGS_AT_ONCE = 10;

const WIDE = { turn: 0, widths: [1, 1] };

/** Albedo by lobe. The highlight is on a grid for each set of yarns and a wide one, which share it by how dense they are. */
async function integrated(material, options, rings, sectors) {
  const v = [Math.sin(options.viewAngle), 0, Math.cos(options.viewAngle)];
  const base = [...lobesOf(material), WIDE];
  const sums = { specular: 0, diffuse: 0, sheen: 0, coat: 0 };
  const over = async (grid, add) => {
    for (const { directions, weights } of slopeGrid(grid, v, rings, sectors)) {
      const { radiance } = await evaluateShading({ ...options, directions });
      radiance.forEach((lobes, i) => add(lobes, weights[i], directions[i]));
    }
  };
  for (const grid of base) {
    const share = (l) => densityOf(grid, v, l) / base.reduce((total, other) => total + densityOf(other, v, l), 0);
    await over(grid, (lobes, weight, l) => {
      sums.specular += lobes.specular[0] * weight * share(l);
      if (grid !== WIDE) return;
      sums.diffuse += lobes.diffuse[0] * weight;
      sums.sheen += lobes.sheen[0] * weight;
    });
  }
  if (material.coat !== undefined) {
    const coat = alphaOf(material.coat);
    await over({ turn: 0, widths: [coat, coat] }, (lobes, weight) => {
      sums.coat += lobes.coat[0] * weight;
    });
  }
  return sums;
}

/** How dense the grid's directions lie about one of them, but for a factor that all lobes have. */
function densityOf({ turn, widths: [a, b] }, v, l) {
  const [hx, hy, hz] = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
  const [x, y] = [hx * Math.cos(turn) + hy * Math.sin(turn), hy * Math.cos(turn) - hx * Math.sin(turn)];
  return 1 / (a * b * ((x / a) ** 2 + (y / b) ** 2 + hz ** 2) ** 2);
}

const yarns = (coverage, roughnessFactor, anisotropyStrength) => ({ coverage, roughnessFactor, anisotropyStrength });

/** What is hard: narrow, stretched, seen edge on, layered. */
const CASES = [
  ['a stretched mirror, seen flat', { metallic: 0.724, roughness: 0, anisotropy: [0.9, 1.288] }, 'fabric', 1.381],
  ['the same in three', { metallic: 0.724, roughness: 0, anisotropy: [0.9, 1.288] }, 'three', 1.381],
  ['a mirror head-on', { metallic: 1, roughness: 0 }, 'three', 0],
  ['a mirror, grazing', { metallic: 1, roughness: 0 }, 'fabric', 1.55],
  ['rough, grazing', { roughness: 1 }, 'fabric', 1.55],
  ['a dull coat over satin', { roughness: 0.3, coat: 0.6, color: 0.5 }, 'three', 1.2],
  ['a glossy coat, grazing', { roughness: 0.8, coat: 0, color: 0.5 }, 'fabric', 1.5],
  ['sheen', { roughness: 0.7, sheen: 0.3 }, 'fabric', 1.3],
  ['sheen in three', { roughness: 0.7, sheen: 0.4 }, 'three', 1.3],
  ['disney, stretched', { metallic: 0.5, roughness: 0.4, anisotropy: [0.5, 0.4] }, 'three-r115', 1],
  ['metal of a smooth and a rough set of yarns', { metallic: 1, weave: [yarns(0.5, 0.1, 0.5), yarns(0.5, 1, 0)] }, 'fabric', 0],
  ['stretched yarns with gaps, seen flat', { weave: [yarns(0.4, 0.2, 0.8), yarns(0.3, 0.3, 0.9)] }, 'fabric', 1.3],
];

for (const [name, material, shading, viewAngle] of CASES) {
  test(`the albedo of ${name} is its integral within its error`, async () => {
    const options = { material: materialOf(material), shading, viewAngle };
    const { albedo, albedoError } = await evaluateShading({ ...options, albedo: true });
    const coarse = await integrated(material, options, 160, 320);
    const fine = await integrated(material, options, 200, 327);
    for (const lobe of LOBES.slice(0, 4)) {
      const grid = Math.abs(fine[lobe] - coarse[lobe]);
      const off = Math.abs(albedo[lobe][0] - fine[lobe]);
      assert.ok(grid < 5e-4, `${lobe}: the grids differ by ${grid}`);
      // Twice: the two grids are not far apart, and the finer one's own error may be as large as what lies between them.
      assert.ok(
        off <= albedoError[lobe][0] + 2 * grid + 1e-9,
        `${lobe}: ${albedo[lobe][0]} by ${off} off ${fine[lobe]}, said ${albedoError[lobe][0]}, grids ${grid}`,
      );
      assert.ok(albedoError[lobe][0] < 1e-3, `${lobe}: error ${albedoError[lobe][0]}`);
    }
    assert.ok(Math.abs(albedo.total[0] - LOBES.slice(0, 4).reduce((sum, lobe) => sum + albedo[lobe][0], 0)) < 1e-9);
  });
}

test('a stretched mirror seen flat reflects 0.993, and no more than there is', async () => {
  const material = materialOf({ metallic: 0.724, roughness: 0, anisotropy: [0.9, 1.288] });
  const { albedo, albedoError } = await evaluateShading({ material, shading: 'fabric', viewAngle: 1.381, albedo: true });
  assert.ok(Math.abs(albedo.total[0] - 0.993) < 0.0006 + albedoError.total[0], String(albedo.total));
});

test('the sheen of cloth is that of its closed form within its error', async () => {
  // Zeltner, Burley & Chiang 2022, as MaterialX and OpenPBR fit it: R of the sheen's roughness and the viewer's cosine.
  for (const [sheen, viewAngle, expected] of [
    [0.1, 1.5, 0.10202684981],
    [0.3, 1.3, 0.15131775069],
  ]) {
    const { albedo, albedoError } = await evaluateShading({ material: materialOf({ roughness: 0.7, sheen }), shading: 'fabric', viewAngle, albedo: true });
    assert.ok(Math.abs(albedo.sheen[0] - expected) <= albedoError.sheen[0], `${albedo.sheen[0]} by ${albedoError.sheen[0]}`);
  }
});

test('Lambert lies within its error, which is small; without albedo there is none', async () => {
  const material = { ...materialOf({}), extensions: { KHR_materials_specular: { specularFactor: 0 } } };
  for (const viewAngle of [0, 1, 1.5]) {
    const { albedo, albedoError } = await evaluateShading({ material, viewAngle, albedo: true });
    assert.ok(Math.abs(albedo.diffuse[0] - 1) <= albedoError.diffuse[0] && albedoError.diffuse[0] < 2e-6, `${albedo.diffuse[0]} ${albedoError.diffuse[0]}`);
    assert.deepEqual(albedoError.coat, [0, 0, 0]);
  }
  assert.equal((await evaluateShading({ material })).albedoError, null);
});

test('the albedo repeats to the last digit', async () => {
  const options = { material: materialOf({ roughness: 0.2, coat: 0.1 }), viewAngle: 0.7, albedo: true };
  assert.deepEqual(await evaluateShading(options), await evaluateShading(options));
});
