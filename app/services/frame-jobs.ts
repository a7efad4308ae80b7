import type { FileSink } from '../../export/bundle/file-sink.ts';
import type { HostOutput } from '../contract/contract.ts';
import { encodeLayer } from './encode-png.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { type FolderMark, writePageFolder } from './page-folder.ts';

/** Frame renders in progress, one folder for each open project. */
export interface FrameJobs {
  /** Cancels an earlier render of the same project. Throws SCR060 and SCR061 if `out` is invalid. */
  begin(projectId: string, client: string, wish: FramesWish): Promise<void>;
  /** Throws SCR060 and SCR062 where it cannot be written: nothing is left then. */
  add(projectId: string, number: number, rgba: Uint8Array): Promise<void>;
  finish(projectId: string, about: { readonly title: string; readonly frameRateHz: number }): Promise<HostOutput<'frames.finish'>>;
  /** Resolves when nothing is left of it. */
  cancel(projectId: string): Promise<void>;
  /** A window or tab is gone, and what it rendered with it. */
  left(client: string): void;
  dispose(): void;
}

export interface FramesWish {
  readonly out: string;
  readonly widthPx: number;
  readonly heightPx: number;
}

interface Job extends FramesWish {
  readonly client: string;
  readonly sink: FileSink;
  readonly names: string[];
  /** True: it is whole; false: it is given up. */
  readonly over: (whole: boolean) => void;
  /** When the folder stands in its place, or nothing is left of it. */
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
    job?.over(false);
    await job?.done.catch(() => {});
  };
  return {
    begin: async (projectId, client, wish) => {
      await cancel(projectId);
      await new Promise<void>((resolve, reject) => {
        const done: Promise<unknown> = writePageFolder(
          wish.out,
          files,
          (sink) =>
            new Promise<true | null>((settle) => {
              jobs.set(projectId, { ...wish, client, sink, names: [], done, over: (whole) => settle(whole || null) });
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
      job.over(true);
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
