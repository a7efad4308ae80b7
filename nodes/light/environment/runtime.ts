import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { EnvironmentLightItem } from '../../kit/scene-lists.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { intensity, rotationRad, visible } = ctx.params;
  const { environment } = ctx.inputs;
  const light: EnvironmentLightItem = {
    key: 'light',
    kind: 'environment',
    environment: null,
    intensity: 0,
    rotationRad: 0,
    visible: false,
  };
  ctx.outputs.lights.items.push(light);
  ctx.outputs.lights.version++;

  return {
    version: 0,
    update: () => {
      light.environment = environment?.asset ?? null;
      light.intensity = intensity.value * (environment?.intensity ?? 0);
      light.rotationRad = rotationRad.value + (environment?.rotationRad ?? 0);
      light.visible = visible.value;
    },
    dispose: () => {},
  };
}
