import { readFile, realpath } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { uniqueDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { companionOf } from '../../../export/glsl/isf/read-isf.ts';
import { countsAbove } from '../../../export/glsl/link/link-above.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { MAX_SHADER_BYTES } from '../../services/project-files.ts';
import { readText } from '../../services/read-file.ts';
import { createLinker, LIMIT_S, type Linker, tookTooLong } from './create-linker.ts';
import type * as DriverPage from './driver.page.ts';
import { chunkBeside, type LinkedFile } from './link-file.ts';
import { type DriverOptions, type Judge, verdictDiagnostics, withDriver } from './with-driver.ts';

export interface CheckedFile {
  /** The path as typed. */
  readonly path: string;
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
}

export interface CheckOptions extends DriverOptions {
  readonly interrupted: AbortSignal;
  /** Time limit in seconds for linking one file, and for compiling it. */
  readonly limitS?: number;
}

/** Number of shaders per batch: enough for all threads of the driver, few enough to show progress. */
const BATCH = 32;

/**
 * Compiles shader files with a graphics driver and runs their loops. Returns results in the order of `paths`. Each file is judged
 * alone: one that exceeds the time limit or crashes the linker does not affect the others.
 */
export async function checkShaders(paths: readonly string[], options: CheckOptions): Promise<readonly CheckedFile[]> {
  const { root, say, interrupted, limitS = LIMIT_S } = options;
  const linker = await createLinker(root, limitS);
  try {
    return await withDriver(options, async (judge) => {
      const checked: CheckedFile[] = [];
      const read = async (start: number) => {
        const files: ReadFile[] = [];
        for (const path of paths.slice(start, start + BATCH)) files.push(await readShader(path, linker));
        return files;
      };
      let next = read(0);
      for (let start = 0; start < paths.length; start += BATCH) {
        interrupted.throwIfAborted();
        if (paths.length > BATCH) say(`Compiling ${start + 1} of ${paths.length} shaders…`);
        const judged = judgeFiles(judge, await next, limitS);
        // The driver runs in its own processes, so the next batch is read and linked meanwhile.
        next = read(start + BATCH);
        checked.push(...(await judged));
      }
      return checked;
    });
  } finally {
    await linker.close();
  }
}

type ReadFile = LinkedFile & { readonly vertex: string };

async function readShader(path: string, linker: Linker): Promise<ReadFile> {
  const source = await readFile(path, 'utf8').catch((error: Error) => error);
  const companion = companionOf(path);
  const vertex = companion === path ? null : await readBeside(companion).catch(() => null);
  if (typeof source === 'string') return { ...(await linker.link({ source, file: path, vertex })), vertex: vertex ?? '' };
  const unreadable: Diagnostic = { code: 'SCR004', severity: 'error', message: `The file cannot be read: ${source.message}.`, file: path };
  return { file: path, source: '', vertex: '', passes: [], diagnostics: [unreadable], before: null };
}

/** Reads the vertex shader of an ISF file. The path may be a named pipe, which must not be opened. */
async function readBeside(path: string): Promise<string> {
  return readText(await realpath(path), MAX_SHADER_BYTES);
}

/** Compiles a batch at once; if that exceeds the time limit, one file after the other. */
async function judgeFiles(judge: Judge, files: readonly ReadFile[], limitS: number): Promise<CheckedFile[]> {
  const verdicts = await judge(
    files.flatMap(({ passes }) => passes.map(({ job }) => job)),
    limitS,
  );
  if (verdicts === null) {
    const checked: CheckedFile[] = [];
    for (const file of files) checked.push(await judgeAlone(judge, file, limitS));
    return checked;
  }
  let next = 0;
  return files.map((linked) => {
    const own = verdicts.slice(next, next + linked.passes.length);
    next += linked.passes.length;
    return checkedFile(linked, own);
  });
}

async function judgeAlone(judge: Judge, file: ReadFile, limitS: number): Promise<CheckedFile> {
  const jobs = file.passes.map(({ job }) => job);
  const verdicts = jobs.length === 0 ? [] : await judge(jobs, limitS);
  if (verdicts !== null) return checkedFile(file, verdicts);
  const ended: Diagnostic = { code: 'SCR043', severity: 'error', ...tookTooLong(limitS), file: file.file, line: 1, column: 1 };
  return checkedFile({ ...file, passes: [], diagnostics: [...file.diagnostics, ended] }, []);
}

const SILENT: DriverPage.ShaderVerdict = { logs: [], endlessLine: null };

function checkedFile(
  { file, source, vertex, passes, diagnostics, before }: ReadFile,
  verdicts: readonly DriverPage.ShaderVerdict[],
): CheckedFile {
  const chunkIn = (name: string) => {
    const chunk = name === file ? undefined : /^chunks\/(.+)\.glsl$/.exec(name)?.[1];
    return chunk === undefined ? undefined : chunkBeside(file, chunk);
  };
  const sourceOf = (name: string) => (name === file ? source : (chunkIn(name) ?? vertex));
  const said = passes.flatMap(({ shader }, i) => {
    const verdict = verdicts[i] ?? SILENT;
    if (before === null) return verdictDiagnostics(shader, verdict, sourceOf);
    // The loops of a truncated text may lack the lines that end them.
    return verdictDiagnostics(shader, { ...verdict, endlessLine: null }, sourceOf).filter((diagnostic) => countsAbove(diagnostic, before));
  });
  // There is no node, so only the file identifies the place.
  const all = uniqueDiagnostics(
    [...diagnostics, ...said].map(({ nodeId: _, file: at = file, ...diagnostic }) => ({
      ...diagnostic,
      file: chunkIn(at) === undefined ? at : join(dirname(file), at),
    })),
  );
  return { path: file, ok: !hasErrors(all), diagnostics: all };
}
