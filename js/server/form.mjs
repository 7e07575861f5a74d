import { createHash } from 'node:crypto';
import { handOver } from '../api/handed_over.mjs';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { receive, tooLarge } from './receive.mjs';

/** Forms (multipart/form-data, RFC 7578): texts and files by their names. */

const MOST = { fields: 64, files: 320, fieldNameSize: 100, headerPairs: 32 };
/** Bytes of one text: a shot, a spec. */
const TEXT_BYTES = 2 ** 20;

const NAMELESS = 'a part of it has no name';

const malformed = (message) => new TelarError('E_REQUEST', `the form is malformed: ${message}`);

/**
 * @typedef {object} FormFile
 * @property {string} field
 * @property {string} name as its sender calls it; never a path here
 * @property {Buffer} bytes
 */

/** Takes what the parser finds. */
class Parts {
  texts = new Map();
  files = [];
  #failure;
  #fileBytes;

  constructor(fileBytes) {
    this.#fileBytes = fileBytes;
  }

  text(name, value, isNameCut, isCut) {
    if (name === undefined) this.fail(malformed(NAMELESS));
    else if (isNameCut) this.fail(malformed('a name of a field is too long'));
    else if (isCut) this.fail(tooLarge('L_REQUEST_BYTES', TEXT_BYTES, TEXT_BYTES + 1, `the field ${shown(name)}`));
    else if (this.texts.has(name)) this.fail(new TelarError('E_REQUEST', `request.${shown(name).slice(1, -1)}: it is given twice`));
    else this.texts.set(name, value);
  }

  file(field, stream, name = '') {
    if (field === undefined) this.fail(malformed(NAMELESS));
    const chunks = [];
    const hash = createHash('sha256');
    stream.on('data', (chunk) => {
      chunks.push(chunk);
      hash.update(chunk);
    });
    stream.on('limit', () => this.fail(tooLarge('L_FILE_BYTES', this.#fileBytes, this.#fileBytes + 1, `the file ${shown(field)}`)));
    stream.on('error', () => this.fail(malformed('a file of it ends early')));
    stream.on('end', () => {
      const bytes = chunks.length === 1 ? chunks[0] : Buffer.concat(chunks);
      this.files.push({ field, name, bytes: handOver(bytes, hash.digest('hex')) });
    });
  }

  fail(error) {
    this.#failure ??= error;
  }

  /** @throws {TelarError} */
  check() {
    if (this.#failure) throw this.#failure;
  }
}

/**
 * @param {import('node:http').IncomingMessage} message
 * @param {object} bounds of receive()
 * @param {number} bounds.fileBytes of each file
 * @returns {Promise<{texts: Map<string, string>, files: FormFile[]}>}
 * @throws {TelarError} E_REQUEST, L_FILE_BYTES, and what receive() throws
 */
export async function receiveForm(message, { fileBytes, ...bounds }) {
  const { Busboy } = await import('@fastify/busboy');
  const parts = new Parts(fileBytes);
  const parser = parserOf(Busboy, message, fileBytes);
  parser.on('field', (...text) => parts.text(...text));
  parser.on('file', (...file) => parts.file(...file));
  for (const event of ['partsLimit', 'filesLimit', 'fieldsLimit']) parser.on(event, () => parts.fail(malformed('it has too many parts')));
  const finished = new Promise((resolve, reject) => {
    parser.once('finish', resolve);
    parser.once('error', ({ message: text }) => reject(malformed(shown(text))));
  });
  // Waited for below; one that fails before is no unhandled rejection.
  finished.catch(() => {});
  await receive(message, bounds, (chunk) => {
    parser.write(chunk);
    parts.check();
  });
  parser.end();
  await finished;
  parts.check();
  return parts;
}

function parserOf(Busboy, { headers }, fileBytes) {
  try {
    return new Busboy({ headers, limits: { ...MOST, fileSize: fileBytes, fieldSize: TEXT_BYTES } });
  } catch (error) {
    throw malformed(shown(error.message));
  }
}
