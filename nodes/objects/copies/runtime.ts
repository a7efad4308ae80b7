import { Matrix4 } from 'three';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { type CopiedObject, createCopiedObject } from '../../kit/three/copied-objects.ts';
import { createVersionWatch } from '../../kit/version-watch.ts';
import type { definition } from './definition.ts';
import { placeCopy } from './place-copy.ts';

/** The greatest number of copies: the maximum of the param, which a wire could exceed. */
const MOST = 2000;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { stepM, radiusM, turnRad, sizeSpread, seed } = ctx.params;
  const { pattern } = ctx.config;
  const { objects } = ctx.outputs;
  const watch = createVersionWatch();
  const copied: CopiedObject[] = [];
  const places: Matrix4[] = [];
  const arrangement = { count: 0, stepM: stepM.value, radiusM: 0, turnRad: 0, sizeSpread: 0, seed: 0 };

  function clear(): void {
    for (const each of copied) each.dispose();
    copied.length = 0;
    objects.items.length = 0;
  }

  function rebuild(inputs: readonly ObjectList[], count: number): void {
    clear();
    places.length = 0;
    for (let i = 0; i < count; i++) places.push(new Matrix4());
    if (count > 0) {
      inputs.forEach((list, i) => {
        for (const source of list.items) {
          const made = createCopiedObject(source, `${i}/${source.key}`, count);
          copied.push(made);
          objects.items.push(...made.items);
        }
      });
    }
    objects.version++;
  }

  /** Whether a material of the source has become transparent or opaque since the copies were made. */
  function changedKind(): boolean {
    for (let i = 0; i < copied.length; i++) if (copied[i]?.isOutdated()) return true;
    return false;
  }

  return {
    version: 0,
    update: () => {
      const count = Math.min(Math.max(Math.floor(ctx.params.count.value) || 0, 0), MOST);
      const changed = watch.changed(ctx.inputs.objects);
      if (changed || count !== places.length || changedKind()) rebuild(ctx.inputs.objects, count);
      arrangement.count = count;
      arrangement.stepM = stepM.value;
      arrangement.radiusM = radiusM.value;
      arrangement.turnRad = turnRad.value;
      arrangement.sizeSpread = sizeSpread.value;
      arrangement.seed = seed.value;
      for (let i = 0; i < places.length; i++) {
        const place = places[i];
        if (place) placeCopy(pattern, i, arrangement, place);
      }
      for (let i = 0; i < copied.length; i++) copied[i]?.update(places);
    },
    dispose: clear,
  };
}
