import { createHit, type Hit, type HitList } from '../../kit/hit-test.ts';
import { createPoseFilter } from '../../kit/one-euro.ts';
import { pointerById } from '../../kit/pointers.ts';
import { isPose, writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { surfaceOrientation } from '../../kit/surface-pose.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { from } = ctx.config;
  const { smoothingS, beta } = ctx.params;
  const { outputs, session } = ctx;
  const hitTest = from === 'ray' ? null : session.openHitTest({ from: from === 'center' ? 'viewer' : from });
  const ownHit = createHit();
  const filter = createPoseFilter();
  const filtered = new Float32Array(16);
  /** The source of the last frame's hit; empty if nothing was hit. */
  let lastSource = '';
  let lastPointer = 0;
  let lastJumps = 0;
  let jumps = 0;

  function find(frame: SessionFrame): Hit | null {
    if (hitTest) return choose(hitTest.read(), frame);
    const { ray } = ctx.inputs;
    return ray?.valid && session.castRay(ray.worldFromPose, ownHit) ? ownHit : null;
  }

  /**
   * Returns the filtered pose of the hit. The filter restarts if nothing was hit before, the hit is that of another pointer, or world space
   * has moved.
   */
  function calm(hit: Hit, frame: SessionFrame): Float32Array {
    if (smoothingS.value <= 0 || !isPose(hit.worldFromHit)) {
      filter.restart();
      return hit.worldFromHit;
    }
    if (lastSource === '' || hit.pointer !== lastPointer || frame.jumps !== lastJumps) filter.restart();
    filtered.set(hit.worldFromHit);
    filter.apply(filtered, ctx.clock.deltaS, 1 / (2 * Math.PI * smoothingS.value), beta.value);
    return filtered;
  }

  return {
    update: (frame) => {
      const hit = find(frame);
      const pose = hit && calm(hit, frame);
      if (frame.jumps !== lastJumps || (hit && hit.pointer !== lastPointer)) jumps++;
      lastSource = hit?.source ?? '';
      lastPointer = hit?.pointer ?? lastPointer;
      lastJumps = frame.jumps;
      writePose(outputs.pose, pose, jumps);
      outputs.hit.value = hit !== null;
      outputs.distanceM.value = hit?.distanceM ?? 0;
      outputs.orientation.value = hit ? surfaceOrientation(hit.worldFromHit) : '';
      outputs.label.value = hit?.label ?? '';
      outputs.source.value = hit?.source ?? '';
    },
    reset: () => {
      filter.restart();
      lastSource = '';
      lastPointer = 0;
      lastJumps = 0;
      jumps = 0;
    },
    dispose: () => hitTest?.close(),
  };
}

/** Chooses the hit of the first pointer that is pressed, otherwise the first hit; null if there is none. */
function choose(hits: HitList, { input }: SessionFrame): Hit | null {
  for (let i = 0; i < hits.count; i++) {
    const pointer = pointerById(input, hits.at(i).pointer);
    if (pointer && pointer.phase !== 'hover') return hits.at(i);
  }
  return hits.count > 0 ? hits.at(0) : null;
}
