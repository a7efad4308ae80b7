import type { CaptureTextures } from '../../../export/runtime/assets/capture/capture-textures.ts';
import { loadDepthMeshes } from '../../../export/runtime/assets/capture/load-depth-meshes.ts';
import { createGlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import type { CaptureView } from '../../../nodes/kit/capture.ts';
import { type CaptureDrawing, createCaptureDrawing } from '../../../nodes/kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../../nodes/kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import { createWindowedDrawing } from '../../../nodes/kit/capture-drawing/windowed/windowed-drawing.ts';
import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import { setPassState } from '../../../nodes/kit/pass-state.ts';
import { bumpyCapture, inverseOfRigid, poseTowardsMiddle } from './bumpy-capture.ts';
import { measureFrames } from './frame-ms.ts';

/** How a capture is drawn: a method of the node, or the lumigraph with weights per vertex. */
export type GrowthMethod = 'plain' | 'nearest' | 'lumigraph' | 'windowed' | 'depth-meshes';

/** A capture and how it is drawn. */
export interface GrowthCase {
  readonly viewCount: number;
  readonly vertexCount: number;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly method: GrowthMethod;
  /** The depth meshes of its views, if they are drawn. */
  readonly depthViews: readonly CaptureView[] | null;
}

export const PHOTO_PX = 256;
const BLENDED = 2;
/** Frames within which all vertices get new weights. */
const UPDATE_FRAMES = 30;
/** How far the eye goes around the ball from frame to frame: other views are the nearest, and weights change. */
const STEP_RAD = 0.02;

const canvas = new OffscreenCanvas(4, 4);
const captures = new Map<string, Promise<CaptureTextures>>();
const frames = new Map<string, () => number>();

/** Milliseconds of a frame, from an eye that moves. The first call makes the capture. */
export async function frame(wanted: GrowthCase): Promise<number> {
  const key = JSON.stringify([wanted.viewCount, wanted.vertexCount, wanted.method, wanted.widthPx]);
  const measured = frames.get(key) ?? (await open(wanted));
  frames.set(key, measured);
  return measured();
}

async function open({ viewCount, vertexCount, widthPx, heightPx, method, depthViews }: GrowthCase): Promise<() => number> {
  const gl = canvas.getContext('webgl2', { antialias: false });
  if (!gl) throw new Error('No WebGL 2.');
  const key = `${viewCount} ${vertexCount}`;
  const capture = captures.get(key) ?? bumpyCapture(gl, vertexCount, viewCount, PHOTO_PX);
  captures.set(key, capture);
  const textures = await capture;
  if (depthViews) {
    const load = async (file: string): Promise<ArrayBuffer> => (await fetch(file)).arrayBuffer();
    textures.setDepthMeshes(await loadDepthMeshes(createGlObjects(gl), depthViews, load));
  }
  const { asset } = textures;
  const drawingOf = (): CaptureDrawing => {
    if (method === 'depth-meshes') return createDepthMeshDrawing(gl, asset);
    // An unknown time of a frame leaves the window as small as it may be.
    if (method === 'windowed') return createWindowedDrawing(gl, asset, BLENDED, UPDATE_FRAMES, { deltaS: 0, held: false });
    return createCaptureDrawing(gl, asset, method, BLENDED);
  };
  const drawing = drawingOf();
  const clipFromView = Float32Array.of((2 * heightPx) / widthPx, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.202, 0);
  const clip = new Float32Array(16);
  const target = { framebuffer: null, viewport: { x: 0, y: 0, widthPx, heightPx } };
  let turn = 0;
  const draw = (): void => {
    turn += STEP_RAD;
    const pose = poseTowardsMiddle([2.4 * Math.sin(turn), 0.4, 2.4 * Math.cos(turn)]);
    multiplyMatrices(clip, clipFromView, inverseOfRigid(pose));
    setPassState(gl, null, null, 0, 0, widthPx, heightPx);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [eye, forward] = [pose.slice(12, 15), pose.slice(8, 11).map((x) => -x)];
    drawing.draw(clip, eye, forward, target);
  };
  return () => {
    if (canvas.width !== widthPx) {
      Object.assign(canvas, { width: widthPx, height: heightPx });
      // The first frame of another size also allocates.
      measureFrames({ gl, draw }, 1);
    }
    const ms = measureFrames({ gl, draw }, 1);
    if (gl.getError() !== gl.NO_ERROR) throw new Error('The capture was not drawn.');
    return ms;
  };
}
