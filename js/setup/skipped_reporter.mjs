// For node --test: a line for each test that was skipped, `file: name (reason)`.

/** @param {AsyncIterable<{type: string, data: {name: string, file?: string, skip?: string | boolean}}>} source */
export default async function* skipped(source) {
  for await (const { type, data } of source) {
    if (type !== 'test:pass' || !data.skip) continue;
    yield `${data.file ? `${data.file.replace(`${process.cwd()}/`, '')}: ` : ''}${data.name}${typeof data.skip === 'string' ? ` (${data.skip})` : ''}\n`;
  }
}
