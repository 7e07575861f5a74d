// HDRLoader by the name that it had before 0.180.
export { RGBELoader as HDRLoader } from 'three/addons/loaders/RGBELoader.js';
