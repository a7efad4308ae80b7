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

const PAGE_ENTRY = 'app/cli/render/render.page.ts';

/**
 * Plays frames in a headless browser and passes on their images in order. Time, date and random seed are fixed, so that the same
 * project renders the same pixels. Returns the diagnostics; after an error, images are missing.
 */
export async function renderFrames(options: RenderOptions): Promise<readonly Diagnostic[]> {
  const found = await findChromium();
  if (found === null) return [NO_BROWSER];
  const { root, projectRoot, sessionFolders } = options;
  const folders = { project: projectRoot, decoders: join(root, DECODER_FILES_FOLDER), ...sessionFolders };
  return withPage<PageApi, readonly Diagnostic[]>(found, { root, entry: PAGE_ENTRY, folders }, (call, server) =>
    play(call, server, options),
  );
}

async function play(call: CallPage<PageApi>, server: RenderServer, options: RenderOptions): Promise<readonly Diagnostic[]> {
  const opened = await call('open', { ...options.job, assetBaseUrl: 'project/', decodersBaseUrl: 'decoders/' });
  const early = [...opened.diagnostics, ...shaderDiagnostics(options, opened.shaderErrors), ...(await call('diagnostics'))];
  if (hasErrors(early)) return early;
  if (opened.frameCount !== null && options.last >= opened.frameCount) return [...early, noSuchFrame(options.last, opened.frameCount)];
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
function firstPlayed({ first, job: { program, session } }: RenderOptions): number {
  return session.kind === 'room' || isHistoryDependent(program) ? 0 : Math.max(0, first - 1);
}

function shaderDiagnostics(
  { job, sourceOf }: RenderOptions,
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
