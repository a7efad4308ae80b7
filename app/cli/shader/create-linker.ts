import { once } from 'node:events';
import { Worker } from 'node:worker_threads';
import { bundleWorker } from '../../../export/bundle/bundle-worker.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { LinkedFile } from './link-file.ts';
import type { LinkQuestion } from './link-worker.ts';

/** Time limit in seconds for linking one file, and for compiling it. */
export const LIMIT_S = 10;

/** Links files one after another in a worker that can be terminated. */
export interface Linker {
  link(question: LinkQuestion): Promise<LinkedFile>;
  close(): Promise<void>;
}

const WORKER_ENTRY = 'app/cli/shader/link-worker.ts';

/**
 * Creates a linker.
 *
 * @param root Folder with the sources of Scrim.
 * @param limitS Time limit per file. A file that exceeds it or crashes the linker gets a diagnostic.
 */
export async function createLinker(root: string, limitS = LIMIT_S): Promise<Linker> {
  const code = await bundleWorker(root, WORKER_ENTRY);
  let worker: Worker | null = null;

  async function endWorker(): Promise<void> {
    const ended = worker;
    worker = null;
    await ended?.terminate();
  }

  return {
    link: async (question) => {
      worker ??= await startWorker(code);
      const answer = await ask(worker, question, limitS);
      if ('linked' in answer) return answer.linked;
      await endWorker();
      return unlinked(question, answer.refused);
    },
    close: endWorker,
  };
}

/** Starts the worker, and waits until it is ready. The time to start does not count toward the limit of a file. */
async function startWorker(code: string): Promise<Worker> {
  const worker = new Worker(code, { eval: true });
  await once(worker, 'message');
  return worker;
}

type Answer = { readonly linked: LinkedFile } | { readonly refused: Pick<Diagnostic, 'message' | 'fix'> };

function ask(worker: Worker, question: LinkQuestion, limitS: number): Promise<Answer> {
  return new Promise((resolve) => {
    const limit = AbortSignal.timeout(limitS * 1000);
    const tooLong = () => done({ refused: tookTooLong(limitS) });
    const failed = (fault: string) => done({ refused: { message: `Scrim cannot read this file: ${fault.split('\n')[0]}.` } });
    const answered = (answer: { linked: LinkedFile } | { fault: string }) => ('linked' in answer ? done(answer) : failed(answer.fault));
    const broken = (error: Error) => failed(error.message);
    function done(answer: Answer): void {
      limit.removeEventListener('abort', tooLong);
      worker.off('message', answered);
      worker.off('error', broken);
      resolve(answer);
    }
    limit.addEventListener('abort', tooLong);
    worker.on('message', answered);
    worker.on('error', broken);
    worker.postMessage(question);
  });
}

export function tookTooLong(limitS: number): Pick<Diagnostic, 'message' | 'fix'> {
  return {
    message: `The check of this file took longer than ${limitS} s and was stopped.`,
    fix: 'Shorten the shader, or simplify its loops and macros.',
  };
}

function unlinked({ file, source }: LinkQuestion, refused: Pick<Diagnostic, 'message' | 'fix'>): LinkedFile {
  return {
    file,
    source,
    passes: [],
    diagnostics: [{ code: 'SCR043', severity: 'error', ...refused, file, line: 1, column: 1 }],
    before: null,
  };
}
