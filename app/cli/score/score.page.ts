import { readColor, readDepth, readScreen } from '../../../export/runtime/readback.ts';
import { flickerBetween, type Shot } from '../../../export/score/flicker.ts';
import type { Sum } from '../../../export/score/mean-of.ts';
import { countOcclusion, type OccludedLayer, type OcclusionCounts } from '../../../export/score/occlusion.ts';
import { contrastOf, type ImagePixels } from '../../../export/score/smooth.ts';
import { toneError } from '../../../export/score/tone.ts';
import { type Diagnostic, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import {
  type OpenedJob,
  type OpenRender,
  playAndRead,
  type RenderJob,
  diagnostics as renderDiagnostics,
  open as startRender,
} from '../render/render.page.ts';
import { openTrueDepth, type TrueDepth } from './true-depth.page.ts';

/** Taps of a layer with objects: before real surfaces hide it, and after. The two are equal if nothing hides it. */
export interface ScoredLayer {
  readonly whole: string;
  readonly shown: string;
}

export interface ScoreJob extends RenderJob {
  readonly layers: readonly ScoredLayer[];
  /** Tap of the layer without style; null if there is none. */
  readonly reference: string | null;
}

/** What is measured in a frame. Values that need the previous frame, or a layer that is missing, are null. */
export interface FrameScore {
  readonly index: number;
  /** For each layer of the job. */
  readonly occlusion: readonly (OcclusionCounts | null)[];
  readonly flicker: Sum | null;
  readonly referenceFlicker: Sum | null;
  /** In steps of 8 bits. */
  readonly contrast: number;
  readonly referenceContrast: number | null;
  readonly tone: Sum | null;
}

interface Seen {
  readonly image: ImagePixels;
  readonly reference: ImagePixels | null;
  readonly layers: readonly (OccludedLayer | null)[];
}

interface Opened {
  readonly job: ScoreJob;
  readonly depth: TrueDepth;
}

let opened: Opened | null = null;
/** Layers that cannot be compared with the output. */
let unlike: readonly Diagnostic[] = [];
let before: (Seen & { readonly room: Shot; readonly shot: Shot; readonly index: number }) | null = null;

export async function open(job: ScoreJob): Promise<OpenedJob> {
  const result = await startRender(job);
  if (result.frameCount === null || job.session.kind !== 'recorded') return result;
  opened = { job, depth: await openTrueDepth(job.session.url, job.widthPx, job.heightPx) };
  return result;
}

/** All diagnostics so far. */
export function diagnostics(): readonly Diagnostic[] {
  return [...renderDiagnostics(), ...unlike];
}

/** Plays a frame without measuring it. */
export async function skip(index: number): Promise<void> {
  await playAndRead(index, () => {});
}

/** Plays a frame and measures it. Null if the session has no such frame, or no depth for it, or after an error. */
export async function score(index: number): Promise<FrameScore | null> {
  if (!opened) throw new Error('Nothing is open.');
  const { job, depth } = opened;
  const frames: Seen[] = [];
  await playAndRead(index, (render) => {
    frames.push(see(render, job));
  });
  const [seen] = frames;
  // Files that cannot be used are among them.
  if (hasErrors(renderDiagnostics())) return null;
  const room = await depth.shot(index);
  if (!room || !seen) return null;
  unlike = otherSize(seen, job.reference);
  if (unlike.length > 0) return null;
  const shot = { ...room, depthM: nearest(room.depthM, seen.layers) };
  const last = before?.index === index - 1 ? before : null;
  before = { ...seen, room, shot, index };
  const { image, reference } = seen;
  const radiusPx = Math.max(2, Math.round(image.heightPx / 80));
  return {
    index,
    occlusion: seen.layers.map((layer) => layer && countOcclusion(layer, room.depthM)),
    flicker: last && flickerBetween(last.shot, last.image, shot, image),
    referenceFlicker: last?.reference && reference ? flickerBetween(last.room, last.reference, room, reference) : null,
    contrast: contrastOf(image, radiusPx),
    referenceContrast: reference && contrastOf(reference, radiusPx),
    tone: reference && toneError(image, reference, uncovered(seen), 2 * radiusPx),
  };
}

/** The mistake that the reference has another size than the output; empty if it has the same. */
function otherSize({ image, reference }: Seen, tap: string | null): Diagnostic[] {
  if (!reference || (reference.widthPx === image.widthPx && reference.heightPx === image.heightPx)) return [];
  const [its, that] = [reference, image].map(({ widthPx, heightPx }) => `${widthPx} × ${heightPx}`);
  const message = `The reference ${tap} has ${its} pixels, but the output has ${that}.`;
  return [{ code: 'SCR070', severity: 'error', message, fix: 'Name a layer that has the size of the output with --reference.' }];
}

function see({ gl, player }: OpenRender, { layers, reference }: ScoreJob): Seen {
  const colorOf = (tap: string): ImagePixels | null => readColor(player.inspect(tap), 0);
  // Reads of layers draw, so the screen is read first.
  const image = readScreen(gl);
  return {
    image,
    reference: reference === null ? null : colorOf(reference),
    layers: layers.map(({ whole, shown }) => {
      const [all, left, meters] = [colorOf(whole), colorOf(shown), readDepth(player.inspect(whole), 0)];
      const fits = [all, left, meters].every((one) => one?.widthPx === image.widthPx && one.heightPx === image.heightPx);
      return all && left && meters && fits ? { layerM: meters.meters, whole: all.pixels, shown: left.pixels } : null;
    }),
  };
}

/** The depth of what the image shows: of virtual objects where they are drawn, of the room elsewhere. */
function nearest(roomM: ArrayLike<number>, layers: Seen['layers']): Float32Array {
  const out = Float32Array.from(roomM);
  const virtual = new Uint8Array(out.length);
  for (const layer of layers) {
    if (!layer) continue;
    for (let i = 0; i < out.length; i++) {
      const m = layer.layerM[i] ?? 0;
      if (m === 0 || (layer.shown[4 * i + 3] ?? 0) < 128) continue;
      if (virtual[i] === 0 || m < (out[i] ?? 0)) out[i] = m;
      virtual[i] = 1;
    }
  }
  return out;
}

/** Whether no virtual object is at a pixel. */
function uncovered({ image, layers }: Seen): Uint8Array {
  const free = new Uint8Array(image.widthPx * image.heightPx).fill(1);
  for (const layer of layers) {
    for (let i = 0; i < free.length; i++) if (layer && (layer.shown[4 * i + 3] ?? 0) > 0) free[i] = 0;
  }
  return free;
}
