import { join } from 'node:path';
import { type Photograph, pictureSize, type TakePicture, takePhotograph } from '../../../export/captures/acquire/take-photograph.ts';
import type { AcquiredCamera } from '../../../export/captures/acquire/write-transforms.ts';
import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { DECODER_FILES_FOLDER } from '../../../export/gltf/decoders.ts';
import type { Program } from '../../../export/program/program.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { findChromium } from '../../services/chromium.ts';
import { NO_BROWSER } from '../../services/start-browser.ts';
import type { RenderServer } from '../render/render-server.ts';
import { type CallPage, withPage } from '../render/with-page.ts';
import type * as AcquirePage from './acquire.page.ts';

export interface AcquisitionJob {
  /** Folder with the sources of Scrim. */
  readonly root: string;
  /** Real path of the project folder. */
  readonly projectRoot: string;
  readonly program: Program;
  /** The layer with depth that is photographed, as `node.port`. */
  readonly tap: string;
  readonly camera: AcquiredCamera;
  /** Column-major 4×4. */
  readonly poses: readonly (readonly number[])[];
  /** Text of a shader by its file name. */
  readonly sourceOf: (file: string) => string | undefined;
  readonly onPhotograph: (index: number, photograph: Photograph) => Promise<void>;
  readonly say: (text: string) => void;
  readonly interrupted: AbortSignal;
}

type PageApi = Pick<typeof AcquirePage, 'open' | 'photograph' | 'diagnostics'>;

const PAGE_ENTRY = 'app/cli/capture/acquire.page.ts';

/**
 * Photographs a scene in a headless browser, at time 0, and passes on color and depth in the order of the poses. Returns the diagnostics;
 * after an error, photographs are missing.
 */
export async function acquireViews(job: AcquisitionJob): Promise<readonly Diagnostic[]> {
  const found = await findChromium();
  if (found === null) return [NO_BROWSER];
  const { root, projectRoot } = job;
  const folders = { project: projectRoot, decoders: join(root, DECODER_FILES_FOLDER) };
  return withPage<PageApi, readonly Diagnostic[]>(found, { root, entry: PAGE_ENTRY, folders }, (call, server) =>
    acquire(call, server, job),
  );
}

async function acquire(call: CallPage<PageApi>, server: RenderServer, job: AcquisitionJob): Promise<readonly Diagnostic[]> {
  const { program, tap, camera, poses } = job;
  job.say('Loading the scene…');
  const [widthPx, heightPx] = pictureSize(camera);
  const opened = await call('open', { program, tap, widthPx, heightPx, assetBaseUrl: 'project/', decodersBaseUrl: 'decoders/' });
  const early = [...opened.diagnostics, ...opened.shaderErrors.flatMap((error) => shaderDiagnostics(job, error))];
  if (hasErrors(early)) return early;
  const take: TakePicture = async (worldFromCamera, tangents) => {
    job.interrupted.throwIfAborted();
    const head = await call('photograph', { worldFromCamera, tangents });
    return partsOf(head, server.takeImage());
  };
  for (const [index, pose] of poses.entries()) {
    job.say(`Taking photographs (${index + 1} of ${poses.length})…`);
    const photograph = await takePhotograph(camera, pose, take);
    const now = await call('diagnostics');
    if (hasErrors(now)) return now;
    await job.onPhotograph(index, photograph);
  }
  return [...early, ...(await call('diagnostics'))];
}

function partsOf({ color, depth }: AcquirePage.PhotographHead, bytes: Uint8Array): Photograph {
  const colorBytes = 4 * color[0] * color[1];
  return {
    color: { widthPx: color[0], heightPx: color[1], pixels: bytes.slice(0, colorBytes) },
    depth: { widthPx: depth[0], heightPx: depth[1], meters: new Float32Array(Uint8Array.from(bytes.subarray(colorBytes)).buffer) },
  };
}

function shaderDiagnostics(
  { program, sourceOf }: AcquisitionJob,
  { shaderId, stage, log }: AcquirePage.OpenedAcquisition['shaderErrors'][number],
): readonly Diagnostic[] {
  const shader = program.shaders.find(({ id }) => id === shaderId);
  return shader ? driverDiagnostics(shader, log, sourceOf, stage) : [];
}
