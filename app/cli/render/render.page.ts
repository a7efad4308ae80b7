import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createRenderClock } from '../../../export/runtime/clock.ts';
import type { ShaderError } from '../../../export/runtime/gl/program-cache.ts';
import { createPlayer, type Player } from '../../../export/runtime/player.ts';
import { readColor, readDepth, readScreen } from '../../../export/runtime/readback.ts';
import { createScenesWith } from '../../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../../export/runtime/scenes/environments/read-radiance.ts';
import { createGlass } from '../../../export/runtime/scenes/glass/glass-scene.ts';
import { ALL_DECODERS } from '../../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../../nodes/generated/runtimes.gen.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import { type FrameSource, openFrameSource, type RenderSession } from './frame-source.page.ts';

/** A render, as Node passes it to the page. URLs are relative to the page. */
export interface RenderJob {
  readonly program: Program;
  readonly assetBaseUrl: string;
  readonly decodersBaseUrl: string;
  readonly session: RenderSession;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly subject: Subject;
}

/** What a render writes: the screen output, a layer, or the depth of a layer. `tap` is the layer as `node.port`. */
export type Subject =
  | { readonly kind: 'screen' }
  | { readonly kind: 'layer'; readonly tap: string }
  | { readonly kind: 'depth'; readonly tap: string };

export interface OpenedJob {
  /** Number of frames; null if the session has no end. */
  readonly frameCount: number | null;
  readonly shaderErrors: readonly ShaderError[];
  readonly diagnostics: readonly Diagnostic[];
}

/**
 * Description of an image: premultiplied RGBA bytes, or meters as 32-bit floats, rows from the top. The page sends the bytes to the
 * URL `picture`.
 */
export interface ImageHead {
  readonly widthPx: number;
  readonly heightPx: number;
}

const SEED = 1;

interface OpenRender {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly source: FrameSource;
  readonly subject: Subject;
}

interface Picture extends ImageHead {
  readonly bytes: Uint8Array<ArrayBuffer>;
}

let opened: OpenRender | null = null;
let taken: Picture | null = null;
let take = false;
/** Resolves when the current frame is completely drawn. */
let drawing: Promise<void> = Promise.resolve();
let problems: readonly Diagnostic[] = [];
const events: Diagnostic[] = [];

/** Opens a render. Resolves when the assets have loaded or failed. */
export async function open(job: RenderJob): Promise<OpenedJob> {
  const canvas = document.createElement('canvas');
  canvas.width = job.widthPx;
  canvas.height = job.heightPx;
  const { antialias } = job.program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const fetchFile = fetch.bind(globalThis);
  const decodersUrl = new URL(job.decodersBaseUrl, document.baseURI).href;
  const player = createPlayer({
    gl,
    canvas,
    program: job.program,
    modules: RUNTIMES,
    createSpatial,
    createScenes: createScenesWith({
      decoders: ALL_DECODERS,
      files: createFetchAssetSource(decodersUrl, fetchFile).load,
      readRadiance,
      findLamps: findLampsAtOnce,
      createGlass,
    }),
    assets: createFetchAssetSource(new URL(job.assetBaseUrl, document.baseURI).href, fetchFile),
    seed: SEED,
    clock: createRenderClock(),
    held: true,
    onDiagnostics: (diagnostics) => {
      problems = diagnostics;
    },
  });
  const { shaderErrors } = await player.ready;
  const { output, diagnostics } = await openFrameSource(job.session, gl, job.program, {
    onFrame: (frame) => {
      drawing = job.session.kind === 'recorded' ? drawRecorded(player, frame) : drawRoom(player, frame);
    },
    onEvent: (event) => {
      if (event.kind === 'problem') events.push({ code: 'SCR054', severity: 'error', message: event.message });
    },
  });
  if (output) {
    player.setSession(output.session);
    opened = { gl, player, source: output, subject: job.subject };
  }
  return { frameCount: output?.frameCount ?? null, shaderErrors, diagnostics };
}

/** Plays one frame. With `keep`, sends its image. Returns null if there is none to send. */
export async function play(index: number, keep: boolean): Promise<ImageHead | null> {
  if (!opened) throw new Error('Nothing is open.');
  take = keep;
  taken = null;
  const stepped = await opened.source.step(index);
  await drawing;
  if (!keep || !stepped) return null;
  const seen = opened.subject.kind === 'screen' ? opened.source.seen?.() : undefined;
  const picture: Picture | null = seen ? { widthPx: seen.widthPx, heightPx: seen.heightPx, bytes: Uint8Array.from(seen.rgba) } : taken;
  if (!picture) return null;
  await fetch('picture', { method: 'POST', body: picture.bytes });
  return { widthPx: picture.widthPx, heightPx: picture.heightPx };
}

/** Draws a frame of a recording when all of its assets have loaded. A recorded frame stays valid until then. */
async function drawRecorded(player: Player, frame: SessionFrame): Promise<void> {
  await player.drawSettled(frame);
  if (take && opened) taken = readSubject(opened);
}

/**
 * Draws a frame of a room at once, because WebXR textures are valid only during their frame. Videos in it therefore show the frame that was
 * requested one frame earlier.
 */
function drawRoom(player: Player, frame: SessionFrame): Promise<void> {
  player.draw(frame);
  if (take && opened) taken = readSubject(opened);
  return player.settle();
}

/** All diagnostics of the render so far. */
export function diagnostics(): readonly Diagnostic[] {
  return [...problems, ...events];
}

function readSubject({ gl, player, subject }: OpenRender): Picture | null {
  switch (subject.kind) {
    case 'screen':
      return screenOf(gl);
    case 'layer': {
      const layer = readColor(player.inspect(subject.tap), 0);
      return layer && { widthPx: layer.widthPx, heightPx: layer.heightPx, bytes: layer.pixels };
    }
    case 'depth': {
      const layer = readDepth(player.inspect(subject.tap), 0);
      return layer && { widthPx: layer.widthPx, heightPx: layer.heightPx, bytes: new Uint8Array(layer.meters.buffer) };
    }
  }
}

function screenOf(gl: WebGL2RenderingContext): Picture {
  const { widthPx, heightPx, pixels } = readScreen(gl);
  return { widthPx, heightPx, bytes: pixels };
}
