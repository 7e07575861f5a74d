// node test/parity/probe_environment.mjs ENVIRONMENT
// Writes the cube that three prefilters of a fixture environment (or `studio`) to out/parity/prefilter/NAME.f32: level by
// level, face by face (+x -x +y -y +z -z), rows in GL's order, RGBA fp32 of the stored halfs; prints mean and maximum.
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { Browser } from './browser/chromium.mjs';
import { OUT } from './places.mjs';
import { loadInputs } from './inputs.mjs';
import { shot } from './shot.mjs';

const name = process.argv[2];
const { environment } = await loadInputs({ name: 'probe', model: 'ball', environment: name });
const browser = await Browser.start();
try {
  const faces = await browser.prefilter({ shot: shot(), environment });
  const folder = path.join(OUT, 'prefilter');
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, `${name}.f32`), Buffer.concat(faces.map(({ values }) => Buffer.from(values.buffer))));
  for (const { name: face, size, values } of faces) {
    const rgb = [0, 1, 2].map((c) => values.filter((_, i) => i % 4 === c));
    const mean = rgb.map((channel) => (channel.reduce((a, b) => a + b, 0) / channel.length).toFixed(6));
    const most = rgb.map((channel) => channel.reduce((a, b) => Math.max(a, b), 0).toFixed(4));
    console.log(`${face}  ${size} px  mean ${mean.join(' ')}  max ${most.join(' ')}`);
  }
} finally {
  await browser.close();
}
