import { join } from 'node:path';
import { FACE_POSES, type Face, faceSidePx, faceTangent, panoramaFromFaces } from '../../../export/captures/acquire/cube-to-panorama.ts';
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

/** Rows from the top. A layer that is smaller than the view gives a smaller photograph. */
export interface Photograph {
  readonly color: { readonly widthPx: number; readonly heightPx: number; readonly pixels: Uint8Array };
  /** Along the axis of the camera, or distances in 360° photographs. */
  readonly depth: { readonly widthPx: number; readonly heightPx: number; readonly meters: Float32Array };
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
  const isAround = camera.projection === 'equirectangular';
  const sidePx = faceSidePx(camera.widthPx);
  const [widthPx, heightPx] = isAround ? [sidePx, sidePx] : [camera.widthPx, camera.heightPx];
  const opened = await call('open', { program, tap, widthPx, heightPx, assetBaseUrl: 'project/', decodersBaseUrl: 'decoders/' });
  const early = [...opened.diagnostics, ...opened.shaderErrors.flatMap((error) => shaderDiagnostics(job, error))];
  if (hasErrors(early)) return early;
  const take = async (worldFromCamera: readonly number[], tangents: readonly [number, number]): Promise<Photograph> => {
    job.interrupted.throwIfAborted();
    const head = await call('photograph', { worldFromCamera, tangents });
    return partsOf(head, server.takeImage());
  };
  for (const [index, pose] of poses.entries()) {
    job.say(`Taking photographs (${index + 1} of ${poses.length})…`);
    const photograph =
      camera.projection === 'equirectangular'
        ? await takeAround(take, pose, sidePx, camera.widthPx)
        : await take(pose, tangentsOf(camera.fovYRad, widthPx, heightPx));
    const now = await call('diagnostics');
    if (hasErrors(now)) return now;
    await job.onPhotograph(index, photograph);
  }
  return [...early, ...(await call('diagnostics'))];
}

function tangentsOf(fovYRad: number, widthPx: number, heightPx: number): readonly [number, number] {
  const y = Math.tan(fovYRad / 2);
  return [(y * widthPx) / heightPx, y];
}

async function takeAround(
  take: (worldFromCamera: readonly number[], tangents: readonly [number, number]) => Promise<Photograph>,
  pose: readonly number[],
  sidePx: number,
  widthPx: number,
): Promise<Photograph> {
  const tangent = faceTangent(sidePx);
  const faces: Face[] = [];
  for (const cameraFromFace of FACE_POSES) {
    const { color, depth } = await take(turned(pose, cameraFromFace), [tangent, tangent]);
    if (color.widthPx !== depth.widthPx) throw new Error('The color and the depth of a layer have different sizes.');
    faces.push({ ...color, meters: depth.meters });
  }
  const { pixels, meters, heightPx } = panoramaFromFaces(faces, widthPx);
  return { color: { widthPx, heightPx, pixels }, depth: { widthPx, heightPx, meters } };
}

/** The pose of a face: the rotations multiplied, the position kept. */
function turned(pose: readonly number[], cameraFromFace: readonly number[]): readonly number[] {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, Math.floor(i / 4)];
    if (column === 3) return pose[i] ?? 0;
    return [0, 1, 2].reduce((sum, k) => sum + (pose[4 * k + row] ?? 0) * (cameraFromFace[4 * column + k] ?? 0), 0);
  });
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
