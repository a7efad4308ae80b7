import type { Player } from '../../export/runtime/player.ts';
import { probeDepth } from '../../export/runtime/probe-depth.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FromPreview, PreviewProbe, ToPreview } from '../preview-protocol.ts';
import type { CaptureSource } from './posters.ts';

type Question = Extract<ToPreview, { kind: 'probe' }>;

/** The part of the result that is known before the frame is shown. */
type Found = Pick<PreviewProbe, 'x' | 'y' | 'depth'> & { readonly aroundPx: number };

/** Answers probe requests: at most one per frame, the newest. */
export interface Probes {
  ask(question: Question): void;
  /** Whether a request waits for a frame. */
  readonly busy: boolean;
  beforeFrame(place: CaptureSource | null): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: CaptureSource | null): void;
}

/**
 * Creates the handler of probe requests.
 *
 * @param wake Requests a frame, also while the preview is paused.
 */
export function createProbes(send: (message: FromPreview) => void, wake: () => void): Probes {
  let question: Question | null = null;
  /** Result without the color. An emulated device shows its image only after the frame. */
  let waiting: Found | null = null;
  const answer = (place: CaptureSource, { x, y, depth, aroundPx }: Found) =>
    send({ kind: 'probed', probe: { x, y, depth, ...colorsAt(place.canvas, x, y, aroundPx) } });
  return {
    ask: (asked) => {
      question = asked;
      wake();
    },
    get busy() {
      return question !== null;
    },
    beforeFrame: (place) => {
      if (waiting && place) answer(place, waiting);
      waiting = null;
    },
    afterFrame: (player, frame, place) => {
      if (!question || !place) return;
      const { x, y, layer, ofLayer = false, aroundPx = 0 } = question;
      // A program that keeps the layer is on its way.
      if (ofLayer && !player.inspect(layer)?.layer) return;
      question = null;
      const probe = { x, y, depth: depthAt(player, frame, layer, !ofLayer, x, y), aroundPx };
      if (place.shows === 'in the frame') answer(place, probe);
      else {
        waiting = probe;
        wake();
      }
    },
  };
}

function depthAt(
  player: Pick<Player, 'inspect'>,
  frame: SessionFrame,
  layer: string | null,
  withRoom: boolean,
  x: number,
  y: number,
): PreviewProbe['depth'] {
  const { framebufferWidthPx: width, framebufferHeightPx: height } = frame;
  for (let index = 0; index < frame.viewCount; index++) {
    const viewport = frame.views[index]?.viewport;
    if (!viewport) continue;
    const u = (x * width - viewport.x) / viewport.widthPx;
    const v = ((1 - y) * height - viewport.y) / viewport.heightPx;
    if (u < 0 || u >= 1 || v < 0 || v >= 1) continue;
    const inspected = player.inspect(layer);
    return inspected && probeDepth(inspected, index, u, v, withRoom);
  }
  return null;
}

let square: OffscreenCanvasRenderingContext2D | null = null;

function colorsAt(canvas: HTMLCanvasElement, x: number, y: number, aroundPx: number): Pick<PreviewProbe, 'color' | 'around'> {
  square ??= new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  if (!square) return { color: [0, 0, 0, 0] };
  const sidePx = 2 * aroundPx + 1;
  // Setting the size of a canvas clears it.
  square.canvas.width = sidePx;
  square.canvas.height = sidePx;
  const left = Math.min(canvas.width - 1, Math.floor(x * canvas.width)) - aroundPx;
  const top = Math.min(canvas.height - 1, Math.floor(y * canvas.height)) - aroundPx;
  square.drawImage(canvas, -left, -top);
  const { data } = square.getImageData(0, 0, sidePx, sidePx);
  const middle = 4 * (aroundPx * sidePx + aroundPx);
  const [r = 0, g = 0, b = 0, a = 0] = data.subarray(middle, middle + 4);
  return { color: [r, g, b, a], ...(aroundPx > 0 ? { around: data } : {}) };
}
