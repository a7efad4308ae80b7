import type { Player } from '../../export/runtime/player.ts';
import { probeDepth } from '../../export/runtime/probe-depth.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FromPreview, PreviewProbe, ToPreview } from '../preview-protocol.ts';
import type { PosterPlace } from './posters.ts';

type Question = Extract<ToPreview, { kind: 'probe' }>;

/** Says what is under the pointer: one answer a frame, to the last question. */
export interface Probes {
  ask(question: Question): void;
  beforeFrame(place: PosterPlace | null): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: PosterPlace | null): void;
}

/** `wake` asks for a frame, also of a preview that is held. */
export function createProbes(send: (message: FromPreview) => void, wake: () => void): Probes {
  let question: Question | null = null;
  /** An emulated device shows its picture when the frame is over. */
  let waiting: Omit<PreviewProbe, 'color'> | null = null;
  const answer = (place: PosterPlace, { x, y, depth }: Omit<PreviewProbe, 'color'>) =>
    send({ kind: 'probed', probe: { x, y, depth, color: colorAt(place.canvas, x, y) } });
  return {
    ask: (asked) => {
      question = asked;
      wake();
    },
    beforeFrame: (place) => {
      if (waiting && place) answer(place, waiting);
      waiting = null;
    },
    afterFrame: (player, frame, place) => {
      if (!question || !place) return;
      const { x, y, layer } = question;
      question = null;
      const probe = { x, y, depth: depthAt(player, frame, layer, x, y) };
      if (place.shows === 'in the frame') answer(place, probe);
      else {
        waiting = probe;
        wake();
      }
    },
  };
}

function depthAt(player: Pick<Player, 'inspect'>, frame: SessionFrame, layer: string | null, x: number, y: number) {
  const { framebufferWidthPx: width, framebufferHeightPx: height } = frame;
  for (let index = 0; index < frame.viewCount; index++) {
    const viewport = frame.views[index]?.viewport;
    if (!viewport) continue;
    const u = (x * width - viewport.x) / viewport.widthPx;
    const v = ((1 - y) * height - viewport.y) / viewport.heightPx;
    if (u < 0 || u >= 1 || v < 0 || v >= 1) continue;
    const inspected = player.inspect(layer);
    return inspected && probeDepth(inspected, index, u, v);
  }
  return null;
}

let point: OffscreenCanvasRenderingContext2D | null = null;

function colorAt(canvas: HTMLCanvasElement, x: number, y: number): PreviewProbe['color'] {
  point ??= new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  if (!point) return [0, 0, 0, 0];
  const left = Math.min(canvas.width - 1, Math.floor(x * canvas.width));
  const top = Math.min(canvas.height - 1, Math.floor(y * canvas.height));
  point.clearRect(0, 0, 1, 1);
  point.drawImage(canvas, left, top, 1, 1, 0, 0, 1, 1);
  const [r = 0, g = 0, b = 0, a = 0] = point.getImageData(0, 0, 1, 1).data;
  return [r, g, b, a];
}
