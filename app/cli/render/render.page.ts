import type { ShaderError } from '../../../export/runtime/gl/program-cache.ts';
import type { Player } from '../../../export/runtime/player.ts';
import { readColor, readDepth, readScreen } from '../../../export/runtime/readback.ts';
import { createPosterCamera, type PosterCamera, type PosterSize } from '../../../export/runtime/scenes/poster-camera.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { PosterFraming, ViewCrop } from '../../../nodes/kit/poster-framing.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import { type FrameSource, openFrameSource, type RenderSession } from './frame-source.page.ts';
import { createRenderPlayer, type PlayedProgram } from './render-player.page.ts';

/** A render, as Node passes it to the page. URLs are relative to the page. */
export interface RenderJob extends PlayedProgram {
  readonly session: RenderSession;
  readonly subject: Subject;
  /** Keeps of each image what a poster shows; absent: all. `framing`: null frames the objects. */
  readonly poster?: { readonly framing: PosterFraming | null; readonly size: PosterSize };
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

/** An open render, for what reads the images of a frame. */
export interface OpenRender {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly source: FrameSource;
  readonly subject: Subject;
  readonly camera: PosterCamera | null;
}

interface Picture extends ImageHead {
  readonly bytes: Uint8Array<ArrayBuffer>;
}

let opened: OpenRender | null = null;
/** Reads the current frame once it is drawn. */
let whenDrawn: (render: OpenRender) => void = () => {};
/** Resolves when the current frame is completely drawn. */
let drawing: Promise<void> = Promise.resolve();
let problems: readonly Diagnostic[] = [];
const events: Diagnostic[] = [];

/** Opens a render. Resolves when the assets have loaded or failed. */
export async function open(job: RenderJob): Promise<OpenedJob> {
  const { gl, player } = createRenderPlayer(job, (diagnostics) => {
    problems = diagnostics;
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
    const { setHead } = output;
    const camera = job.poster && createPosterCamera({ inspect: () => player.inspect(null), setHead, nodes: [], ...job.poster });
    opened = { gl, player, source: output, subject: job.subject, camera: camera ?? null };
  }
  return { frameCount: output?.frameCount ?? null, shaderErrors, diagnostics };
}

/** Plays one frame. With `keep`, sends its image. Returns null if there is none to send. */
export async function play(index: number, keep: boolean): Promise<ImageHead | null> {
  let taken: Picture | null = null;
  const camera = keep ? opened?.camera : null;
  if (camera && opened?.source.setHead) {
    // The objects are where they are drawn only after a frame.
    await playAndRead(index, () => {});
    camera.aim();
  }
  const read = (render: OpenRender) => {
    taken = readSubject(render);
  };
  const stepped = await playAndRead(index, keep ? read : () => {});
  if (!keep || !stepped || !opened) return null;
  const seen = opened.subject.kind === 'screen' ? opened.source.seen?.() : undefined;
  const whole: Picture | null = seen ? { widthPx: seen.widthPx, heightPx: seen.heightPx, bytes: Uint8Array.from(seen.rgba) } : taken;
  if (!whole) return null;
  const picture = camera ? cropped(whole, camera.crop()) : whole;
  await fetch('picture', { method: 'POST', body: picture.bytes });
  return { widthPx: picture.widthPx, heightPx: picture.heightPx };
}

/** Plays one frame and calls `read` while its images can be read. Returns whether the session has the frame. */
export async function playAndRead(index: number, read: (render: OpenRender) => void): Promise<boolean> {
  if (!opened) throw new Error('Nothing is open.');
  whenDrawn = read;
  const stepped = await opened.source.step(index);
  await drawing;
  return stepped;
}

/** Draws a frame of a recording when all of its assets have loaded. A recorded frame stays valid until then. */
async function drawRecorded(player: Player, frame: SessionFrame): Promise<void> {
  await player.drawSettled(frame);
  if (opened) whenDrawn(opened);
}

/**
 * Draws a frame of a room at once, because WebXR textures are valid only during their frame. Videos in it therefore show the frame that was
 * requested one frame earlier.
 */
function drawRoom(player: Player, frame: SessionFrame): Promise<void> {
  player.draw(frame);
  if (opened) whenDrawn(opened);
  return player.settle();
}

/** All diagnostics of the render so far. */
export function diagnostics(): readonly Diagnostic[] {
  return [...problems, ...events];
}

function cropped({ widthPx, heightPx, bytes }: Picture, { x, y, width, height }: ViewCrop): Picture {
  const [fromX, fromY] = [Math.round(x * widthPx), Math.round(y * heightPx)];
  const [keptX, keptY] = [Math.round(width * widthPx), Math.round(height * heightPx)];
  const kept = new Uint8Array(keptX * keptY * 4);
  for (let row = 0; row < keptY; row++) {
    const start = ((fromY + row) * widthPx + fromX) * 4;
    kept.set(bytes.subarray(start, start + keptX * 4), row * keptX * 4);
  }
  return { widthPx: keptX, heightPx: keptY, bytes: kept };
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
