import { spawn } from 'node:child_process';

const SUPPORT = new URL('./', import.meta.url).href;

/**
 * Runs module text in a process of its own.
 * @param {string} text
 * @param {{args?: string[], env?: object, support?: boolean}} [options] args: of node; support: have what double.mjs exports
 *   in scope as `support`
 * @returns {Promise<{code: number | null, signal: string | null, stdout: string, stderr: string}>}
 */
export function runChild(text, { args = [], env = {}, support = true } = {}) {
  const source = support ? `import * as support from '${SUPPORT}double.mjs';\n${text}` : text;
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [...args, '--input-type=module', '-e', source], { env: { ...process.env, ...env } });
    let [stdout, stderr] = ['', ''];
    child.stdout.on('data', (chunk) => {
      stdout += chunk;
    });
    child.stderr.on('data', (chunk) => {
      stderr += chunk;
    });
    child.on('error', reject);
    child.on('close', (code, signal) => resolve({ code, signal, stdout, stderr }));
  });
}
