import { createHash } from 'node:crypto';
import { lstat, mkdir, readdir, rename, rm, stat, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { errorCode, refusal, writeRefusal } from '../file-errors.ts';
import { readBytes, readText } from '../read-file.ts';
import { runTool } from './run-tool.ts';

export interface ReconstructionJob {
  /** Real path of the folder with the photographs, or with `images/`. */
  readonly folder: string;
  /** Absolute path of COLMAP. */
  readonly colmap: string;
  /** Whether one camera with one lens took all photographs. */
  readonly oneCamera: boolean;
  /** Whether to compute depth and a mesh; null: where COLMAP can. */
  readonly dense: boolean | null;
  readonly say: (text: string) => void;
  readonly interrupted: AbortSignal;
}

export interface Reconstruction {
  readonly photographs: number;
  /** The photographs whose cameras were found. */
  readonly found: number;
  /** Mesh relative to the folder; null if none was made. */
  readonly mesh: string | null;
  /** Steps that an earlier call had finished. */
  readonly kept: readonly string[];
  readonly log: string;
}

const WORK_FOLDER = '.scrim-reconstruction';
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

/**
 * Finds the cameras of photographs with COLMAP, and a mesh where COLMAP can compute depth. Writes `sparse/0/` and `dense/0/` into the folder,
 * each whole or not at all, as `importCapture` reads them. Steps are kept in a hidden folder: after an interrupt, the same call continues
 * with the step that was interrupted.
 *
 * @throws SCR004, SCR060, SCR061, SCR069, SCR078
 */
export async function reconstruct(job: ReconstructionJob): Promise<Reconstruction> {
  try {
    return await run(job);
  } catch (error) {
    throw errorCode(error) === undefined ? error : writeRefusal(error, job.folder);
  }
}

async function run(job: ReconstructionJob): Promise<Reconstruction> {
  const { folder, colmap, say, interrupted } = job;
  const images = (await isFolder(join(folder, 'images'))) ? join(folder, 'images') : folder;
  const names = (await readdir(images)).filter((name) => PHOTO_ENDING.test(name)).sort();
  if (names.length < LEAST_PHOTOS) {
    throw refusal(
      'SCR069',
      `${images} has ${names.length} photographs; cameras are found from ${LEAST_PHOTOS} on.`,
      'Take more photographs.',
    );
  }
  const work = join(folder, WORK_FOLDER);
  const log = join(work, 'colmap.log');
  const key = await keyOf(images, names, job.oneCamera);
  const before = await readState(work);
  const done = before?.key === key ? [...before.done] : [];
  // What somebody removed is made again, with what was made from it.
  if (done.includes('sparse') && !(await exists(join(folder, 'sparse/0/images.bin')))) done.splice(done.indexOf('sparse'));
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
  await writeFile(join(work, 'photographs.txt'), `${names.join('\n')}\n`);
  const kept = [...done];
  const runColmap = (args: readonly string[], onLine: (line: string) => void = () => {}) =>
    runTool({ tool: colmap, args, log, onLine, interrupted });
  /** Does a step unless it is done. Its result appears in one step. */
  const step = async (name: string, doIt: () => Promise<void>): Promise<void> => {
    interrupted.throwIfAborted();
    if (done.includes(name)) return;
    await doIt();
    done.push(name);
    await writeState(work, { key, done });
  };
  const help = await runColmap(['help']);
  const hasCuda = help.some((line) => /with CUDA/i.test(line));
  const file = (name: string) => join(work, name);
  // COLMAP leaves out what its database has, and writes it by transactions: a step that was interrupted continues.
  const database = file('database.db');

  await step('features', async () => {
    say('Finding features…');
    await runColmap(
      [
        ...['feature_extractor', '--database_path', database, '--image_path', images, '--image_list_path', file('photographs.txt')],
        ...['--ImageReader.single_camera', job.oneCamera ? '1' : '0', '--ImageReader.camera_model', 'SIMPLE_RADIAL'],
        ...(await gpuOption(runColmap, 'feature_extractor', ['SiftExtraction', 'FeatureExtraction'], hasCuda)),
      ],
      (line) => progress(say, line, /Processed file \[(\d+)\/(\d+)\]/, 'Finding features'),
    );
  });
  await step('matches', async () => {
    say('Matching photographs…');
    const matcher = names.length > MOST_EXHAUSTIVE ? 'sequential_matcher' : 'exhaustive_matcher';
    await runColmap(
      [matcher, '--database_path', database, ...(await gpuOption(runColmap, matcher, ['SiftMatching', 'FeatureMatching'], hasCuda))],
      (line) => progress(say, line, /Matching (?:block|image) \[(\d+)\/(\d+)/, 'Matching photographs'),
    );
  });
  await step('sparse', async () => {
    say('Finding cameras…');
    const part = file('sparse');
    await rm(part, { recursive: true, force: true });
    await mkdir(part);
    await runColmap(['mapper', '--database_path', database, '--image_path', images, '--output_path', part], (line) => {
      const [, count] = /Registering image #\d+ \((?:\w+=)?(\d+)/.exec(line) ?? [];
      if (count !== undefined) say(`Finding cameras (${count} of ${names.length})…`);
    });
    const model = await largestModel(part);
    if (model === null) {
      throw refusal(
        'SCR069',
        'COLMAP found no cameras.',
        'Take photographs that share two thirds of what they show, from different places.',
      );
    }
    await replace(model, join(folder, 'sparse'), '0');
  });
  const found = await registered(join(folder, 'sparse/0'));
  if (job.dense === true && !hasCuda) {
    throw refusal(
      'SCR078',
      `${colmap} was built without CUDA, which depth needs.`,
      'Leave out --dense, or install COLMAP with CUDA on a computer with an NVIDIA graphics card.',
    );
  }
  if (job.dense !== false && hasCuda) await step('dense', () => densify(job, images, file('dense'), runColmap));
  return { photographs: names.length, found, mesh: done.includes('dense') ? 'dense/0/meshed-poisson.ply' : null, kept, log };
}

type RunColmap = (args: readonly string[], onLine?: (line: string) => void) => Promise<readonly string[]>;

async function densify({ folder, say }: ReconstructionJob, images: string, part: string, runColmap: RunColmap): Promise<void> {
  await rm(part, { recursive: true, force: true });
  say('Straightening photographs…');
  await runColmap(['image_undistorter', '--image_path', images, '--input_path', join(folder, 'sparse/0'), '--output_path', part]);
  say('Computing depth…');
  await runColmap(['patch_match_stereo', '--workspace_path', part], (line) =>
    progress(say, line, /Processing view (\d+) \/ (\d+)/, 'Computing depth'),
  );
  say('Joining depth…');
  const points = join(part, 'fused.ply');
  await runColmap(['stereo_fusion', '--workspace_path', part, '--output_path', points]);
  say('Making a mesh…');
  await runColmap(['poisson_mesher', '--input_path', points, '--output_path', join(part, 'meshed-poisson.ply')]);
  await replace(part, join(folder, 'dense'), '0');
}

function progress(say: (text: string) => void, line: string, pattern: RegExp, words: string): void {
  const [, at, of] = pattern.exec(line) ?? [];
  if (at !== undefined && of !== undefined) say(`${words} (${at} of ${of})…`);
}

/** The option that uses the graphics card; COLMAP 3.12 renamed it. */
async function gpuOption(runColmap: RunColmap, command: string, groups: readonly string[], hasCuda: boolean): Promise<readonly string[]> {
  const help = (await runColmap([command, '-h'])).join('\n');
  const group = groups.find((each) => help.includes(`--${each}.use_gpu`));
  return group === undefined ? [] : [`--${group}.use_gpu`, hasCuda ? '1' : '0'];
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

async function isFolder(path: string): Promise<boolean> {
  return (await lstat(path).catch(() => null))?.isDirectory() === true;
}

async function exists(path: string): Promise<boolean> {
  return (await lstat(path).catch(() => null)) !== null;
}
