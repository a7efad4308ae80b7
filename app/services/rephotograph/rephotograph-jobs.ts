import { dirname } from 'node:path';
import type { RephotographMethod } from '../../../export/captures/evaluate/rephotograph.ts';
import { resolveInside } from '../confine.ts';
import { encodeLayer } from '../encode-png.ts';
import { errorCode, refusal, writeRefusal } from '../file-errors.ts';
import type { FileLayer } from '../file-layer.ts';
import { type HeldFolder, holdFolder } from '../held-folder.ts';
import { createProjectJobs } from '../project-jobs.ts';
import type { MeasuredShot } from './rephotograph-report.ts';
import {
  createRephotographReport,
  methodsOf,
  REPHOTOGRAPH_MARK,
  type RephotographReport,
  readRephotographed,
} from './rephotograph-report.ts';
import type { MethodMeans } from './report-page.ts';

/** Reports of the editor in progress, one per open project. The editor draws the photographs; the host writes the report. */
export interface RephotographJobs {
  /**
   * Begins the report of a capture in `reports/NAME`. Cancels an earlier one of the same project.
   *
   * @returns The methods to draw each photograph by, in order, and the number of photographs.
   * @throws SCR031, SCR032, SCR060, SCR061
   */
  begin(
    projectId: string,
    client: string,
    options: RephotographOptions,
  ): Promise<{ readonly methods: RephotographMethod[]; readonly views: number }>;
  /**
   * Adds a photograph that was drawn by one method.
   *
   * @throws SCR060, SCR062 if it cannot be written; the report is deleted then
   */
  add(projectId: string, index: number, shot: DrawnShot): Promise<void>;
  finish(projectId: string): Promise<readonly MethodMeans[]>;
  /** Resolves when all files have been deleted. */
  cancel(projectId: string): Promise<void>;
  /** Cancels the reports of a closed window or tab. */
  left(client: string): void;
  dispose(): void;
}

export interface RephotographOptions {
  /** Real path of the project. */
  readonly root: string;
  /** Path of `capture.json` in the project. */
  readonly path: string;
  /** Null: all that the capture can be drawn by. */
  readonly method: RephotographMethod | null;
  readonly blended: number;
}

/** What a page drew. The pictures are RGBA, rows from the top. */
export interface DrawnShot extends MeasuredShot {
  readonly widthPx: number;
  readonly heightPx: number;
}

interface Job {
  readonly out: string;
  readonly methods: readonly RephotographMethod[];
  readonly folder: HeldFolder;
  readonly report: RephotographReport;
  /** The methods of the current photograph so far. */
  readonly shots: MeasuredShot[];
}

const REPORTS_FOLDER = 'reports';

/** The folder of the report of a capture. @throws SCR031 */
export function reportFolder(root: string, path: string): Promise<string> {
  const name = dirname(path).split('/').at(-1) ?? '';
  return resolveInside(root, `${REPORTS_FOLDER}/${name.replace(/\.capture$/, '')}`);
}

export function createRephotographJobs(files: FileLayer): RephotographJobs {
  const jobs = createProjectJobs<Job>('No capture of this project is being rephotographed.', ({ folder }) => folder.discard());
  /** Deletes the report if writing to it fails. */
  const writing = async <T>(projectId: string, job: Job, write: () => Promise<T>): Promise<T> => {
    try {
      return await write();
    } catch (error) {
      if (jobs.has(projectId, job)) await jobs.cancel(projectId);
      throw errorCode(error) === undefined ? error : writeRefusal(error, job.out);
    }
  };
  return {
    begin: async (projectId, client, { root, path, method, blended }) => {
      await jobs.cancel(projectId);
      const capture = await resolveInside(root, dirname(path));
      const document = await readRephotographed(capture);
      const out = await reportFolder(root, path);
      const methods = method === null ? [...methodsOf(document)] : [method];
      const folder = await holdFolder(out, files, REPHOTOGRAPH_MARK);
      const report = createRephotographReport(folder.sink, capture, document, blended);
      await jobs.begin(projectId, client, { out, methods, folder, report, shots: [] });
      return { methods, views: document.views.length };
    },
    add: async (projectId, index, { widthPx, heightPx, picture, error, ...figures }) => {
      const job = jobs.of(projectId);
      const { methods, report, shots } = job;
      const isWhole = [picture, error].every(({ length }) => length === 4 * widthPx * heightPx);
      if (!isWhole || figures.method !== methods[shots.length] || index !== report.views.length)
        throw refusal('SCR073', 'The photograph has the wrong size, number or method.');
      const png = (pixels: Uint8Array) => encodeLayer({ widthPx, heightPx, pixels });
      shots.push({ ...figures, picture: png(picture), error: png(error) });
      if (shots.length === methods.length) await writing(projectId, job, () => report.add(index, shots.splice(0)));
    },
    finish: async (projectId) => {
      const job = jobs.of(projectId);
      const means = await writing(projectId, job, job.report.finish);
      jobs.complete(projectId);
      await job.folder.complete();
      return means;
    },
    cancel: jobs.cancel,
    left: jobs.left,
    dispose: jobs.dispose,
  };
}
