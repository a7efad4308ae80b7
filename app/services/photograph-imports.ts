import { rm } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { firstEye } from '../../export/captures/first-eye.ts';
import { CaptureError } from '../../nodes/kit/capture.ts';
import type { HostInput, HostOutput } from '../contract/contract.ts';
import { HostError } from '../contract/host-error.ts';
import { packCapture } from './add-capture.ts';
import { realFolder, resolveInside } from './confine.ts';
import { errorCode, refusal, writeRefusal } from './file-errors.ts';
import type { FileLayer } from './file-layer.ts';
import { UNKNOWN_SIZE } from './measure-capture.ts';
import { COLMAP, findTypedTool } from './outside/outside-tools.ts';
import type { ToolEvents, ToolJobs } from './outside/tool-jobs.ts';
import { readCaptureDocument } from './read-capture.ts';
import { hasCameras, readCameras } from './read-capture-folder.ts';
import { openColmap } from './reconstruct/colmap.ts';
import { guessedUnit } from './reconstruct/guessed-unit.ts';
import { countPhotographs, isReconstructed, type Reconstruction, reconstruct } from './reconstruct/reconstruct-photographs.ts';
import { ensureScrimFolder, SCRIM_FOLDER } from './scrim-folder.ts';
import { surveyPhotographs } from './survey-photographs.ts';

/** Imports of photographs in the editor. Cameras that are missing are found by COLMAP. */
export interface PhotographImports {
  /** What is in a folder, and whether COLMAP is there. */
  look(input: Pick<HostInput<'photographs.look'>, 'colmap'>, folder: string): Promise<HostOutput<'photographs.look'>>;
  /** Reads what an import must decide before. @throws SCR004, SCR060, SCR069 */
  survey(folder: string): Promise<HostOutput<'photographs.survey'>>;
  /**
   * Imports a folder. `path` is null if it was canceled; what COLMAP has finished is kept for the next import of the same folder.
   *
   * @throws SCR004, SCR060, SCR061, SCR062, SCR069, SCR078
   */
  run(projectId: string, client: string, job: PhotographJob): Promise<HostOutput<'photographs.import'>>;
  /**
   * Writes a file of a folder that was dropped into the project, for an import. `first` removes what was dropped before.
   *
   * @returns The absolute path of the folder.
   * @throws SCR031, SCR060, SCR062
   */
  stage(root: string, file: Omit<HostInput<'photographs.stage'>, 'handle'>): Promise<string>;
}

type PhotographOptions = Omit<HostInput<'photographs.import'>, 'handle' | 'folder'>;

export interface PhotographJob extends PhotographOptions, ToolEvents {
  /** Absolute path of the folder. */
  readonly folder: string;
  /** Real path of the project. */
  readonly root: string;
}

const STEPS = { features: 'features', matches: 'matches', sparse: 'cameras', dense: 'mesh', mesh: 'mesh' } as const;
/** Folder of dropped photographs, in that of Scrim. */
const STAGED = 'photographs';

/** @param sources Absolute path of the folder with Scrim's sources and `node_modules`. */
export function createPhotographImports(files: FileLayer, tools: ToolJobs, sources: string): PhotographImports {
  return {
    look: async ({ colmap }, typed) => {
      const folder = await realFolder(typed);
      const has = await hasCameras(folder).catch((error: unknown) => {
        throw asRefusal(error, folder);
      });
      const photographs = await countPhotographs(folder);
      if (has) return { photographs, hasCameras: true, colmap: null, diagnostic: null };
      try {
        const path = await findTypedTool(COLMAP, colmap);
        const { version } = await openColmap(path, null, new AbortController().signal);
        return { photographs, hasCameras: false, colmap: `${version} (${path})`, diagnostic: null };
      } catch (error) {
        if (!(error instanceof HostError)) throw error;
        return { photographs, hasCameras: false, colmap: null, diagnostic: error.diagnostic };
      }
    },
    survey: async (typed) => {
      const folder = await realFolder(typed);
      try {
        return await surveyPhotographs(folder, await hasOwnCameras(folder));
      } catch (error) {
        throw asRefusal(error, folder);
      }
    },
    run: (projectId, client, job) => {
      const task = async (interrupted: AbortSignal, onLine: (line: string) => void) => {
        try {
          const folder = await realFolder(job.folder);
          const found = (await hasOwnCameras(folder)) ? null : await findCameras(folder, job, interrupted, onLine);
          return await pack(folder, found, job, files, sources, interrupted);
        } catch (error) {
          interrupted.throwIfAborted();
          throw asRefusal(error, job.folder);
        }
      };
      return tools.run(projectId, client, { onLines: job.onLines, canceled: CANCELED, task });
    },
    stage: async (root, { folder, path, bytes, first }) => {
      const place = `${SCRIM_FOLDER}/${STAGED}`;
      const target = await resolveInside(root, `${place}/${folder}/${path}`);
      try {
        await ensureScrimFolder(root, files);
        if (first) await rm(await resolveInside(root, place), { recursive: true, force: true });
        await files.makeFolder(dirname(target));
        await files.writeNew(target, bytes);
      } catch (error) {
        throw errorCode(error) === undefined ? error : writeRefusal(error, target);
      }
      return join(root, place, folder);
    },
  };
}

/** Whether a folder has cameras that Scrim did not make. */
async function hasOwnCameras(folder: string): Promise<boolean> {
  return (await hasCameras(folder)) && !(await isReconstructed(folder));
}

/** The error as one of the host. */
function asRefusal(error: unknown, folder: string): unknown {
  if (error instanceof CaptureError) return refusal('SCR069', `${folder} cannot be imported: ${error.message}.`);
  return errorCode(error) === undefined ? error : writeRefusal(error, folder);
}

const CANCELED: HostOutput<'photographs.import'> = {
  path: null,
  photographs: 0,
  found: 0,
  isRough: false,
  isScaleGuessed: false,
  start: null,
  diagnostics: [],
};

async function findCameras(
  folder: string,
  { colmap, oneCamera, onProgress }: PhotographJob,
  interrupted: AbortSignal,
  onLine: (line: string) => void,
): Promise<Reconstruction> {
  return reconstruct({
    folder,
    colmap: await findTypedTool(COLMAP, colmap),
    oneCamera,
    dense: null,
    say: (text, step) => onProgress({ step: STEPS[step], text }),
    onLine,
    interrupted,
  });
}

async function pack(
  asked: string,
  made: Reconstruction | null,
  { root, name, maxSidePx, up, metersPerUnit: given, depth, onProgress }: PhotographJob,
  files: FileLayer,
  sources: string,
  interrupted: AbortSignal,
): Promise<HostOutput<'photographs.import'>> {
  const folder = made?.isDense ? join(asked, 'dense/0') : asked;
  // COLMAP does not know how large a place is: a guess that is near enough to be seen, until “True size”.
  const guessed = made === null ? 1 : guessedUnit((await readCameras(folder)).views);
  const unitFrom = given === null ? made && ('guess' as const) : ('given' as const);
  const packed = await packCapture({
    folder,
    root,
    sources,
    name,
    files,
    say: (text) => onProgress({ step: 'pack', text }),
    interrupted,
    maxSidePx,
    up,
    metersPerUnit: given ?? guessed,
    ...(unitFrom && { unitFrom }),
    known: UNKNOWN_SIZE,
    depth,
    ...(made && { searched: made.names, warnings: made.diagnostics }),
  });
  const { views } = await readCaptureDocument(dirname(await resolveInside(root, packed.path)));
  // Photographs that were dropped are not kept twice.
  const staged = join(root, SCRIM_FOLDER, STAGED);
  if (asked.startsWith(staged)) await rm(staged, { recursive: true, force: true });
  return {
    path: packed.path,
    photographs: made?.photographs ?? packed.views.length,
    found: packed.views.length,
    isRough: made !== null && !made.isDense && made.mesh !== null,
    isScaleGuessed: packed.scale.from === 'guessed',
    start: firstEye(views),
    diagnostics: [...packed.diagnostics],
  };
}
