import { readFile, writeFile } from 'node:fs/promises';
import puppeteer from 'puppeteer';

const page = (model) => `<!doctype html><style>body { margin: 0 }</style><script type="importmap">
{ "imports": { "three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/" } }</script><script type="module">
  import * as THREE from 'three';
  import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
  const bytes = Uint8Array.from(atob('${model.toString('base64')}'), (letter) => letter.charCodeAt(0));
  const { scene: garment } = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const renderer = new THREE.WebGLRenderer({ alpha: true, antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(512, 512);
  renderer.toneMapping = THREE.NeutralToneMapping;
  const scene = new THREE.Scene().add(garment);
  const sun = new THREE.DirectionalLight('white', 3);
  sun.position.set(1, 2, 3);
  scene.add(sun, new THREE.AmbientLight('white', 1));
  const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 10);
  camera.position.set(0, 0.3, 2);
  camera.lookAt(0, 0.3, 0);
  renderer.render(scene, camera);
  document.body.append(renderer.domElement);
  window.picture = renderer.domElement.toDataURL('image/png');
</script>`;

const browser = await puppeteer.launch({ args: ['--no-sandbox', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'] });
const tab = await browser.newPage();
await tab.goto(process.env.PAGES); // a server of one's own, for node_modules/three
await tab.setContent(page(await readFile('shirt.glb')));
await tab.waitForFunction('window.picture');
await writeFile('before.png', (await tab.evaluate('window.picture')).split(',')[1], 'base64');
await browser.close();
