import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { sizeM, marginM } = ctx.params;
  const { outputs } = ctx;
  let isInside = false;

  function contains(point: ArrayLike<number>, worldFromBox: ArrayLike<number> | null, marginM: number): boolean {
    for (let axis = 0; axis < 3; axis++) {
      let along = 0;
      for (let i = 0; i < 3; i++) {
        const unit = worldFromBox ? (worldFromBox[axis * 4 + i] ?? 0) : Number(i === axis);
        along += unit * ((point[12 + i] ?? 0) - (worldFromBox?.[12 + i] ?? 0));
      }
      if (Math.abs(along) > (sizeM.value[axis] ?? 0) / 2 + marginM) return false;
    }
    return true;
  }

  return {
    update: () => {
      const { pose, box } = ctx.inputs;
      const point = pose?.valid ? pose.worldFromPose : null;
      const wasInside = isInside;
      isInside =
        point !== null && (box === null || box.valid) && contains(point, box?.worldFromPose ?? null, wasInside ? marginM.value : 0);
      outputs.inside.value = isInside;
      if (isInside === wasInside) return;
      const pulse = (isInside ? outputs.entered : outputs.left).emit();
      if (point) pulse.setPose(point);
    },
    reset: () => {
      isInside = false;
    },
    dispose: () => {},
  };
}
