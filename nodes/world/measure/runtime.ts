import type { PoseView } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import type { definition } from './definition.ts';
import { createSeenPoint, INTERVAL_95, type Measured, measureAngle, measureDistance, measureHeight, setNoise } from './propagate.ts';

/** A point, and where it was seen from and at. */
interface Sighting {
  readonly point: ReturnType<typeof createSeenPoint>;
  readonly eyeM: Float64Array;
  readonly seenAtM: Float64Array;
  isSeen: boolean;
  jumps: number;
}

function createSighting(): Sighting {
  return { point: createSeenPoint(), eyeM: new Float64Array(3), seenAtM: new Float64Array(3), isSeen: false, jumps: 0 };
}

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { mode, growth } = ctx.config;
  const { alongM, referenceM, acrossRad, moveM } = ctx.params;
  const { inputs, outputs } = ctx;
  const a = createSighting();
  const b = createSighting();
  const c = createSighting();
  const eyeM = new Float64Array(3);
  const noise = { alongM: 0, referenceM: 1, growth, acrossRad: 0 };
  const measured: Measured = { value: 0, sigma: 0 };

  /** Takes the pose as the point; false while it is not valid. */
  function look(sighting: Sighting, pose: PoseView | null): boolean {
    if (!pose?.valid) {
      sighting.isSeen = false;
      return false;
    }
    const { positionM } = sighting.point;
    for (let i = 0; i < 3; i++) positionM[i] = pose.worldFromPose[12 + i] ?? 0;
    if (!sighting.isSeen || sighting.jumps !== pose.jumps || squaredDistance(positionM, sighting.seenAtM) >= moveM.value ** 2) {
      sighting.eyeM.set(eyeM);
      sighting.seenAtM.set(positionM);
    }
    sighting.isSeen = true;
    sighting.jumps = pose.jumps;
    setNoise(sighting.point, sighting.eyeM, noise);
    return true;
  }

  function measure(): boolean {
    // All are looked at, so that each forgets its line of sight when its pose becomes invalid.
    const hasA = look(a, inputs.a);
    const hasB = look(b, inputs.b);
    const hasC = look(c, inputs.c);
    switch (mode) {
      case 'height':
        if (hasA) measureHeight(a.point, measured);
        return hasA;
      case 'distance':
        if (hasA && hasB) measureDistance(a.point, b.point, measured);
        return hasA && hasB;
      case 'angle':
        if (hasA && hasB && hasC) measureAngle(a.point, b.point, c.point, measured);
        return hasA && hasB && hasC;
    }
  }

  function forget(): void {
    for (const sighting of [a, b, c]) sighting.isSeen = false;
  }

  return {
    update: (frame) => {
      noise.alongM = alongM.value;
      noise.referenceM = referenceM.value;
      noise.acrossRad = acrossRad.value;
      const valid = writeViewerPosition(eyeM, frame) && measure();
      outputs.valid.value = valid;
      outputs.value.value = valid ? measured.value : 0;
      outputs.uncertainty.value = valid ? INTERVAL_95 * measured.sigma : 0;
    },
    reset: forget,
    dispose: () => {},
  };
}

function squaredDistance(p: Float64Array, q: Float64Array): number {
  return ((p[0] ?? 0) - (q[0] ?? 0)) ** 2 + ((p[1] ?? 0) - (q[1] ?? 0)) ** 2 + ((p[2] ?? 0) - (q[2] ?? 0)) ** 2;
}
