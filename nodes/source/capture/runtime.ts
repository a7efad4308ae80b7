import { type CaptureDrawing, createCaptureDrawing } from '../../kit/capture-drawing/capture-drawing.ts';
import { createDepthMeshDrawing } from '../../kit/capture-drawing/depth-meshes/depth-mesh-drawing.ts';
import { createWindowedDrawing, type WindowedDrawing } from '../../kit/capture-drawing/windowed/windowed-drawing.ts';
import { multiplyMatrices } from '../../kit/matrices.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { DrawView, NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { method } = ctx.config;
  const blended = Math.round(ctx.config.blended);
  const updateFrames = Math.round(ctx.config.updateFrames);
  const { positionM, rotationRad, scale } = ctx.params;
  const id = ctx.assetIds.file;
  const handle = id === null ? null : ctx.assets.capture(id);
  const { gl, clock } = ctx;
  let drawing: CaptureDrawing | null = null;
  let windowed: WindowedDrawing | null = null;
  /** Draws that computed weights, of which the next frame may compute more. */
  let updates = 0;
  let drawsDepthMeshes = false;
  const rigid = new Float32Array(16);
  const worldFromCapture = new Float32Array(16);
  const clipFromWorld = new Float32Array(16);
  const clipFromCapture = new Float32Array(16);
  const eye = new Float32Array(3);
  const forward = new Float32Array(3);

  return {
    get version() {
      const capture = handle?.value ?? null;
      return capture === null ? 0 : 1 + capture.version + updates;
    },
    update: () => {},
    draw: (target: DrawView) => {
      const { view } = target;
      const capture = handle?.value ?? null;
      if (!capture) return;
      // Pages draw a capture before they have loaded its depth meshes.
      if (method === 'depth-meshes' && capture.depthMeshes && !drawsDepthMeshes) {
        drawing?.dispose();
        drawing = createDepthMeshDrawing(gl, capture);
        drawsDepthMeshes = true;
      }
      if (method === 'lumigraph' && updateFrames > 0) {
        windowed ??= createWindowedDrawing(gl, capture, blended, updateFrames, clock);
        drawing = windowed;
      }
      drawing ??= createCaptureDrawing(gl, capture, method === 'depth-meshes' ? 'lumigraph' : method, blended);
      const factor = Math.max(scale.value, 1e-6);
      setFromAngles(rigid, positionM.value, rotationRad.value);
      for (let i = 0; i < 16; i++) worldFromCapture[i] = (rigid[i] ?? 0) * (i < 12 ? factor : 1);
      multiplyMatrices(clipFromWorld, view.clipFromView as Float32Array, view.viewFromWorld as Float32Array);
      multiplyMatrices(clipFromCapture, clipFromWorld, worldFromCapture);
      for (let axis = 0; axis < 3; axis++) {
        eye[axis] = 0;
        forward[axis] = 0;
        for (let i = 0; i < 3; i++) {
          const along = rigid[4 * axis + i] ?? 0;
          eye[axis] = (eye[axis] ?? 0) + (along * ((view.worldFromView[12 + i] ?? 0) - (rigid[12 + i] ?? 0))) / factor;
          forward[axis] = (forward[axis] ?? 0) - along * (view.worldFromView[8 + i] ?? 0);
        }
      }
      drawing.draw(clipFromCapture, eye, forward, target);
      if (windowed && windowed.updated > 0) updates++;
    },
    dispose: () => {
      drawing?.dispose();
      handle?.release();
    },
  };
}
