import type { FileSink } from '../../export/bundle/bundle-page.ts';
import type { HostOutput } from '../contract/contract.ts';
import { encodeLayer } from './encode-png.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { type FolderMark, writePageFolder } from './page-folder.ts';

/** Frame renders in progress, one per open project. */
export interface FrameJobs {
  /**
   * Begins a frame render. Cancels an earlier one of the same project.
   *
   * @throws SCR060, SCR061 if `out` is invalid
   */
  begin(projectId: string, client: string, options: FrameRenderOptions): Promise<void>;
  /**
   * Adds a frame.
   *
   * @throws SCR060, SCR062 if it cannot be written; all frames are deleted then
   */
  add(projectId: string, number: number, rgba: Uint8Array): Promise<void>;
  finish(projectId: string, about: { readonly title: string; readonly frameRateHz: number }): Promise<HostOutput<'frames.finish'>>;
  /** Resolves when all files have been deleted. */
  cancel(projectId: string): Promise<void>;
  /** Cancels the frame renders of a closed window or tab. */
  left(client: string): void;
  dispose(): void;
}

export interface FrameRenderOptions {
  readonly out: string;
  readonly widthPx: number;
  readonly heightPx: number;
}

interface Job extends FrameRenderOptions {
  readonly client: string;
  readonly sink: FileSink;
  readonly names: string[];
  /** Ends the job: true completes it, false discards it. */
  readonly end: (whole: boolean) => void;
  /** Resolves when the folder is in place or has been deleted. */
  readonly done: Promise<unknown>;
}

const SEQUENCE_FILE = 'sequence.json';
const MARK: FolderMark = { file: SEQUENCE_FILE, format: 'scrim-sequence', words: 'frames that were rendered earlier' };

export function createFrameJobs(files: FileLayer): FrameJobs {
  const jobs = new Map<string, Job>();
  const jobOf = (projectId: string): Job => {
    const job = jobs.get(projectId);
    if (!job) throw refusal('SCR073', 'No frames of this project are being rendered.');
    return job;
  };
  const cancel = async (projectId: string): Promise<void> => {
    const job = jobs.get(projectId);
    jobs.delete(projectId);
    job?.end(false);
    await job?.done.catch(() => {});
  };
  return {
    begin: async (projectId, client, options) => {
      await cancel(projectId);
      await new Promise<void>((resolve, reject) => {
        const done: Promise<unknown> = writePageFolder(
          options.out,
          files,
          (sink) =>
            new Promise<true | null>((settle) => {
              jobs.set(projectId, { ...options, client, sink, names: [], done, end: (whole) => settle(whole || null) });
              resolve();
            }),
          MARK,
        );
        done.catch(reject);
      });
    },
    add: async (projectId, number, rgba) => {
      const job = jobOf(projectId);
      const { widthPx, heightPx, sink, names, out } = job;
      if (rgba.length !== widthPx * heightPx * 4) throw refusal('SCR073', 'The frame has the wrong size.');
      const name = `${String(number).padStart(6, '0')}.png`;
      try {
        await sink.write(name, encodeLayer({ widthPx, heightPx, pixels: rgba }));
      } catch (error) {
        if (jobs.get(projectId) === job) await cancel(projectId);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      names.push(name);
    },
    finish: async (projectId, { title, frameRateHz }) => {
      const job = jobOf(projectId);
      const { out, names, widthPx, heightPx, sink } = job;
      const about = { format: MARK.format, version: 1, title, frameRateHz, widthPx, heightPx, files: names.map((path) => ({ path })) };
      try {
        await sink.write(SEQUENCE_FILE, new TextEncoder().encode(`${JSON.stringify(about, null, 2)}\n`));
      } catch (error) {
        await cancel(projectId);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      jobs.delete(projectId);
      job.end(true);
      await job.done;
      return { out, pictures: names.length };
    },
    cancel,
    left: (client) => {
      for (const [projectId, job] of jobs) if (job.client === client) void cancel(projectId);
    },
    dispose: () => {
      for (const projectId of [...jobs.keys()]) void cancel(projectId);
    },
  };
}
