import { createHash } from 'node:crypto';
import { lstat, mkdir, readdir, rename, rm, stat, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pointsAsPly, surfacePoints } from '../../../export/captures/points/surface-points.ts';
import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { HostError } from '../../contract/host-error.ts';
import { errorCode, refusal, writeRefusal } from '../file-errors.ts';
import { NODE_FILES } from '../file-layer.ts';
import { hasSurface, readCameras, SPARSE_MESH } from '../read-capture-folder.ts';
import { readBytes, readText } from '../read-file.ts';
import { withWorkLock } from '../work-lock.ts';
import { type Colmap, openColmap } from './colmap.ts';

/** What is done one after the other. */
export type ReconstructionStep = 'features' | 'matches' | 'sparse' | 'dense' | 'mesh';

export interface ReconstructionJob {
  /** Real path of the folder with the photographs, or with `images/`. */
  readonly folder: string;
  /** Absolute path of COLMAP. */
  readonly colmap: string;
  /** Whether one camera with one lens took all photographs. */
  readonly oneCamera: boolean;
  /** Whether to compute depth; null: where COLMAP can. */
  readonly dense: boolean | null;
  /** Receives what is being done, for people. */
  readonly say: (text: string, step: ReconstructionStep) => void;
  /** Receives what COLMAP prints. */
  readonly onLine?: (line: string) => void;
  readonly interrupted: AbortSignal;
}

export interface Reconstruction {
  readonly photographs: number;
  /** Their names, as COLMAP has them. */
  readonly names: readonly string[];
  /** The photographs whose cameras were found. */
  readonly found: number;
  /** Mesh relative to the folder; null: the folder had depth or a mesh already. */
  readonly mesh: string | null;
  /** Whether the mesh is that of depth, not of the points alone. */
  readonly isDense: boolean;
  /** Steps that an earlier call had finished. */
  readonly kept: readonly string[];
  readonly log: string;
  /** Warnings. */
  readonly diagnostics: readonly Diagnostic[];
}

const WORK_FOLDER = '.scrim-reconstruction';
/** Beside the hidden folder, which is removed when other photographs begin anew. */
const LOCK_FILE = `${WORK_FOLDER}.lock`;
const STATE_FILE = 'steps.json';
const PHOTO_ENDING = /\.(jpe?g|png)$/i;
/** Up to here, each photograph is compared with each other one; beyond, with its successors in the order of names. */
const MOST_EXHAUSTIVE = 200;
const LEAST_PHOTOS = 3;
const MAX_FILE_BYTES = 2 ** 30;
const MAX_STATE_BYTES = 2 ** 16;

/** What finished steps were made from. */
interface State {
  readonly key: string;
  readonly done: readonly string[];
}

/** Folder of the cameras, in the folder of the photographs. */
const SPARSE = 'sparse/0';
const DENSE_MESH = 'dense/0/meshed-poisson.ply';

/**
 * Finds the cameras of photographs with COLMAP, and a mesh: of depth where COLMAP can compute it, else of the points that the photographs
 * share. Writes `sparse/0/` and `dense/0/` into the folder, each whole or not at all, as `importCapture` reads them. Steps are kept in a hidden
 * folder: after an interrupt, the same call continues with the step that was interrupted.
 *
 * @throws SCR004, SCR060, SCR061, SCR062, SCR066 if it is done already, SCR069, SCR078
 */
export async function reconstruct(job: ReconstructionJob): Promise<Reconstruction> {
  const doing = `is finding the cameras of ${job.folder}`;
  try {
    return await withWorkLock({ lock: join(job.folder, LOCK_FILE), files: NODE_FILES, doing }, () => run(job));
  } catch (error) {
    if (error instanceof CaptureError) throw refusal('SCR069', `${job.folder}: ${error.message}.`);
    if (errorCode(error) === undefined) throw error;
    // Whatever failed, a folder that is gone is the reason.
    if (!(await isFolder(job.folder)))
      throw refusal('SCR004', `${job.folder} is gone: it was moved or deleted, or its drive is not connected.`);
    throw writeRefusal(error, job.folder);
  }
}

async function run(job: ReconstructionJob): Promise<Reconstruction> {
  const { folder, say, interrupted } = job;
  const images = await folderOfImages(folder);
  const names = await photographsIn(images);
  if (names.length < LEAST_PHOTOS) {
    throw refusal(
      'SCR069',
      `${images} has ${names.length} photographs; cameras are found from ${LEAST_PHOTOS} on.`,
      'Take more photographs.',
    );
  }
  const work = join(folder, WORK_FOLDER);
  const file = (name: string) => join(work, name);
  const log = file('colmap.log');
  const colmap = await openColmap(job.colmap, log, interrupted, job.onLine);
  const key = await keyOf(images, names, job.oneCamera);
  const before = await readState(work);
  const done = before?.key === key ? [...before.done] : [];
  // What somebody removed is made again, with what was made from it.
  if (done.includes('sparse') && !(await exists(join(folder, SPARSE, 'images.bin')))) done.splice(done.indexOf('sparse'));
  if (done.includes('mesh') && !(await exists(join(folder, SPARSE, SPARSE_MESH)))) done.splice(done.indexOf('mesh'));
  if (done.length === 0) {
    for (const name of ['sparse', 'dense']) {
      // What an earlier call of other photographs wrote is replaced; what somebody else did is not.
      if ((await exists(join(folder, name))) && !before?.done.includes(name)) {
        throw refusal('SCR061', `${join(folder, name)} exists already.`, 'Import it with scrim import capture, or move it away.');
      }
    }
    await rm(work, { recursive: true, force: true });
  }
  await mkdir(work, { recursive: true });
  await writeFile(file('photographs.txt'), `${names.join('\n')}\n`);
  const kept = [...done];
  /** Does a step unless it is done. Its result appears in one step. */
  const step = async (name: ReconstructionStep, doIt: (say: (text: string) => void) => Promise<void>): Promise<void> => {
    interrupted.throwIfAborted();
    if (done.includes(name)) return;
    await doIt((text) => say(text, name));
    done.push(name);
    await writeState(work, { key, done });
  };
  // COLMAP leaves out what its database has, and writes it by transactions: a step that was interrupted continues.
  const database = file('database.db');

  await step('features', async (report) => {
    report('Finding features…');
    await colmap.runOnGpu(
      [
        ...['feature_extractor', '--database_path', database, '--image_path', images, '--image_list_path', file('photographs.txt')],
        ...['--ImageReader.single_camera', job.oneCamera ? '1' : '0', '--ImageReader.camera_model', 'SIMPLE_RADIAL'],
      ],
      ['SiftExtraction', 'FeatureExtraction'],
      (line) => progress(report, line, /Processed file \[(\d+)\/(\d+)\]/, 'Finding features'),
    );
  });
  await step('matches', async (report) => {
    report('Matching photographs…');
    const matcher = names.length > MOST_EXHAUSTIVE ? 'sequential_matcher' : 'exhaustive_matcher';
    await colmap.runOnGpu([matcher, '--database_path', database], ['SiftMatching', 'FeatureMatching'], (line) =>
      progress(report, line, /Matching (?:block|image) \[(\d+)\/(\d+)/, 'Matching photographs'),
    );
  });
  await step('sparse', async (report) => {
    report('Finding cameras…');
    const part = file('sparse');
    await rm(part, { recursive: true, force: true });
    await mkdir(part);
    await colmap.run(['mapper', '--database_path', database, '--image_path', images, '--output_path', part], (line) => {
      const [, count] = /Registering image #\d+ \((?:\w+=)?(\d+)/.exec(line) ?? [];
      if (count !== undefined) report(`Finding cameras (${count} of ${names.length})…`);
    });
    const model = await largestModel(part);
    if (model === null) throw noCameras();
    await replace(model, join(folder, 'sparse'), '0');
  });
  const found = await registered(join(folder, SPARSE));
  if (job.dense === true && !colmap.hasCuda) {
    throw refusal(
      'SCR078',
      `${job.colmap} was built without CUDA, which depth needs.`,
      'Leave out --dense, or install COLMAP with CUDA on a computer with an NVIDIA graphics card.',
    );
  }
  const diagnostics: Diagnostic[] = [];
  if (job.dense === true || (job.dense === null && colmap.usesGpu)) {
    try {
      await step('dense', (report) => densify(folder, images, file('dense'), colmap, report));
    } catch (error) {
      interrupted.throwIfAborted();
      if (job.dense === true || !(error instanceof HostError) || error.diagnostic.code !== 'SCR078') throw error;
      // As on a computer without a graphics card.
      diagnostics.push({ ...(error.diagnostic as Diagnostic), severity: 'warning' });
    }
  }
  const isDense = done.includes('dense');
  if (!isDense && (done.includes('mesh') || !(await hasSurface(folder)))) {
    await step('mesh', async (report) => {
      report('Making a mesh…');
      await meshPoints(folder, work, colmap);
    });
  }
  const mesh = isDense ? DENSE_MESH : done.includes('mesh') ? `${SPARSE}/${SPARSE_MESH}` : null;
  return { photographs: names.length, names, found, mesh, isDense, kept, log, diagnostics };
}

/** Number of the photographs that `reconstruct` would use. */
export async function countPhotographs(folder: string): Promise<number> {
  return (await photographsIn(await folderOfImages(folder))).length;
}

/** The names of the photographs in a folder, and where they are. */
export async function photographsOf(folder: string): Promise<{ readonly place: string; readonly names: readonly string[] }> {
  const place = await folderOfImages(folder);
  return { place, names: await photographsIn(place) };
}

async function folderOfImages(folder: string): Promise<string> {
  return (await isFolder(join(folder, 'images'))) ? join(folder, 'images') : folder;
}

/** Names of the photographs in a folder: files only, because COLMAP would wait for a pipe forever. */
async function photographsIn(folder: string): Promise<readonly string[]> {
  const entries = await readdir(folder, { withFileTypes: true });
  return entries.flatMap((entry) => (PHOTO_ENDING.test(entry.name) && entry.isFile() ? [entry.name] : [])).sort();
}

function noCameras() {
  return refusal('SCR069', 'COLMAP found no cameras.', 'Take photographs that share two thirds of what they show, from different places.');
}

/** Makes the mesh of the points that the photographs share, beside the cameras. */
async function meshPoints(folder: string, work: string, colmap: Colmap): Promise<void> {
  const { views } = await readCameras(folder);
  const points = join(work, 'points.ply');
  const made = join(work, SPARSE_MESH);
  await writeFile(points, pointsAsPly(surfacePoints(views)));
  const options = Object.entries(MESHING).flatMap(([name, value]) => [`--PoissonMeshing.${name}`, String(value)]);
  await colmap.run(['poisson_mesher', '--input_path', points, '--output_path', made, ...options]);
  await rename(made, join(folder, SPARSE, SPARSE_MESH));
}

/** Few points make a coarse mesh. It is closed where there are none, so that photographs are shown there, too. */
const MESHING = { depth: 8, trim: 0, point_weight: 8 };

async function densify(folder: string, images: string, part: string, colmap: Colmap, say: (text: string) => void): Promise<void> {
  await rm(part, { recursive: true, force: true });
  say('Straightening photographs…');
  await colmap.run(['image_undistorter', '--image_path', images, '--input_path', join(folder, 'sparse/0'), '--output_path', part]);
  say('Computing depth…');
  await colmap.run(['patch_match_stereo', '--workspace_path', part], (line) =>
    progress(say, line, /Processing view (\d+) \/ (\d+)/, 'Computing depth'),
  );
  say('Joining depth…');
  const points = join(part, 'fused.ply');
  await colmap.run(['stereo_fusion', '--workspace_path', part, '--output_path', points]);
  say('Making a mesh…');
  await colmap.run(['poisson_mesher', '--input_path', points, '--output_path', join(part, 'meshed-poisson.ply')]);
  await replace(part, join(folder, 'dense'), '0');
}

function progress(say: (text: string) => void, line: string, pattern: RegExp, words: string): void {
  const [, at, of] = pattern.exec(line) ?? [];
  if (at !== undefined && of !== undefined) say(`${words} (${at} of ${of})…`);
}

/** Moves a finished folder to `target/NAME`, in the place of an earlier one. */
async function replace(from: string, target: string, name: string): Promise<void> {
  await rm(target, { recursive: true, force: true });
  await mkdir(target);
  await rename(from, join(target, name));
}

/** COLMAP writes a model for each group of photographs that it cannot connect with the others. */
async function largestModel(folder: string): Promise<string | null> {
  let [largest, most] = [null as string | null, 0];
  for (const name of await readdir(folder)) {
    const count = await registered(join(folder, name));
    if (count > most) [largest, most] = [join(folder, name), count];
  }
  return largest;
}

/** Number of the photographs in a model: the first 64 bits of `images.bin`. */
async function registered(model: string): Promise<number> {
  const bytes = await readBytes(join(model, 'images.bin'), MAX_FILE_BYTES);
  return Number(new DataView(bytes.buffer).getBigUint64(0, true));
}

/** Other photographs or options give another key. */
async function keyOf(images: string, names: readonly string[], oneCamera: boolean): Promise<string> {
  const hash = createHash('sha256').update(JSON.stringify({ images, oneCamera }));
  for (const name of names) {
    if (/[\r\n]/.test(name)) throw refusal('SCR069', `The photograph ${JSON.stringify(name)} has a line break in its name.`, 'Rename it.');
    const { size, mtimeMs } = await stat(join(images, name));
    hash.update(JSON.stringify([name, size, mtimeMs]));
  }
  return hash.digest('hex');
}

async function readState(work: string): Promise<State | null> {
  try {
    const state = JSON.parse(await readText(join(work, STATE_FILE), MAX_STATE_BYTES)) as Partial<State>;
    return typeof state.key === 'string' && Array.isArray(state.done) ? { key: state.key, done: state.done } : null;
  } catch {
    return null;
  }
}

async function writeState(work: string, state: State): Promise<void> {
  const part = join(work, `${STATE_FILE}.part`);
  await writeFile(part, `${JSON.stringify(state)}\n`);
  await rename(part, join(work, STATE_FILE));
}

/** Whether the cameras in a folder of photographs are those that `reconstruct` found, or began to find. */
export function isReconstructed(folder: string): Promise<boolean> {
  return isFolder(join(folder, WORK_FOLDER));
}

async function isFolder(path: string): Promise<boolean> {
  return (await lstat(path).catch(() => null))?.isDirectory() === true;
}

async function exists(path: string): Promise<boolean> {
  return (await lstat(path).catch(() => null)) !== null;
}
