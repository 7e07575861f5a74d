import { writeFile } from 'node:fs/promises';
import { createRenderer } from 'telar';

const shot = {
  size: { width: 512, height: 512 },
  camera: { position: [0, 0.3, 2], target: [0, 0.3, 0], fovY: 30, near: 0.1, far: 10 },
  environment: 'none',
  lights: [
    { type: 'directional', color: 'white', intensity: 3, position: [1, 2, 3] },
    { type: 'ambient', color: 'white', intensity: 1 },
  ],
  toneMapping: 'neutral',
};
const renderer = await createRenderer();
await writeFile('after.png', (await renderer.render('shirt.glb', shot)).data);
await renderer.close();
