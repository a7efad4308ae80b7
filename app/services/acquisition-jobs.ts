import { rm } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { Photograph } from '../../export/captures/acquire/take-photograph.ts';
import type { AcquiredCamera } from '../../export/captures/acquire/write-transforms.ts';
import { type PackedCapture, packCapture } from './add-capture.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { createProjectJobs } from './project-jobs.ts';
import { makeStagingFolder } from './staging-folder.ts';
import { type AcquisitionWriter, createAcquisitionWriter } from './write-acquisition.ts';

/** Acquisitions of the editor in progress, one per open project. The editor draws the photographs; the host packs them into a capture. */
export interface AcquisitionJobs {
  /** Begins an acquisition. Cancels an earlier one of the same project. */
  begin(projectId: string, client: string, options: AcquisitionOptions): Promise<void>;
  /**
   * Adds a photograph.
   *
   * @throws SCR060, SCR062 if it cannot be written; all photographs are deleted then
   */
  add(projectId: string, index: number, photograph: Photograph): Promise<void>;
  /**
   * Packs the photographs into `assets/NAME.capture/` and deletes them. Null if the acquisition was canceled meanwhile.
   *
   * @throws SCR060, SCR062, SCR069
   */
  finish(projectId: string, say: (text: string) => void): Promise<PackedCapture | null>;
  /** Resolves when all photographs have been deleted. */
  cancel(projectId: string): Promise<void>;
  /** Cancels the acquisitions of a closed window or tab. */
  left(client: string): void;
  dispose(): void;
}

export interface AcquisitionOptions {
  /** Real path of the project. */
  readonly root: string;
  readonly name: string;
  readonly camera: AcquiredCamera;
  /** Column-major 4×4. */
  readonly poses: readonly (readonly number[])[];
}

interface Job extends AcquisitionOptions {
  /** Holds the photographs until they are packed. */
  readonly folder: string;
  readonly writer: AcquisitionWriter;
  readonly canceled: AbortController;
}

const MATRIX_TOLERANCE = 1e-6;

/** @param sources Absolute path of the folder with Scrim's sources and `node_modules`. */
export function createAcquisitionJobs(files: FileLayer, sources: string): AcquisitionJobs {
  const jobs = createProjectJobs<Job>('No photographs of this project are being taken.', async ({ folder, canceled }) => {
    canceled.abort();
    await rm(folder, { recursive: true, force: true }).catch(() => {});
  });
  return {
    begin: async (projectId, client, options) => {
      await jobs.cancel(projectId);
      if (!options.poses.every(isAffine)) throw refusal('SCR073', 'The pose of a camera is not a matrix of a pose.');
      const folder = await makeStagingFolder();
      const write = async (path: string, bytes: Uint8Array): Promise<void> => {
        const target = join(folder, path);
        await files.makeFolder(dirname(target));
        await files.writeNew(target, bytes);
      };
      const writer = createAcquisitionWriter(write, { ...options, depthFormat: 'pfm' });
      await jobs.begin(projectId, client, { ...options, folder, writer, canceled: new AbortController() });
    },
    add: async (projectId, index, photograph) => {
      const job = jobs.of(projectId);
      const { color, depth } = photograph;
      const isWhole = color.pixels.length === 4 * color.widthPx * color.heightPx && depth.meters.length === depth.widthPx * depth.heightPx;
      if (!isWhole || index >= job.poses.length) throw refusal('SCR073', 'The photograph has the wrong size or number.');
      try {
        await job.writer.add(index, photograph);
      } catch (error) {
        if (jobs.has(projectId, job)) await jobs.cancel(projectId);
        throw errorCode(error) === undefined ? error : writeRefusal(error, job.folder);
      }
    },
    finish: async (projectId, say) => {
      const job = jobs.of(projectId);
      const { folder, root, name, writer, canceled } = job;
      try {
        if (writer.empty.length === writer.views.length) throw refusal('SCR069', 'No photograph shows anything.', NOTHING_FIX);
        await writer.finish();
        return await packCapture({
          folder,
          root,
          sources,
          name,
          files,
          say,
          interrupted: canceled.signal,
          maxSidePx: Math.max(job.camera.widthPx, job.camera.heightPx),
          up: '+y',
          metersPerUnit: 1,
          known: { distance: null, floor: null, cameraHeightM: null },
          depth: { from: 'files', unit: 'm', kind: null },
        });
      } catch (error) {
        if (canceled.signal.aborted) return null;
        throw errorCode(error) === undefined ? error : writeRefusal(error, folder);
      } finally {
        if (jobs.has(projectId, job)) await jobs.cancel(projectId);
      }
    },
    cancel: jobs.cancel,
    left: jobs.left,
    dispose: jobs.dispose,
  };
}

const NOTHING_FIX = 'Set the center to the middle of what is to be seen, and the size to where the cameras stand.';

/** Whether the last row of a column-major 4×4 is 0, 0, 0, 1. The import checks the rest. */
function isAffine(m: readonly number[]): boolean {
  return m.length === 16 && [0, 0, 0, 1].every((value, i) => Math.abs((m[4 * i + 3] ?? 0) - value) < MATRIX_TOLERANCE);
}
