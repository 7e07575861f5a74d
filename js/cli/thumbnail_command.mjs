import { addCommon, addFailOn, addLimit, backend } from './common_options.mjs';
import { addShotOptions } from './shot_options.mjs';

/** `telar thumbnail`: what its command line takes, and what does it. @type {import('./program.mjs').Row} */
export const THUMBNAIL = {
  load: async () => (await import('./thumbnail.mjs')).thumbnail,
  add: (command) =>
    addLimit(
      addFailOn(
        addCommon(
          addShotOptions(
            command('thumbnail', 'Draw one image a model, or one for each of its variants and views')
              .argument('[model...]', '.glb or .gltf files, or folders with -r; - is stdin')
              .option(
                '-o, --output <out>',
                'file, folder or pattern such as out/{parent}-{view}.png ({name}, {parent}, {folder}, {variant}, {view}, {index}); ' +
                  '- is stdout; the extension gives the format',
              )
              .option('-r, --recursive', 'draw every .glb and .gltf file beneath the folders'),
          )
            .option('--views <views>', 'one image for each of these views, with commas between; all = every named one')
            .option(
              '--turntable <frames>',
              'so many images of a full turn, in one scale, named side-000 and so on by degrees; one -o that ends in .webp is animated',
            )
            .option('--ambient-visibility', 'darken folds: what each vertex sees of its surroundings is found by rays when the model is loaded')
            .option('--explode <metres>', 'move the parts (nodes) of the model so far apart, along their mean normals')
            .option('--variants <names>', 'one image for each of these variants, with commas between; all = each that the model has')
            .option('--manifest <file>', 'JSON lines {"model", "shot", "output"} in place of models; relative paths start at the file; - is stdin')
            .option('--skip-unchanged', 'leave out images that are there and would be drawn from the same bytes and shot by the same version')
            .option('--jobs <n>', 'draw in so many processes of their own, each one image at a time; auto = one for each core, as far as the memory goes')
            .option(
              '--reached',
              'measure what a picture with a quality of {maxError} came to, in a window of it that the path tracer draws too; --json tells it',
            )
            .option('--contact-sheet <file>', 'write one PNG with a labelled thumbnail of every image')
            .addOption(backend()),
        ),
      ),
    ),
};
