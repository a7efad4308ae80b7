import { deriveObjects } from '../../kit/derive-objects.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { AppliedTechnique } from '../../kit/technique-view.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { objects: output } = ctx.outputs;
  const { technique } = ctx.inputs;
  const materials = namesIn(ctx.config.materials);
  const applied: AppliedTechnique | null = technique && { technique, materials };
  let version = technique?.version;
  let listed = -1;
  const derived = deriveObjects(output, () => {});

  /**
   * Applies the technique to all items. Techniques that they already have remain, because they apply to materials that this one does not
   * match.
   */
  function applyToAll(): void {
    if (applied) for (const item of output.items) item.techniques = [...(item.techniques ?? []), applied];
  }

  return {
    version: 0,
    update: () => {
      derived.update(ctx.inputs.objects);
      if (output.version !== listed) {
        applyToAll();
      } else if (technique?.version !== version) {
        // The same items with another technique: readers must rebuild their proxies.
        output.version++;
      }
      version = technique?.version;
      listed = output.version;
    },
    dispose: () => {},
  };
}

function namesIn(text: string): readonly string[] | null {
  const names = text
    .split(',')
    .map((name) => name.trim())
    .filter((name) => name !== '');
  return names.length === 0 ? null : names;
}
