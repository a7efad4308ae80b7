import { join } from 'node:path';
import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { DECODER_FILES_FOLDER } from '../../../export/gltf/decoders.ts';
import { isHistoryDependent } from '../../../export/program/history-dependence.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { findChromium } from '../../services/chromium.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import type * as RenderPage from './render.page.ts';
import type { RenderServer } from './render-server.ts';
import { type CallPage, withPage } from './with-page.ts';

export interface RenderOptions {
  /** Folder with the sources of Scrim. */
  readonly root: string;
  /** Real path of the project folder. */
  readonly projectRoot: string;
  readonly job: Omit<RenderPage.RenderJob, 'assetBaseUrl' | 'decodersBaseUrl'>;
  /** Real paths of the session’s folders, by the first part of its URL. */
  readonly sessionFolders: Readonly<Record<string, string>>;
  readonly first: number;
  /** Number of the last frame, included. */
  readonly last: number;
  /** Text of a shader by its file name, to find the column that a driver message quotes. */
  readonly sourceOf: (file: string) => string | undefined;
  readonly onImage: (index: number, head: RenderPage.ImageHead, bytes: Uint8Array) => Promise<void>;
  readonly say: (text: string) => void;
}

type PageApi = Pick<typeof RenderPage, 'open' | 'play' | 'diagnostics'>;

/** URLs of the folders that the page reads. */
export const PAGE_FOLDERS = { assetBaseUrl: 'project/', decodersBaseUrl: 'decoders/' } as const;

const PAGE_ENTRY = 'app/cli/render/render.page.ts';

/**
 * Plays frames in a headless browser and passes on their images in order. Time, date and random seed are fixed, so that the same
 * project renders the same pixels. Returns the diagnostics; after an error, images are missing.
 */
export async function renderFrames(options: RenderOptions): Promise<readonly Diagnostic[]> {
  const found = await findChromium();
  if (found === null) return [NO_BROWSER];
  const page = { root: options.root, entry: PAGE_ENTRY, folders: foldersOf(options) };
  return withPage<PageApi, readonly Diagnostic[]>(found, page, (call, server) => play(call, server, options));
}

/** Real paths of the folders that a render reads, by the first part of their URL. */
export function foldersOf({ root, projectRoot, sessionFolders }: Pick<RenderOptions, 'root' | 'projectRoot' | 'sessionFolders'>) {
  return { project: projectRoot, decoders: join(root, DECODER_FILES_FOLDER), ...sessionFolders };
}

async function play(call: CallPage<PageApi>, server: RenderServer, options: RenderOptions): Promise<readonly Diagnostic[]> {
  const opened = await call('open', { ...options.job, ...PAGE_FOLDERS });
  const early = [...openingDiagnostics(options, opened), ...(await call('diagnostics'))];
  if (hasErrors(early)) return early;
  for (let index = firstPlayed(options); index <= options.last; index++) {
    const keep = index >= options.first;
    const head = await call('play', index, keep);
    const now = await call('diagnostics');
    if (hasErrors(now)) return [...early, ...now];
    if (!keep) continue;
    if (head === null) throw new Error(`Frame ${index} has no picture, and nothing says why.`);
    await options.onImage(index, head, server.takeImage());
    if (options.last > options.first) options.say(`Frame ${index} of ${options.first}..${options.last}`);
  }
  return [...early, ...(await call('diagnostics'))];
}

/**
 * The first frame to play. History-dependent programs need all frames; others only the previous one, which determines the time step.
 */
export function firstPlayed({ first, job: { program, session } }: Pick<RenderOptions, 'first' | 'job'>): number {
  return session.kind === 'room' || isHistoryDependent(program) ? 0 : Math.max(0, first - 1);
}

/** What was wrong when the page opened the render: with the session, with shaders, and with the range of frames. */
export function openingDiagnostics(
  options: Pick<RenderOptions, 'job' | 'sourceOf' | 'last'>,
  { diagnostics, shaderErrors, frameCount }: RenderPage.OpenedJob,
): readonly Diagnostic[] {
  const early = [...diagnostics, ...shaderDiagnostics(options, shaderErrors)];
  return frameCount === null || options.last < frameCount || hasErrors(early) ? early : [...early, noSuchFrame(options.last, frameCount)];
}

function shaderDiagnostics(
  { job, sourceOf }: Pick<RenderOptions, 'job' | 'sourceOf'>,
  errors: Awaited<ReturnType<PageApi['open']>>['shaderErrors'],
): readonly Diagnostic[] {
  return errors.flatMap(({ shaderId, stage, log }) => {
    const shader = job.program.shaders.find(({ id }) => id === shaderId);
    return shader ? driverDiagnostics(shader, log, sourceOf, stage) : [];
  });
}

function noSuchFrame(index: number, count: number): Diagnostic {
  return { code: 'SCR070', severity: 'error', message: `The session has no frame ${index}: its frames are 0 to ${count - 1}.` };
}
