// CPU time of a frame of cloth under shading "fabric" against "three", and of what "fabric" might have done instead: a
// sphere that fills 512 x 512, three directional lights and the studio, one sample a pixel, medians of steady frames, all in
// one run. The table in shaders/shading/README.md is of this.
// node test/bench/fabric.mjs      needs the dev build (npm test makes it)
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { resolveShot } from '../../js/shot/index.mjs';
import { sphere } from '../fixtures/geometry.mjs';
import { GlbBuilder } from '../fixtures/glb.mjs';
import { median } from '../median.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const tool = path.join(root, process.env.TELAR_BUILD_DIR ?? 'out/dev', 'bin/telar_draw');
const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
const file = (name) => path.join(folder, name);
const ROUNDS = 5;
const FRAMES = 8;

const yarn = { coverage: 0.5, roughnessFactor: 0.4, anisotropyStrength: 0.7 };
const CLOTHS = {
  plain: {},
  sheen: { sheen: { sheenColorFactor: [0.3, 0.3, 0.3], sheenRoughnessFactor: 0.5 } },
  coat: { clearcoat: { clearcoatFactor: 0.5, clearcoatRoughnessFactor: 0.3 } },
  stretched: { anisotropy: { anisotropyStrength: 0.7 } },
  yarns: { fabric: { definition: { weave: { warp: yarn, weft: yarn } } } },
  'thin sheet': { fabric: { definition: { flatness: 0.5 } } },
};

/** What stands in place of a part of fabric: [cloth, name, edits of the shaders]. */
const fabric = (find, replace) => ({ file: 'shading/fabric.glsl', find, replace });
const energy = (find, replace) => ({ file: 'shading/fabric_energy.glsl', find, replace });
const ALTERNATIVES = [
  [
    'plain',
    'diffuse (1 - F) as in three, not coupled',
    [
      fabric(
        'sum.diffuse += lightColor * diffuseLobe(s, l, NoL) * s.passing * passingShare(s, albedo);',
        'sum.diffuse += lightColor * diffuseLobe(s, l, NoL) * (1.0 - mix(s.f0Dielectric, vec3(s.f90), F_SchlickWeight5(dot(s.v, h))));',
      ),
    ],
  ],
  [
    'plain',
    'albedo towards a light from a table',
    [
      energy(
        'GlossAlbedo albedoTowards(SurfaceInfo s, vec3 direction, float cosine) {',
        'GlossAlbedo albedoTowards(SurfaceInfo s, vec3 direction, float cosine) {\n' +
          '  vec2 ab = texture(dfgMap, vec2(s.perceptualRoughness, sqrt(cosine))).rg;\n  return GlossAlbedo(vec2(1.0 - ab.x - ab.y, ab.y));',
      ),
    ],
  ],
  [
    'sheen',
    'sheen by Charlie and its own masking',
    [
      fabric(
        'sheenCosine(s.sheenView, s.NoV, NoL, dot(l, s.v))',
        'NoL * D_Charlie_(pow2(s.sheenRoughness), saturate(dot(s.n, h))) * V_Charlie_(pow2(s.sheenRoughness), s.NoV, NoL)',
      ),
      energy(
        '// Axes square to the normal',
        'float V_Charlie_(float a, float v, float l) { return 1.0 / ((1.0 + lambdaCharlie(a, v) + lambdaCharlie(a, l)) * 4.0 * v * l); }\n' +
          'float D_Charlie_(float a, float c) { return (2.0 + 1.0 / a) * pow(max(1.0 - c * c, 0.0078125), 0.5 / a) / (2.0 * PI); }\n// Axes square to the normal',
      ),
    ],
  ],
  [
    'sheen',
    'sheen by Charlie and Neubelt, as in three',
    [
      fabric(
        'sheenCosine(s.sheenView, s.NoV, NoL, dot(l, s.v))',
        'NoL * D_Charlie_(pow2(s.sheenRoughness), saturate(dot(s.n, h))) * saturate(1.0 / max(4.0 * (NoL + s.NoV - NoL * s.NoV), 1.0e-5))',
      ),
      energy(
        '// Axes square to the normal',
        'float D_Charlie_(float a, float c) { return (2.0 + 1.0 / a) * pow(max(1.0 - c * c, 0.0078125), 0.5 / a) / (2.0 * PI); }\n// Axes square to the normal',
      ),
    ],
  ],
];

async function glbOf(layers) {
  const glb = new GlbBuilder();
  glb.add(sphere(1), glb.material({ baseColor: [0.6, 0.5, 0.4, 1], roughness: 0.7, layers }), { name: 'cloth' });
  return glb.bytes();
}

function shotOf(shading) {
  const lights = [
    [1, 2, 3],
    [-2, 1, 1],
    [0, -1, 2],
  ].map((position) => ({ type: 'directional', position }));
  return resolveShot(
    { size: { width: 512, height: 512 }, shading, lights, quality: { samples: 1 }, camera: { fit: 1 } },
    { min: [-1, -1, -1], max: [1, 1, 1] },
  );
}

function cpuMs(job) {
  const run = spawnSync(tool, [job.model, job.shot, file('out.raw'), '--repeat', String(1 + FRAMES), ...job.extra], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(run.stderr || `telar_draw: ${run.error ?? run.signal}`);
  return median(
    run.stdout
      .trim()
      .split('\n')
      .slice(1)
      .map((line) => JSON.parse(line).cpuMs),
  );
}

async function prepare() {
  const jobs = [];
  for (const shading of ['three', 'fabric']) writeFileSync(file(`${shading}.json`), JSON.stringify(shotOf(shading)));
  for (const [name, layers] of Object.entries(CLOTHS)) {
    writeFileSync(file(`${name}.glb`), await glbOf(layers));
    for (const shading of ['three', 'fabric']) {
      jobs.push({ name: `${name}, ${shading}`, base: `${name}, three`, model: file(`${name}.glb`), shot: file(`${shading}.json`), extra: [], times: [] });
    }
  }
  ALTERNATIVES.forEach(([cloth, name, edits], i) => {
    writeFileSync(file(`edits${i}.json`), JSON.stringify(edits));
    jobs.push({
      name,
      base: `${cloth}, fabric`,
      model: file(`${cloth}.glb`),
      shot: file('fabric.json'),
      extra: ['--shader-edits', file(`edits${i}.json`)],
      times: [],
    });
  });
  return jobs;
}

try {
  const jobs = await prepare();
  for (let round = 0; round < ROUNDS; ++round) for (const job of jobs) job.times.push(cpuMs(job));
  const msOf = (name) => median(jobs.find((job) => job.name === name).times);
  for (const { name, base } of jobs) {
    console.log(`${name.padEnd(44)} ${msOf(name).toFixed(1).padStart(6)} ms   ${(msOf(name) / msOf(base)).toFixed(2)} of ${base}`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
