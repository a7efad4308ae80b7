import { createCaptureDrawing } from '../../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createWindowedDrawing } from '../../../nodes/kit/capture-drawing/windowed/windowed-drawing.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import { setPassState } from '../../../nodes/kit/pass-state.ts';
import { bumpyCapture, inverseOfRigid, poseTowardsMiddle } from './bumpy-capture.ts';
import { measureFrames } from './frame-ms.ts';

/**
 * What a frame does: draw with weights per pixel, draw with the weights that vertices have, or only compute the weights of all vertices or of
 * those in a window.
 */
export type Weights = 'pixel' | 'all' | 'window' | 'kept';

const SIZE = { widthPx: 640, heightPx: 480 };
const BLENDED = 2;
let frameMs: ((weights: Weights) => number) | null = null;

/** Makes a capture and its drawings. */
export async function open(vertexCount: number, viewCount: number, frames: number): Promise<void> {
  const { widthPx, heightPx } = SIZE;
  const gl = new OffscreenCanvas(widthPx, heightPx).getContext('webgl2', { antialias: false });
  if (!gl) throw new Error('No WebGL 2.');
  const { asset } = await bumpyCapture(gl, vertexCount, viewCount);
  // An unknown time of a frame leaves the window as small as it may be.
  const clock = { deltaS: 0, held: false };
  const windowed = createWindowedDrawing(gl, asset, BLENDED, frames, clock);
  const perPixel = createCaptureDrawing(gl, asset, 'lumigraph', BLENDED);
  const clipFromView = Float32Array.of((2 * heightPx) / widthPx, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.202, 0);
  const clip = new Float32Array(16);
  let turn = 0;
  frameMs = (weights) => {
    clock.held = weights === 'all';
    const draw = (): void => {
      // In each frame, another eye needs other weights.
      if (weights !== 'kept') turn += 0.02;
      const pose = poseTowardsMiddle([2.4 * Math.sin(turn), 0.4, 2.4 * Math.cos(turn)]);
      multiplyMatrices(clip, clipFromView, inverseOfRigid(pose));
      setPassState(gl, null, null, 0, 0, widthPx, heightPx);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const [eye, forward] = [pose.slice(12, 15), pose.slice(8, 11).map((x) => -x)];
      (weights === 'pixel' ? perPixel : windowed).draw(clip, eye, forward, {
        framebuffer: null,
        viewport: { x: 0, y: 0, widthPx, heightPx },
      });
    };
    if (weights === 'kept') {
      clock.held = true;
      draw();
      clock.held = false;
    }
    if (weights === 'pixel' || weights === 'kept') return measureFrames({ gl, draw }, 1);
    const { drawElements } = gl;
    gl.drawElements = () => {};
    const ms = measureFrames({ gl, draw }, weights === 'all' ? 1 : 10);
    gl.drawElements = drawElements;
    return ms;
  };
}

/** Milliseconds of a frame. */
export function frame(weights: Weights): number {
  if (!frameMs) throw new Error('Nothing is open.');
  return frameMs(weights);
}
