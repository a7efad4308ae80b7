import { compareImages } from '../../export/captures/evaluate/image-quality.ts';
import { createCaptureDrawing } from '../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createWindowedDrawing } from '../../nodes/kit/capture-drawing/windowed/windowed-drawing.ts';
import { multiplyMatrices } from '../../nodes/kit/matrices.ts';
import { setPassState } from '../../nodes/kit/pass-state.ts';
import { bumpyCapture, poseTowardsMiddle } from '../../tools/bench/pages/bumpy-capture.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { pictureUrl } from '../support/photo-pixels.page.ts';
import { createGl, createLayer, lookingAt, viewOf } from './scenes-kit.ts';

export interface WindowRun {
  /** By frame after the eye has come to rest: how many vertices got weights, and whether the image is the exact one, byte for byte. */
  readonly frames: readonly { readonly updated: number; readonly isExact: boolean }[];
  /** Calls of `beginTransformFeedback` in the last frame. */
  readonly lastFeedbacks: number;
  /** Whether a second view has its own exact image, and the first still has its. */
  readonly viewsAreExact: readonly [boolean, boolean];
  /** PSNR against weights per pixel, dB. */
  readonly psnrDb: number;
  readonly vertexCount: number;
  readonly leaks: readonly string[];
  readonly error: number;
  readonly shown: string;
}

const SIZE = { widthPx: 160, heightPx: 120 };

/** Moves an eye around a ball, then lets it rest, with weights that are computed within `frames` frames. */
export async function run(vertexCount: number, views: number, frames: number, blended: number): Promise<WindowRun> {
  const { widthPx, heightPx } = SIZE;
  const gl = createGl(widthPx, heightPx);
  const capture = await bumpyCapture(gl, vertexCount, views);
  const { asset } = capture;
  const layer = createLayer(gl, widthPx, heightPx);
  const tracked = trackGl(gl);
  const clock = { deltaS: 0, held: false };
  const windowed = createWindowedDrawing(gl, asset, blended, frames, clock);
  const exact = createWindowedDrawing(gl, asset, blended, frames, { deltaS: 0, held: true });
  const perPixel = createCaptureDrawing(gl, asset, 'lumigraph', blended);
  const clip = new Float32Array(16);
  const shoot = (drawing: Pick<typeof perPixel, 'draw'>, turn: number, viewIndex = 0): Uint8Array => {
    const position = [2.4 * Math.sin(turn), 0.5, 2.4 * Math.cos(turn)] as [number, number, number];
    const viewport = { x: 0, y: 0, widthPx, heightPx };
    const view = viewOf(lookingAt(position, [0, 0, 0], widthPx / heightPx), viewport);
    multiplyMatrices(clip, view.clipFromView as Float32Array, view.viewFromWorld as Float32Array);
    layer.clear();
    setPassState(gl, layer.framebuffer, null, 0, 0, widthPx, heightPx);
    const pose = poseTowardsMiddle(position);
    const forward = pose.slice(8, 11).map((x) => -x);
    drawing.draw(clip, Float32Array.from(position), forward, { framebuffer: layer.framebuffer, viewport, viewIndex });
    return layer.pixels();
  };
  const isEqual = (a: Uint8Array, b: Uint8Array): boolean => a.every((value, i) => value === b[i]);
  for (let i = 0; i < 2 * frames; i++) {
    // After the first one, frames come late, which leaves the window as small as it may be.
    clock.deltaS = i === 0 ? 0.016 : 0.05;
    shoot(windowed, -0.05 * i);
  }
  const truth = shoot(exact, 1);
  const run: { updated: number; isExact: boolean }[] = [];
  let feedbacks = 0;
  const { beginTransformFeedback } = gl;
  gl.beginTransformFeedback = (mode) => {
    feedbacks++;
    beginTransformFeedback.call(gl, mode);
  };
  for (let i = 0; i < frames + 3; i++) {
    feedbacks = 0;
    const image = shoot(windowed, 1);
    run.push({ updated: windowed.updated, isExact: isEqual(image, truth) });
  }
  const lastFeedbacks = feedbacks;
  const secondTruth = shoot(exact, 1.5, 1);
  for (let i = 0; i < frames; i++) shoot(windowed, 1.5, 1);
  const viewsAreExact = [isEqual(shoot(windowed, 1), truth), isEqual(shoot(windowed, 1.5, 1), secondTruth)] as const;
  const { psnrDb } = compareImages({ shown: truth, truth: shoot(perPixel, 1), widthPx, heightPx });
  for (const drawing of [windowed, exact, perPixel]) drawing.dispose();
  const error = gl.getError();
  const leaks = tracked.report();
  tracked.stop();
  return {
    frames: run,
    lastFeedbacks,
    viewsAreExact,
    psnrDb,
    leaks,
    error,
    vertexCount: (asset.mesh?.positions.length ?? 0) / 3,
    shown: pictureUrl(truth, widthPx, heightPx),
  };
}
