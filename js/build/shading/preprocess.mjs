// Includes and conditionals of shader text, as far as they are known before three.js compiles it.

import { reduced } from './expression.mjs';

const INCLUDE = /^#include "([^"]+)"$/;
const DIRECTIVE = /^\s*#\s*(if|elif|else|endif)\b\s*(.*)$/;
const NAMED_CONDITION = /^(#define \w+) \((.*)\)$/;
const NAME = /\b[A-Za-z_]\w*\b/g;

/**
 * Text with its includes, each file once, as renderer/shader does it.
 * @param {string} text
 * @param {(file: string) => string} read - Text of a file beneath shaders/; '' for one to leave out.
 * @param {Set<string>} [done] - Files that were included.
 */
export function included(text, read, done = new Set()) {
  return text.split('\n').map((line) => {
    const file = INCLUDE.exec(line)?.[1];
    if (!file) return line;
    if (done.has(file)) return '';
    done.add(file);
    return included(read(file), read, done);
  }).join('\n');
}

/** Without comments and empty lines. */
export function withoutComments(text) {
  return text.replace(/\/\*[\s\S]*?\*\//g, '').split('\n').map((line) => line.replace(/\s*\/\/.*$/, '').trimEnd()).filter(Boolean).join('\n');
}

/**
 * Takes the branches whose conditions the known numbers decide; the others stay, the known numbers written out.
 * @param {string} text
 * @param {Record<string, number>} known
 */
export function decided(text, known) {
  const lines = text.replace(/^\s*#ifdef (\w+)/gm, '#if defined($1)').replace(/^\s*#ifndef (\w+)/gm, '#if !defined($1)').split('\n');
  const [body, end] = blockAt(lines, 0, known);
  if (end !== lines.length) throw new Error(`#${DIRECTIVE.exec(lines[end])[1]} without #if: ${lines[end]}`);
  return body.join('\n');
}

/** Lines of a block from `at` on, and the index of the directive that ends it. */
function blockAt(lines, at, known) {
  const body = [];
  while (at < lines.length) {
    const [, directive, condition] = DIRECTIVE.exec(lines[at]) ?? [];
    if (directive && directive !== 'if') break;
    if (directive) {
      const [chain, next] = chainAt(lines, at, condition, known);
      body.push(...chain);
      at = next;
    } else body.push(withKnown(lines[at++], known));
  }
  return [body, at];
}

/** A condition with a name of its own keeps no name that is known. */
function withKnown(line, known) {
  const [, define, condition] = NAMED_CONDITION.exec(line) ?? [];
  return define ? `${define} (${reduced(condition, known)})` : line;
}

/** #if ... #endif from `at` on as lines, and the index behind it. */
function chainAt(lines, at, firstCondition, known) {
  const kept = [];
  let condition = firstCondition;
  let isOver = false;
  for (;;) {
    const [body, end] = blockAt(lines, at + 1, known);
    if (end >= lines.length) throw new Error(`#if ${firstCondition} without #endif`);
    const value = condition === null ? true : leftOf(condition, known);
    if (!isOver && value !== false) kept.push({ condition: value === true ? null : value, body });
    isOver ||= value === true;
    const [, directive, next] = DIRECTIVE.exec(lines[end]);
    if (directive === 'endif') return [linesOf(kept), end + 1];
    condition = directive === 'else' ? null : next;
    at = end;
  }
}

function linesOf(branches) {
  if (branches.every(({ body }) => body.length === 0)) return [];
  if (branches[0].condition === null) return branches[0].body;
  const opened = branches.flatMap(({ condition, body }, i) => [i === 0 ? `#if ${condition}` : condition === null ? '#else' : `#elif ${condition}`, ...body]);
  return [...opened, '#endif'];
}

/** @returns {boolean | string} What is left of a condition. */
function leftOf(condition, known) {
  const left = reduced(condition, known);
  return typeof left === 'number' ? left !== 0 : left;
}

/** Names in the conditions of a text that have to have a value. */
export function conditionNames(text) {
  const names = new Set();
  for (const line of text.split('\n')) {
    const [, directive, condition] = DIRECTIVE.exec(line) ?? [];
    if (directive === 'if' || directive === 'elif') for (const name of condition.replaceAll(/defined\s*\(\s*\w+\s*\)/g, '').match(NAME) ?? []) names.add(name);
  }
  return names;
}
