import { multiplyMatrices } from '../../kit/matrices.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { DrawView, NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { createSplatDrawing, type SplatDrawing } from '../../kit/splat-drawing/splat-drawing.ts';
import type { definition } from './definition.ts';
import { createSortDriver, type SortDriver } from './sort-driver.ts';

/** Rotations from the axes of a file to those of the world, column-major 4×4. */
const UPRIGHT = {
  '-y': Float32Array.of(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1),
  y: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
  z: Float32Array.of(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1),
} as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { up, antialiased } = ctx.config;
  const { positionM, rotationRad, scale } = ctx.params;
  const { gl, clock, workers, occlusion } = ctx;
  const id = ctx.assetIds.file;
  const handle = id === null ? null : ctx.assets.splats(id);
  let started: { readonly drawing: SplatDrawing; readonly sorting: SortDriver } | null = null;
  /** Orders that were drawn or will be, and 1 for the splats themselves. */
  let version = 0;
  const rigid = new Float32Array(16);
  const worldFromSplats = new Float32Array(16);
  const viewFromSplats = new Float32Array(16);
  const eye = new Float32Array(3);
  const direction = new Float32Array(3);

  const start = () => {
    const splats = handle?.value ?? null;
    if (!started && splats) {
      const drawing = createSplatDrawing(gl, splats, antialiased || splats.antialiased, occlusion);
      started = { drawing, sorting: createSortDriver(workers, splats.positions) };
      version++;
    }
    return started;
  };
  const setOrder = (order: Uint32Array): void => {
    started?.drawing.setOrder(order);
    version++;
  };
  /** The mean direction of the views, in the space of the splats. */
  const setDirection = ({ views, viewCount }: SessionFrame): void => {
    direction.fill(0);
    for (let i = 0; i < viewCount; i++) addAlong(direction, worldFromSplats, views[i]?.worldFromView, -1);
    const length = Math.hypot(direction[0] ?? 0, direction[1] ?? 0, direction[2] ?? 0) || 1;
    for (let axis = 0; axis < 3; axis++) direction[axis] = (direction[axis] ?? 0) / length;
  };

  return {
    get version() {
      return version;
    },
    update: (frame) => {
      const shown = start();
      if (!shown) return;
      const factor = Math.max(scale.value, 1e-6);
      setFromAngles(rigid, positionM.value, rotationRad.value);
      multiplyMatrices(worldFromSplats, rigid, UPRIGHT[up]);
      for (let i = 0; i < 12; i++) worldFromSplats[i] = (worldFromSplats[i] ?? 0) * factor;
      // Before the next request, which may send the buffer of the order away.
      shown.sorting.take(setOrder);
      setDirection(frame);
      shown.sorting.request(direction, clock.held);
    },
    settle: () => started?.sorting.settle() ?? null,
    draw: (view: DrawView) => {
      if (!started) return;
      started.sorting.take(setOrder);
      multiplyMatrices(viewFromSplats, view.view.viewFromWorld, worldFromSplats);
      setEye(eye, worldFromSplats, view.view.worldFromView, Math.max(scale.value, 1e-6));
      started.drawing.draw(view, viewFromSplats, eye);
    },
    dispose: () => {
      started?.drawing.dispose();
      started?.sorting.dispose();
      handle?.release();
    },
  };
}

/** Adds the z axis of a view, times `sign`, in the axes of the splats. */
function addAlong(out: Float32Array, worldFromSplats: Float32Array, worldFromView: Float32Array | undefined, sign: number): void {
  for (let axis = 0; axis < 3; axis++) {
    let along = 0;
    for (let i = 0; i < 3; i++) along += (worldFromSplats[4 * axis + i] ?? 0) * (worldFromView?.[8 + i] ?? 0);
    out[axis] = (out[axis] ?? 0) + sign * along;
  }
}

/** Writes the position of a view in the space of the splats. */
function setEye(out: Float32Array, worldFromSplats: Float32Array, worldFromView: Float32Array, factor: number): void {
  for (let axis = 0; axis < 3; axis++) {
    let along = 0;
    for (let i = 0; i < 3; i++) {
      along += (worldFromSplats[4 * axis + i] ?? 0) * ((worldFromView[12 + i] ?? 0) - (worldFromSplats[12 + i] ?? 0));
    }
    out[axis] = along / (factor * factor);
  }
}
