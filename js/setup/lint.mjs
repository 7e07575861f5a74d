import { readdirSync } from 'node:fs';
import path from 'node:path';
import { ensureDebianPackages } from './debian.mjs';
import { ensureNpmPackages } from './npm_packages.mjs';
import { main, ROOT, runShown, step } from './step.mjs';

// npm run lint: clang-format over C++, biome over JavaScript. `npm run format` (--fix) writes what clang-format wants.

const cppFiles = ['addon', 'renderer', 'test'].flatMap((folder) =>
  readdirSync(path.join(ROOT, folder), { recursive: true })
    .filter((file) => /\.(h|cpp)$/.test(file))
    .map((file) => path.join(folder, file)),
);

await main(async () => {
  await step('Debian packages', (begin) => ensureDebianPackages(['lint'], begin));
  await step('npm packages', ensureNpmPackages);
  const fix = process.argv.includes('--fix');
  const format = await runShown('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...cppFiles]);
  const lint = await runShown(process.execPath, ['node_modules/@biomejs/biome/bin/biome', 'lint', '--error-on-warnings']);
  process.stdout.write(`clang-format: ${format === 0 ? 'clean' : 'see above; npm run format'}\nbiome: ${lint === 0 ? 'clean' : 'see above'}\n`);
  return format || lint ? 1 : 0;
});
