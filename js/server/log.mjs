import { fileURLToPath } from 'node:url';

/** Lines of the log: no address with its parameters, no header, no name of a file, no folder of this machine. */

const PACKAGE = fileURLToPath(new URL('../../', import.meta.url));

/** A stack without the folders that the package and the program lie in. */
const withoutFolders = (stack = '') => stack.replaceAll('file://', '').replaceAll(PACKAGE, 'telar/').replaceAll(`${process.cwd()}/`, '');

/** The id that the client gave, where it did. */
const ofClient = ({ id, telar }) => (telar.id === id ? {} : { request: telar.id });

/** One line for each answer. */
export function answerLine(request, { status, seconds }) {
  const { route, code, key } = request.telar;
  const line = { ...ofClient(request), method: request.method, route, status, ms: Math.round(1000 * seconds), ...(code && { code }), ...(key && { key }) };
  request.server.log.info(line, 'answered');
}

/** What went wrong; of a fault of ours with the stack. */
export function errorLine(request, error) {
  const { route } = request.telar;
  const facts = { ...ofClient(request), route, ...error.toJSON() };
  if (error.http < 500) request.server.log.debug(facts, 'refused');
  else
    request.server.log.error(
      { ...facts, stack: withoutFolders(error.stack), ...(error.cause && { cause: withoutFolders(String(error.cause.stack ?? error.cause)) }) },
      'failed',
    );
}
