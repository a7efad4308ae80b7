import type { FileSink } from '../../export/bundle/file-sink.ts';
import type { HostOutput } from '../contract/contract.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { type FolderMark, writePageFolder } from './page-folder.ts';
import { encodeLayer } from './pictures.ts';

/** Pictures of frames that editors are rendering, one folder for each open project. */
export interface FrameJobs {
  /** Ends the one before of the same project. Throws SCR060 and SCR061 where `out` will not do. */
  begin(handle: string, client: string, wish: FramesWish): Promise<void>;
  /** Throws SCR060 and SCR062 where it cannot be written: nothing is left then. */
  add(handle: string, number: number, rgba: Uint8Array): Promise<void>;
  finish(handle: string, about: { readonly title: string; readonly frameRateHz: number }): Promise<HostOutput<'frames.finish'>>;
  /** Resolves when nothing is left of it. */
  cancel(handle: string): Promise<void>;
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
  const jobOf = (handle: string): Job => {
    const job = jobs.get(handle);
    if (!job) throw refusal('SCR073', 'No frames of this project are being rendered.');
    return job;
  };
  const cancel = async (handle: string): Promise<void> => {
    const job = jobs.get(handle);
    jobs.delete(handle);
    job?.over(false);
    await job?.done.catch(() => {});
  };
  return {
    begin: async (handle, client, wish) => {
      await cancel(handle);
      await new Promise<void>((resolve, reject) => {
        const done: Promise<unknown> = writePageFolder(
          wish.out,
          files,
          (sink) =>
            new Promise<true | null>((settle) => {
              jobs.set(handle, { ...wish, client, sink, names: [], done, over: (whole) => settle(whole || null) });
              resolve();
            }),
          MARK,
        );
        done.catch(reject);
      });
    },
    add: async (handle, number, rgba) => {
      const job = jobOf(handle);
      const { widthPx, heightPx, sink, names, out } = job;
      if (rgba.length !== widthPx * heightPx * 4) throw refusal('SCR073', 'The picture has another size.');
      const name = `${String(number).padStart(6, '0')}.png`;
      try {
        await sink.write(name, encodeLayer({ widthPx, heightPx, pixels: rgba }));
      } catch (error) {
        if (jobs.get(handle) === job) await cancel(handle);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      names.push(name);
    },
    finish: async (handle, { title, frameRateHz }) => {
      const job = jobOf(handle);
      const { out, names, widthPx, heightPx, sink } = job;
      const about = { format: MARK.format, version: 1, title, frameRateHz, widthPx, heightPx, files: names.map((path) => ({ path })) };
      try {
        await sink.write(SEQUENCE_FILE, new TextEncoder().encode(`${JSON.stringify(about, null, 2)}\n`));
      } catch (error) {
        await cancel(handle);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      jobs.delete(handle);
      job.over(true);
      await job.done;
      return { out, pictures: names.length };
    },
    cancel,
    left: (client) => {
      for (const [handle, job] of jobs) if (job.client === client) void cancel(handle);
    },
    dispose: () => {
      for (const handle of [...jobs.keys()]) void cancel(handle);
    },
  };
}
