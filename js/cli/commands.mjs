import { InvalidArgumentError, Option } from 'commander';
import { DEFAULT_GATE, GATES } from '../compare/gates.mjs';
import { addCommon, addFailOn, addLimit, addLimitOption, backend } from './common_options.mjs';
import { describe } from './describe.mjs';
import { addServiceOptions, addWorkerOptions } from './service_options.mjs';
import { addShotOptions, collect } from './shot_options.mjs';
import { THUMBNAIL } from './thumbnail_command.mjs';

/** The commands: what their command lines take, and what does them. */

const WORKERS_FLAG = ['--workers <n>', 'draw in so many processes; auto = one for each core, as far as the memory goes', 'auto'];
const CGROUP_FLAG = ['--cgroup <path>', 'let the kernel bound the memory of each worker in a group of its own, made in this one (js/docs/pool.md)'];
const STORE_FLAG = ['--store <folder>', 'keep pictures in this folder, and draw none of them twice'];

function port(text) {
  const value = Number(text);
  if (/^\d+$/.test(text) && value >= 1 && value <= 65535) return value;
  throw new InvalidArgumentError('Expected a whole number from 1 to 65535.');
}

/**
 * As the help lists them. Each loads when it runs: --help and --version need none of them, doctor not the shot's schema.
 * @type {Record<string, import('./program.mjs').Row>}
 */
export const COMMANDS = {
  thumbnail: THUMBNAIL,
  inspect: {
    load: async () => (await import('./inspect.mjs')).inspect,
    add: (command) =>
      addLimit(
        addFailOn(
          addCommon(
            addShotOptions(
              command('inspect', 'Say what is in a model, and what a render of it would compile and run')
                .argument('<model>', '.glb or .gltf file; - is stdin')
                .option(
                  '--measure <json>',
                  'a length in metres as Model.measure() takes it, as in {"border": true, "part": {"node": "hem"}}; repeatable',
                  collect,
                ),
            ),
          ),
        ),
      ),
  },
  compare: {
    load: async () => (await import('./compare.mjs')).compare,
    add: (command) =>
      addLimit(
        addCommon(
          command('compare', 'Say how far two images, or the images of two folders, are apart, and whether that is within a gate')
            .argument('<expected>', 'PNG, JPEG or WebP, or a folder of them')
            .argument('[actual]', 'the same; needed unless --model is given')
            .addOption(new Option('--gate <gate>', 'which figures must not be passed').choices(Object.keys(GATES)).default(DEFAULT_GATE))
            .option('--threshold <region.figure=n>', "a limit in place of the gate's or beside them, as in object.flip.mean=0.02", collect)
            .option('--mask <file>', 'image that is light where the object is, for images with a background; or a folder of such')
            .option('--ignore <file>', 'image that is light where nothing is compared, a folder of such, or an area x,y,width,height', collect)
            .option('--resize', 'shrink the larger image to the smaller one, as for screenshots of dense screens')
            .option('--update', 'accept: write ACTUAL over EXPECTED where it is over the gate or new')
            .option('--model <model>', 'in place of ACTUAL: draw this model with the shot inside EXPECTED, which telar view saves')
            .option('--environment <file>', "the file of the shot's environment, where --model is given")
            .option('--explain', 'over the gate, where --model is given: say which term of three.js differs')
            .addOption(backend('where GL comes from, where --model is given'))
            .option('--heatmap <out>', 'write FLIP of each pixel as a PNG')
            .option('--report <dir>', 'write a page with the images, the heat map and the figures')
            .option('--junit <file>', 'write the checks as JUnit XML'),
        ),
      ),
  },
  sheet: {
    load: async () => (await import('./sheet.mjs')).sheet,
    add: (command) =>
      addLimit(
        addFailOn(
          addCommon(
            command('sheet', 'Make the tech sheet of a model: one PDF, or one SVG or PNG a page')
              .argument('<model>', '.glb or .gltf file; - is stdin')
              .requiredOption('-o, --output <out>', 'file that ends in .pdf, .svg or .png; pages of the latter two are numbered')
              .option('--spec <file>', 'JSON of what the sheet says (js/docs/sheet.md); without one it is made from the model; - is stdin')
              .option('--init', 'write that first spec to -o, a .json file, to be edited')
              .option('--previous <file>', 'spec of the last revision: what differs is marked')
              .option('--font <file>', 'font for scripts beside Latin, Greek and Cyrillic; may be given again', collect)
              .option('--template <name=folder>', "folder of an own template, which the spec's `template` names", collect)
              .option('--shot <file>', 'JSON of a shot with the light, shading and quality of the pictures; other keys are refused; - is stdin')
              .option('--set <key=value>', 'one key of that shot, as in --set exposure=1.2; value is JSON or text', collect)
              .addOption(backend()),
          ),
        ),
      ),
  },
  analyse: {
    load: async () => (await import('./analyse.mjs')).analyse,
    add: (command) =>
      addLimit(
        addCommon(
          command('analyse', 'Say which term of one shading against another changes pictures of cloth most')
            .argument('[model...]', '.glb or .gltf files; none = the bundled drape in the fabrics')
            .option(
              '--from <shading>',
              'three-r115, disney-2012, a release as three@180, or JSON of one with terms swapped; others are compared as a whole',
              'three-r115',
            )
            .option('--to <shading>', 'the other one', 'disney-2012')
            .option('--fabrics <names>', 'of the bundled drape: leather,wool,towel,velvet; all of them by default')
            .option('--lights <names>', 'studio, sun, rim, sky or .hdr and .exr files, with commas between; studio,sun by default')
            .option('--view <view>', describe('camera.view'))
            .option('--size <WxH>', 'of each picture in pixels', '320x320')
            .option('--quality <quality>', describe('quality'), 'standard')
            .option('--report <dir>', 'write a page with the ranking, lobes, albedo curves and pictures, and the figures as JSON')
            .option('--terms', 'list slots and terms, and draw nothing')
            .addOption(backend()),
        ),
      ),
  },
  view: {
    load: async () => (await import('./view.mjs')).view,
    add: (command) =>
      addLimit(
        addFailOn(
          addCommon(
            addShotOptions(
              command('view', "Show the browser client beside the server's picture, and their difference, on a local page")
                .argument('<model>', '.glb or .gltf file; - is a GLB on stdin')
                .option(
                  '--spec <file>',
                  'spec of a tech sheet to edit: call-outs and points of measure are made by clicks; a first one is made where there is none',
                )
                .option('--port <port>', 'port on 127.0.0.1; a free one by default', port)
                .option('--three <folder>', "three.js that draws the browser's picture, as in --three node_modules/three; telar's own by default")
                .option('--open', 'open the page in the browser'),
            )
              .addOption(backend())
              .addHelpText('after', '\nThe page judges by the gate parity of telar compare where browser and server draw with the same GL, else by other-gl.'),
          ),
        ),
      ),
  },
  serve: {
    load: async () => (await import('./serve.mjs')).serve,
    add: (command) =>
      addLimit(
        addCommon(
          addServiceOptions(
            command('serve', 'Draw over HTTP: thumbnails, sheets, comparisons and what is in a model, in processes of their own (js/docs/server.md)'),
          )
            .option(...WORKERS_FLAG)
            .option(...CGROUP_FLAG)
            .option('--models <folder>', 'let requests name models by their paths beneath this folder')
            .option(...STORE_FLAG)
            .option('--environment <name=file>', 'let shots name this .hdr or .exr file; repeatable', collect)
            .addOption(backend()),
        ),
      ),
  },
  sign: {
    load: async () => (await import('./sign.mjs')).sign,
    add: (command) =>
      addCommon(
        addShotOptions(
          command('sign', 'Make the signed address of a thumbnail for `telar serve`; TELAR_SIGN_KEY and TELAR_SIGN_SALT have key and salt in hexadecimal')
            .argument('<model>', 'reference of the model, as the service takes it')
            .option('--url <url>', 'address of the service, with its prefix', '')
            .option('--expires <seconds>', 'from now on; without it the address is good for ever'),
        ),
      ),
  },
  worker: {
    load: async () => (await import('./worker.mjs')).worker,
    add: (command) =>
      addLimit(
        addCommon(
          addWorkerOptions(command('worker', 'Draw the jobs of a queue that other processes fill, as telar serve does (js/docs/queue.md)'))
            .option(...WORKERS_FLAG)
            .option(...CGROUP_FLAG)
            .option(...STORE_FLAG)
            .option('--put-host <host>', 'host, or host:port, that jobs may have their results sent to; repeatable; any by default', collect)
            .addOption(backend()),
        ),
      ),
  },
  bake: {
    load: async () => (await import('./bake.mjs')).bake,
    add: (command) =>
      addLimit(
        addFailOn(
          addCommon(
            command('bake', 'Write a model with its ambient visibility in its vertices, which the shading "fabric" reads')
              .argument('<model>', '.glb or .gltf file; - is stdin')
              .requiredOption('-o, --output <out>', 'file that ends as the model does; - is stdout')
              .option('--rays <n>', 'rays of each side of a vertex, 16 to 4096; 256 by default'),
          ),
        ),
      ),
  },
  looks: {
    load: async () => (await import('./looks.mjs')).looks,
    add: (command) => addCommon(command('looks', 'Say what the looks of --look are; --json prints the shots that they stand for')),
  },
  doctor: {
    load: async () => (await import('./doctor.mjs')).doctor,
    add: (command) => addCommon(command('doctor', 'Say which GL backends this machine has, which is chosen, and how to cure a missing one')),
  },
  bench: {
    text: 'Measure this machine and telar on it',
    of: {
      trade: {
        load: async () => (await import('./bench.mjs')).benchTrade,
        add: (command) =>
          addCommon(
            addLimitOption(
              command('trade', 'Time and error of every quality against the path tracer, as a page, CSV and SVG; a run that was stopped goes on where it was')
                .argument('[model...]', '.glb or .gltf files in place of the bundled drape in cloths; with --cloths beside it')
                .requiredOption('-o, --output <dir>', 'folder of the page, the figures and what was measured so far')
                .option('--cloths <names>', 'cloths of js/docs/cloths.md for the bundled drape, with commas between')
                .option('--environments <names>', 'studio, sun, rim, sky or .hdr and .exr files, with commas between; studio,sun,sky by default')
                .option('--sizes <pixels>', 'of the pictures, with commas between', '256,512,1024')
                .option('--shadings <names>', 'with commas between', 'fabric')
                .option('--settings <names>', 'some of those that are measured, with commas between; all by default')
                .option('--setting <name=json>', 'a quality beside them, as in fine={"samples":64,"environmentSamples":1024}; repeatable', collect)
                .option('--knobs', 'each number of a quality and of shadows alone, from "standard", and the steepest together, in place of --settings')
                .option('--window <pixels>', 'side of the part of each picture that is compared', '48')
                .option('--cap <seconds>', 'CPU time from which on a setting is drawn in the window alone', '20')
                .addOption(backend()),
            ),
          ),
      },
    },
  },
};
