import { type IUniform, Material, Vector3 } from 'three';
import type { NumberView, ObjectItem } from '../../../../nodes/kit/runtime.ts';
import type { TechniqueView } from '../../../../nodes/kit/technique-view.ts';
import { type Drawable, mapMaterials, materialsOf, programFeatures } from '../proxies/drawable.ts';
import type { ProxyPlan } from '../proxies/proxy.ts';
import type { OcclusionPatch } from './occlusion-patch.ts';
import { createTechniqueTwin } from './technique-twin.ts';
import type { TwinCache } from './twins.ts';

/** Plans for the meshes of one scene that are drawn by techniques. */
export interface TechniquePlans {
  /** Null for what no technique is for. `own` makes the material of parts that keep their own. */
  plan(master: Drawable, item: ObjectItem, depthFirst: number, own: (part: Material) => Material): readonly ProxyPlan[] | null;
  /** Takes over this frame's values. */
  update(): void;
}

export interface TechniquePlansOptions {
  readonly twins: TwinCache;
  readonly ambient: NumberView;
  readonly occlusion: OcclusionPatch | null;
  readonly onChange: () => void;
}

/** Of a mesh with several materials, those that have no such pass. three leaves out what is not visible. */
const NOTHING = new Material();
NOTHING.visible = false;

export function createTechniquePlans({ twins, ambient, occlusion, onChange }: TechniquePlansOptions): TechniquePlans {
  const ambientUniform: IUniform<Vector3> = { value: new Vector3() };

  function twinOf(part: Material, features: string, technique: TechniqueView, passIndex: number, depthOnly: boolean): Material {
    const variant = `${features}|${technique.key}|${passIndex}${depthOnly ? '|depth' : ''}`;
    return twins.get(part, variant, () =>
      createTechniqueTwin(part, { technique, passIndex, depthOnly, ambient: ambientUniform, occlusion, onChange }),
    );
  }

  return {
    plan: (master, item, depthFirst, own) => {
      if (!('isMesh' in master) || !item.techniques?.length) return null;
      const found = materialsOf(master).map((part) => techniqueFor(part, item));
      const passes = Math.max(...found.map((technique) => technique?.passes.length ?? 0));
      if (passes === 0) return null;
      const features = programFeatures(master);
      const draw = (passIndex: number, depthOnly: boolean): Material | Material[] =>
        mapMaterials(master, (part) => {
          const technique = techniqueFor(part, item);
          if (!technique) return passIndex === 0 && !depthOnly ? own(part) : NOTHING;
          return passIndex < technique.passes.length ? twinOf(part, features, technique, passIndex, depthOnly) : NOTHING;
        });
      const plans: ProxyPlan[] = [];
      for (let i = 0; i < passes; i++) {
        plans.push({ material: draw(i, false), renderOrder: master.renderOrder });
        // A fading surface lets through what is already drawn; with its depth first, that is never a surface behind it.
        if (occlusion && !materialsOf(master).some((part) => part.transparent))
          plans.push({ material: draw(i, true), renderOrder: depthFirst, shows: occlusion.isSoft });
      }
      return plans;
    },
    update: () => {
      ambientUniform.value.setScalar(ambient.value);
    },
  };
}

function techniqueFor({ name }: Material, { techniques = [] }: ObjectItem): TechniqueView | null {
  for (let i = techniques.length - 1; i >= 0; i--) {
    const applied = techniques[i];
    if (applied && (applied.materials === null || applied.materials.includes(name))) return applied.technique;
  }
  return null;
}
