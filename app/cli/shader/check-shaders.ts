import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { uniqueDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { companionOf } from '../../../export/glsl/isf/read-isf.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type * as DriverPage from './driver.page.ts';
import { chunkBeside, type LinkedFile, linkFile } from './link-file.ts';
import { type DriverOptions, type Judge, verdictDiagnostics, withDriver } from './with-driver.ts';

export interface CheckedFile {
  /** As the command line names it. */
  readonly path: string;
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
}

export interface CheckOptions extends DriverOptions {
  readonly interrupted: AbortSignal;
}

/** Shaders that the driver is given at once: enough for all its threads, few enough that progress shows. */
const BATCH = 32;

/** Compiles shader files in the real driver, and runs their loops. Answers in the order of `paths`. */
export function checkShaders(paths: readonly string[], options: CheckOptions): Promise<readonly CheckedFile[]> {
  const { say, interrupted } = options;
  return withDriver(options, async (judge) => {
    const checked: CheckedFile[] = [];
    const read = (start: number) => Promise.all(paths.slice(start, start + BATCH).map(readShader));
    let next = read(0);
    for (let start = 0; start < paths.length; start += BATCH) {
      interrupted.throwIfAborted();
      if (paths.length > BATCH) say(`Compiling ${start + 1} of ${paths.length} shaders…`);
      const judged = judgeFiles(judge, await next);
      // The driver has its own processes: meanwhile the next are read and linked.
      next = read(start + BATCH);
      checked.push(...(await judged));
    }
    return checked;
  });
}

type ReadFile = LinkedFile & { readonly vertex: string };

async function readShader(path: string): Promise<ReadFile> {
  const source = await readFile(path, 'utf8').catch((error: Error) => error);
  const companion = companionOf(path);
  const vertex = companion === path ? null : await readFile(companion, 'utf8').catch(() => null);
  if (typeof source === 'string') return { ...linkFile(source, path, vertex), vertex: vertex ?? '' };
  const unreadable: Diagnostic = { code: 'SCR004', severity: 'error', message: `The file cannot be read: ${source.message}.`, file: path };
  return { file: path, source: '', vertex: '', passes: [], diagnostics: [unreadable] };
}

async function judgeFiles(judge: Judge, files: readonly ReadFile[]): Promise<CheckedFile[]> {
  const verdicts = await judge(files.flatMap(({ passes }) => passes.map(({ job }) => job)));
  let next = 0;
  return files.map((linked) => {
    const own = verdicts.slice(next, next + linked.passes.length);
    next += linked.passes.length;
    return checkedFile(linked, own);
  });
}

function checkedFile({ file, source, vertex, passes, diagnostics }: ReadFile, verdicts: readonly DriverPage.ShaderVerdict[]): CheckedFile {
  const chunkIn = (name: string) => {
    const chunk = name === file ? undefined : /^chunks\/(.+)\.glsl$/.exec(name)?.[1];
    return chunk === undefined ? undefined : chunkBeside(file, chunk);
  };
  const sourceOf = (name: string) => (name === file ? source : (chunkIn(name) ?? vertex));
  const said = passes.flatMap(({ shader }, i) => verdictDiagnostics(shader, verdicts[i], sourceOf));
  // There is no node: the file alone says where.
  const all = uniqueDiagnostics(
    [...diagnostics, ...said].map(({ nodeId: _, file: at = file, ...diagnostic }) => ({
      ...diagnostic,
      file: chunkIn(at) === undefined ? at : join(dirname(file), at),
    })),
  );
  return { path: file, ok: !hasErrors(all), diagnostics: all };
}
