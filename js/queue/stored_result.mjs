import { createHash } from 'node:crypto';

/** A result as one string of bytes: a line that names the format, SHA-256 of what follows, a line of JSON, and the files one after the other. */

const MAGIC = Buffer.from('telar result 1\n');
const DIGEST_BYTES = 32;
const BEGIN = MAGIC.length + DIGEST_BYTES;

const sha256 = (pieces) => pieces.reduce((hash, piece) => hash.update(piece), createHash('sha256')).digest();

/** @param {import('./perform.mjs').Result} result @returns {Buffer} */
export function packResult({ key, info, files }) {
  const header = { key, info, files: files.map(({ name, type, data }) => ({ name, type, bytes: data.byteLength })) };
  const pieces = [Buffer.from(`${JSON.stringify(header)}\n`), ...files.map(({ data }) => data)];
  return Buffer.concat([MAGIC, sha256(pieces), ...pieces]);
}

/**
 * @param {Buffer} bytes
 * @param {string} key that it must have
 * @returns {import('./perform.mjs').Result | undefined} undefined of bytes that are damaged, cut, or of another key
 */
export function unpackResult(bytes, key) {
  const rest = bytes.subarray(BEGIN);
  if (!bytes.subarray(0, MAGIC.length).equals(MAGIC) || !bytes.subarray(MAGIC.length, BEGIN).equals(sha256([rest]))) return undefined;
  const end = rest.indexOf('\n');
  const { key: own, info, files } = JSON.parse(rest.subarray(0, end).toString());
  if (own !== key) return undefined;
  let at = end + 1;
  const read = files.map(({ name, type, bytes: length }) => {
    const data = rest.subarray(at, at + length);
    at += length;
    return { name, type, data };
  });
  return { key, info, files: read };
}
