import type { HostOutput } from '../contract/contract.ts';
import { encodeLayer } from './encode-png.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { type HeldFolder, holdFolder } from './held-folder.ts';
import type { FolderMark } from './page-folder.ts';
import { createProjectJobs } from './project-jobs.ts';

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
  readonly folder: HeldFolder;
  readonly names: string[];
}

const SEQUENCE_FILE = 'sequence.json';
const MARK: FolderMark = { file: SEQUENCE_FILE, format: 'scrim-sequence', words: 'frames that were rendered earlier' };

export function createFrameJobs(files: FileLayer): FrameJobs {
  const jobs = createProjectJobs<Job>('No frames of this project are being rendered.', ({ folder }) => folder.discard());
  return {
    begin: async (projectId, client, options) => {
      await jobs.cancel(projectId);
      await jobs.begin(projectId, client, { ...options, folder: await holdFolder(options.out, files, MARK), names: [] });
    },
    add: async (projectId, number, rgba) => {
      const job = jobs.of(projectId);
      const { widthPx, heightPx, folder, names, out } = job;
      if (rgba.length !== widthPx * heightPx * 4) throw refusal('SCR073', 'The frame has the wrong size.');
      const name = `${String(number).padStart(6, '0')}.png`;
      try {
        await folder.sink.write(name, encodeLayer({ widthPx, heightPx, pixels: rgba }));
      } catch (error) {
        if (jobs.has(projectId, job)) await jobs.cancel(projectId);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      names.push(name);
    },
    finish: async (projectId, { title, frameRateHz }) => {
      const { out, names, widthPx, heightPx, folder } = jobs.of(projectId);
      const about = { format: MARK.format, version: 1, title, frameRateHz, widthPx, heightPx, files: names.map((path) => ({ path })) };
      try {
        await folder.sink.write(SEQUENCE_FILE, new TextEncoder().encode(`${JSON.stringify(about, null, 2)}\n`));
      } catch (error) {
        await jobs.cancel(projectId);
        throw errorCode(error) === undefined ? error : writeRefusal(error, out);
      }
      jobs.complete(projectId);
      await folder.complete();
      return { out, pictures: names.length };
    },
    cancel: jobs.cancel,
    left: jobs.left,
    dispose: jobs.dispose,
  };
}
