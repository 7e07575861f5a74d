import { spawn } from 'node:child_process';

const SUPPORT = new URL('./', import.meta.url).href;

/**
 * Runs module text in a process of its own; `support` is in scope, with what double.mjs exports.
 * @param {string} text
 * @param {{args?: string[], env?: object}} [options] args: of node
 * @returns {Promise<{code: number | null, signal: string | null, stdout: string, stderr: string, ms: number}>}
 */
export function runChild(text, { args = [], env = {} } = {}) {
  const source = `import * as support from '${SUPPORT}double.mjs';\n${text}`;
  return new Promise((resolve, reject) => {
    const start = performance.now();
    const child = spawn(process.execPath, [...args, '--input-type=module', '-e', source], { env: { ...process.env, ...env } });
    let [stdout, stderr] = ['', ''];
    child.stdout.on('data', (chunk) => { stdout += chunk; });
    child.stderr.on('data', (chunk) => { stderr += chunk; });
    child.on('error', reject);
    child.on('close', (code, signal) => resolve({ code, signal, stdout, stderr, ms: performance.now() - start }));
  });
}
