// What the compiler and linker were told stands in the files that they wrote: the addon and our libraries are read as ELF.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const FOLDER = path.join(process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/dev'), 'addon');
const PRODUCTS = ['libtelar_oiio.so', 'libtelar_reference.so', 'libtelar_worker.so', 'telar.node'];

// src: System V ABI, chapter 5, and its supplements for GNU; <elf.h>.
const PT_DYNAMIC = 2,
  PT_GNU_STACK = 0x6474e551,
  PT_GNU_RELRO = 0x6474e552,
  PF_X = 1;
const SHT_DYNSYM = 11,
  DT_FLAGS = 30,
  DF_BIND_NOW = 8;

/** Program headers, entries of the dynamic section, and names of the dynamic symbols of a 64-bit little-endian ELF. */
function readElf(file) {
  assert.equal(file.subarray(0, 6).toString('latin1'), '\x7fELF\x02\x01');
  const at = (offset) => Number(file.readBigUInt64LE(offset));
  const table = (offset, size, count) => Array.from({ length: count }, (_, i) => offset + i * size);
  const segments = table(at(32), file.readUInt16LE(54), file.readUInt16LE(56)).map((i) => ({
    type: file.readUInt32LE(i),
    flags: file.readUInt32LE(i + 4),
    offset: at(i + 8),
    size: at(i + 32),
  }));
  const sections = table(at(40), file.readUInt16LE(58), file.readUInt16LE(60)).map((i) => ({
    type: file.readUInt32LE(i + 4),
    offset: at(i + 24),
    size: at(i + 32),
    link: file.readUInt32LE(i + 40),
  }));
  const dynamic = segments.find(({ type }) => type === PT_DYNAMIC);
  const entries = new Map(table(dynamic.offset, 16, dynamic.size / 16).map((i) => [at(i), at(i + 8)]));
  const symbols = sections.find(({ type }) => type === SHT_DYNSYM);
  const names = table(symbols.offset, 24, symbols.size / 24).map((i) => {
    const start = sections[symbols.link].offset + file.readUInt32LE(i);
    return file.toString('latin1', start, file.indexOf(0, start));
  });
  return { segments, entries, names };
}

/** What of the hardening a file lacks. FORTIFY shows as libc's checked functions, a canary as the one that ends the process. */
function missingIn(file) {
  const { segments, entries, names } = readElf(file);
  const stack = segments.find(({ type }) => type === PT_GNU_STACK);
  const has = {
    'stack protector': names.includes('__stack_chk_fail'),
    FORTIFY: names.some((name) => /^__.*_chk$/.test(name)),
    RELRO: segments.some(({ type }) => type === PT_GNU_RELRO),
    'binding at load': ((entries.get(DT_FLAGS) ?? 0) & DF_BIND_NOW) !== 0,
    'a stack that is not executable': stack !== undefined && (stack.flags & PF_X) === 0,
  };
  return Object.keys(has).filter((name) => !has[name]);
}

for (const name of PRODUCTS) test(`${name} is hardened`, () => assert.deepEqual(missingIn(readFileSync(path.join(FOLDER, name))), []));

test('no other library of ours is left out', () => {
  const built = readdirSync(FOLDER).filter((file) => /\.(so|node)$/.test(file) && file !== 'telar_double.node');
  assert.deepEqual(built.sort(), PRODUCTS);
});

// Each fault is planted: a library that is built without one of the flags.
const SOURCE = '#include <cstdio>\n#include <cstring>\nextern "C" void parse(const char* from) { char text[64]; std::strcpy(text, from); std::puts(text); }\n';
const FLAGS = {
  'stack protector': ['-fstack-protector-strong', '-fno-stack-protector'],
  FORTIFY: ['-D_FORTIFY_SOURCE=3', '-D_FORTIFY_SOURCE=0'],
  RELRO: ['-Wl,-z,relro', '-Wl,-z,norelro'],
  'binding at load': ['-Wl,-z,now', '-Wl,-z,lazy'],
  'a stack that is not executable': ['-Wl,-z,noexecstack', '-Wl,-z,execstack'],
};

test('a library that is built without one of them is told', (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-elf-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const [source, library] = ['parse.cpp', 'parse.so'].map((name) => path.join(folder, name));
  writeFileSync(source, SOURCE);
  const missingWithout = (left) => {
    const flags = Object.entries(FLAGS).map(([name, [on, off]]) => (name === left ? off : on));
    execFileSync(process.env.CXX ?? 'g++', ['-shared', '-fPIC', '-O2', '-w', '-U_FORTIFY_SOURCE', ...flags, source, '-o', library]);
    return missingIn(readFileSync(library));
  };
  assert.deepEqual(missingWithout(null), []);
  for (const name of Object.keys(FLAGS)) assert.deepEqual(missingWithout(name), [name]);
});
