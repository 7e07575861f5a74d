import { Option } from 'commander';
import { collect } from './shot_options.mjs';

/** Options that several commands have. */

const BACKENDS = ['auto', 'egl-device', 'egl-surfaceless', 'osmesa'];

export const backend = (text = 'where GL comes from') => new Option('--backend <backend>', text).choices(BACKENDS).default('auto');

export const addCommon = (command) =>
  command.option('--json', 'one JSON object on stdout, logs on stderr').option('--quiet', 'no progress, notes and warnings');

export const addFailOn = (command) =>
  command.addOption(
    new Option(
      '--fail-on <level>',
      'what leaves a model without a picture: errors; warnings too; or none of what three.js draws without: textures ' +
        'that are missing or damaged, unknown extensions that are required',
    )
      .choices(['error', 'warning', 'none'])
      .default('error'),
  );

export const addLimitOption = (command) => command.option('--limit <name=n>', 'raise or lower a limit, as in L_TRIANGLES=30000000', collect);

export const addLimit = (command) =>
  addLimitOption(command).option(
    '--timeout-ms <ms>',
    'milliseconds that the work on one image may take, or none; by default 20000, and none for quality high and reference',
  );
