/** What stands before a value that may be - for stdin or stdout and is no model. */
const BEFORE_OTHERS = ['--shot', '-o', '--output'];

/**
 * Whether arguments of `telar thumbnail` say what is drawn: models, a manifest, folders, stdin.
 * @param {string[]} args
 */
export const nameModels = (args) =>
  args.some(
    (arg, i) => /\.(glb|gltf)$/i.test(arg) || /^(-r|--recursive|--manifest)$|^--manifest=/.test(arg) || (arg === '-' && !BEFORE_OTHERS.includes(args[i - 1])),
  );
