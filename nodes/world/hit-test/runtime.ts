import { createHit, type Hit, type HitList } from '../../kit/hit-test.ts';
import { pointerById } from '../../kit/pointers.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { surfaceOrientation } from '../../kit/surface-pose.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { from } = ctx.config;
  const { outputs, session } = ctx;
  const hitTest = from === 'ray' ? null : session.openHitTest({ from: from === 'center' ? 'viewer' : from });
  const ownHit = createHit();

  function find(frame: SessionFrame): Hit | null {
    if (hitTest) return choose(hitTest.read(), frame);
    const { ray } = ctx.inputs;
    return ray?.valid && session.castRay(ray.worldFromPose, ownHit) ? ownHit : null;
  }

  return {
    update: (frame) => {
      const hit = find(frame);
      writePose(outputs.pose, hit?.worldFromHit ?? null, frame.jumps);
      outputs.hit.value = hit !== null;
      outputs.distanceM.value = hit?.distanceM ?? 0;
      outputs.orientation.value = hit ? surfaceOrientation(hit.worldFromHit) : '';
      outputs.source.value = hit?.source ?? '';
    },
    dispose: () => hitTest?.close(),
  };
}

/** Of several pointers the first that is pressed, else the first. */
function choose(hits: HitList, { input }: SessionFrame): Hit | null {
  for (let i = 0; i < hits.count; i++) {
    const pointer = pointerById(input, hits.at(i).pointer);
    if (pointer && pointer.phase !== 'hover') return hits.at(i);
  }
  return hits.count > 0 ? hits.at(0) : null;
}
