import path from 'node:path';
import { ROOT } from '../../machine/step.mjs';
import { writePackages } from './index.mjs';
import { targetOf } from './target.mjs';

// node js/build/package/write.mjs ARCH: the packages of a build that stands. js/setup/package_arm64.mjs runs it where the cross compiler is.

const { arch, preset } = targetOf(process.argv[2]);
writePackages({ build: path.join(ROOT, 'out', preset), folder: path.join(ROOT, 'out/package'), arch });
