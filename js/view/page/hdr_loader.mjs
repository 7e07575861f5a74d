// HDRLoader by the name that older releases of three.js have for it.
export { RGBELoader as HDRLoader } from 'three/addons/loaders/RGBELoader.js';
