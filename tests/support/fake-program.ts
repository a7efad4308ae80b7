import { chmod, mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';

export interface FakeProgram {
  readonly path: string;
  /** The arguments of each call. */
  calls(): Promise<readonly (readonly string[])[]>;
}

/**
 * Writes an executable file that records its arguments and runs a script of Node, which sees them as `args`, and the modules `fs` and `path`.
 */
export async function writeProgram(path: string, script: string): Promise<FakeProgram> {
  const record = join(dirname(path), 'calls.txt');
  await mkdir(dirname(path), { recursive: true });
  const text = `#!${process.execPath}
const fs = require('node:fs');
const path = require('node:path');
const args = process.argv.slice(2);
fs.appendFileSync(${JSON.stringify(record)}, JSON.stringify(args) + '\\n');
${script}
`;
  await writeFile(path, text);
  await chmod(path, 0o755);
  return {
    path,
    calls: async () => (await readFile(record, 'utf8')).split('\n').flatMap((line) => (line === '' ? [] : [JSON.parse(line) as string[]])),
  };
}
