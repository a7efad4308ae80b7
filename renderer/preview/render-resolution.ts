import type { Program } from '../../export/program/program.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import type { RenderSize } from '../preview-protocol.ts';

export type SizePx = readonly [width: number, height: number];

/** Chooses the size in which the preview renders: independent of the panel, and smaller during drags that would be slow. */
export interface RenderResolution {
  /** The size for the next frame, in the shape of the window. The same array while it stays the same. */
  sizePx(): SizePx;
  setSize(size: RenderSize): void;
  /** Whether the GPU of the preview is emulated by the CPU. */
  setSoftware(software: boolean): void;
  follow(program: Program): void;
  /** Where a pointer drags: in the editor's page or in the preview's. */
  setDragging(where: 'editor' | 'preview', on: boolean): void;
  /** Resolves after this time. */
  rest(ms: number): Promise<void>;
  /** Called before and after a frame is drawn. */
  begin(): void;
  end(): void;
  /** Whether the size must stay, as for a video that is being recorded. */
  setFixed(fixed: boolean): void;
}

/** Shape and density of the window. */
interface Surface {
  readonly innerWidth: number;
  readonly innerHeight: number;
  readonly devicePixelRatio: number;
}

/** Longest frame time that drags accept. */
const MAX_FRAME_S = 1 / 30;
/** How far frames may exceed it before the resolution changes, because each change allocates all targets again. */
const TOLERANCE = 1.15;
/** A drag whose frames were shorter begins the next one with a larger image. */
const EASY_FRAME_S = 1 / 50;
/** A lower resolution that leaves more of the frame time than this is taken back. */
const USELESS = 0.85;
/** Frames after a change that are not measured. */
const SKIPPED = 2;
/** Frames that are measured before a change. */
const MEASURED = 3;
const STEPS = [1, 0.75, 0.5, 0.35, 0.25] as const;
/** Pause after a drag until the full resolution returns. */
const STILL_S = 0.15;
const MAX_PIXEL_RATIO = 2;
const AUTO_PX = 1080;

/** @param wake Requests a frame, also while the preview is paused. */
export function createRenderResolution(surface: Surface, clock: FrameClock, wake: () => void): RenderResolution {
  let size: RenderSize = 'panel';
  let software = false;
  /** Whether the program keeps images of earlier frames, which a change of size would clear. */
  let keepsImages = false;
  let fixed = false;
  const drags = { editor: false, preview: false };
  /** Index in `STEPS` while dragging, kept for the next drag. */
  let step = 0;
  let lowered = false;
  /** Whether the last measured frames took no longer than the display. */
  let easy = false;
  /** The resolution before the last change of this drag, and its frame time. */
  let larger: { readonly step: number; readonly meanS: number } | null = null;
  /** Whether this drag keeps its resolution, because a lower one did not help. */
  let settled = false;
  let release = 0;
  let beganS = 0;
  let skipped = 0;
  let totalS = 0;
  let measured = 0;
  let waiting = false;
  let current: SizePx = [1, 1];

  const lower = (on: boolean) => {
    if (on === lowered) return;
    lowered = on;
    if (on && easy) step = Math.max(0, step - 1);
    easy = false;
    larger = null;
    settled = false;
    skipped = 0;
    totalS = 0;
    measured = 0;
    wake();
  };
  const measure = (frameS: number) => {
    if (!lowered || skipped++ < SKIPPED) return;
    totalS += frameS;
    if (++measured < MEASURED) return;
    const meanS = totalS / measured;
    totalS = 0;
    measured = 0;
    easy = meanS < EASY_FRAME_S;
    const before = larger;
    larger = null;
    if (before !== null && meanS > before.meanS * USELESS) {
      // Something other than the number of pixels takes the time.
      step = before.step;
      settled = true;
      return;
    }
    if (meanS <= MAX_FRAME_S * TOLERANCE || settled) return;
    const wanted = (STEPS[step] ?? 1) * Math.sqrt(MAX_FRAME_S / meanS);
    const next = STEPS.findIndex((scale) => scale <= wanted);
    larger = { step, meanS };
    step = next === -1 ? STEPS.length - 1 : Math.max(step, next);
    skipped = 0;
  };
  return {
    sizePx: () => {
      const { innerWidth, innerHeight, devicePixelRatio } = surface;
      const density = Math.min(devicePixelRatio, MAX_PIXEL_RATIO);
      const short = Math.max(1, Math.min(innerWidth, innerHeight));
      const chosen = size === 'auto' ? (software ? 'panel' : AUTO_PX) : size;
      const full = chosen === 'panel' ? density : chosen / short;
      const scale = full * (lowered && !keepsImages && !fixed ? (STEPS[step] ?? 1) : 1);
      const [width, height] = [Math.max(1, Math.round(innerWidth * scale)), Math.max(1, Math.round(innerHeight * scale))];
      if (width !== current[0] || height !== current[1]) current = [width, height];
      return current;
    },
    setSize: (next) => {
      size = next;
      step = 0;
      wake();
    },
    setSoftware: (next) => {
      software = next;
    },
    follow: ({ resources }) => {
      keepsImages = resources.some((resource) => resource.kind === 'target' && resource.lifetime === 'persistent');
    },
    setDragging: (where, on) => {
      drags[where] = on;
      const mine = ++release;
      if (drags.editor || drags.preview) lower(true);
      else {
        void clock.delay(STILL_S).then(() => {
          if (mine === release) lower(false);
        });
      }
    },
    rest: (ms) => clock.delay(ms / 1000),
    begin: () => {
      beganS = clock.nowS();
    },
    end: () => {
      if (!lowered || waiting) return;
      waiting = true;
      const fromS = beganS;
      // The browser delays the next frame until the GPU has caught up.
      clock.requestFrame(() => {
        waiting = false;
        measure(clock.nowS() - fromS);
      });
    },
    setFixed: (next) => {
      fixed = next;
    },
  };
}

/** Whether the driver draws on the CPU. */
export function drawsInSoftware(gl: WebGL2RenderingContext): boolean {
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer: unknown = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(String(renderer));
}

/** Setting the size of a canvas clears it, even to the same size. */
export function setCanvasSize(canvas: HTMLCanvasElement, [widthPx, heightPx]: SizePx): void {
  if (canvas.width !== widthPx) canvas.width = widthPx;
  if (canvas.height !== heightPx) canvas.height = heightPx;
}
