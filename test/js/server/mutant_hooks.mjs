import { readFileSync } from 'node:fs';

// Hooks of module loading for mutants.mjs, in a thread of their own.

let folder;

export function initialize(data) {
  ({ folder } = data);
}

/** What a mutant imports of its folder is the mutant's too. */
export async function resolve(specifier, context, next) {
  const found = await next(specifier, context);
  const id = new URL(context.parentURL ?? 'file:///').searchParams.get('mutant');
  if (!id || !found.url.startsWith(folder) || found.url.includes('?')) return found;
  return { ...found, url: `${found.url}?mutant=${id}` };
}

export async function load(url, context, next) {
  const id = new URL(url).searchParams.get('mutant');
  if (!id) return next(url, context);
  const file = url.split('?')[0].slice(folder.length);
  const edits = JSON.parse(Buffer.from(id, 'base64url').toString());
  let source = readFileSync(new URL(url.split('?')[0]), 'utf8');
  for (const [of, right, wrong] of edits) {
    if (of !== file) continue;
    const times = source.split(right).length - 1;
    if (times !== 1) throw new Error(`${file} has ${times} times: ${right}`);
    source = source.replace(right, () => wrong);
  }
  return { format: 'module', source, shortCircuit: true };
}
