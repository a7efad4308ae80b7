import { NOTHING_TO_FALL_ON } from '../../kit/light-shadow.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';
import { createCasterStrokes } from './strokes.ts';

const VOLUMES_FALL_ON_NOTHING = {
  code: 'SCR015',
  severity: 'warning',
  port: 'receivers',
  message: '“Receivers” is not connected. Room depth only hides shadow volumes; it does not receive them.',
  fix: 'Connect Detected planes or a Phantom, or set “Method” to “Shadow map”.',
} as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { strength, color, toleranceM } = ctx.params;
  const { depth, receivers } = ctx.inputs;
  const { on, method, drawing } = ctx.config;
  const volumes = method === 'volume' ? { volumesOf: ctx.inputs.casters } : {};
  const room = depth ? { room: { depth, toleranceM } } : {};
  const { spacingPx, turnRad: turn, contour, contactM } = ctx.params;
  const sketch = drawing === 'strokes' && method === 'map' ? createCasterStrokes({ spacingPx, turn, contour, contactM }) : null;
  const scene = ctx.scenes.createScene({
    kind: 'shadow-catcher',
    strength,
    color,
    on,
    ...volumes,
    ...room,
    ...(sketch ? { strokes: sketch.strokes } : {}),
  });
  return {
    version: 0,
    update: () => {
      if (receivers.length === 0) {
        if (!depth) ctx.report(NOTHING_TO_FALL_ON);
        else if (method === 'volume') ctx.report(VOLUMES_FALL_ON_NOTHING);
      }
      sketch?.update(ctx.inputs.casters);
      scene.update(receivers, ctx.inputs.lights);
    },
    draw: scene.draw,
    dispose: scene.dispose,
  };
}
