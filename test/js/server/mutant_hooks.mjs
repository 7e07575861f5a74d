import { readFileSync } from 'node:fs';

// Hooks of module loading for mutants.mjs, in a thread of their own.

let folders;

export function initialize(data) {
  ({ folders } = data);
}

/** What a mutant imports of its folders is the mutant's too. */
export async function resolve(specifier, context, next) {
  const found = await next(specifier, context);
  const id = new URL(context.parentURL ?? 'file:///').searchParams.get('mutant');
  if (!id || !folders.some((folder) => found.url.startsWith(folder)) || found.url.includes('?')) return found;
  return { ...found, url: `${found.url}?mutant=${id}` };
}

export async function load(url, context, next) {
  const id = new URL(url).searchParams.get('mutant');
  if (!id) return next(url, context);
  const path = url.split('?')[0];
  const file = path.slice(folders.find((folder) => path.startsWith(folder)).length);
  const edits = JSON.parse(Buffer.from(id, 'base64url').toString());
  let source = readFileSync(new URL(path), 'utf8');
  for (const [of, right, wrong] of edits) {
    if (of !== file) continue;
    const times = source.split(right).length - 1;
    if (times !== 1) throw new Error(`${file} has ${times} times: ${right}`);
    source = source.replace(right, () => wrong);
  }
  return { format: 'module', source, shortCircuit: true };
}
