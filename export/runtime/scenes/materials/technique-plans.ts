import { type IUniform, Material, type Mesh, type Scene, Vector2 } from 'three';
import type { DrawView } from '../../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../../nodes/kit/scene-lists.ts';
import type { TechniqueView } from '../../../../nodes/kit/technique-view.ts';
import { type Drawable, mapMaterials, materialsOf, programFeatures } from '../proxies/drawable.ts';
import type { ProxyPlan } from '../proxies/proxy.ts';
import { createCurvatureNeeds } from './curvature/curvature-needs.ts';
import { type EdgeGeometry, edgeGeometryOf } from './edges/edge-geometry.ts';
import { ensureHullNormals } from './hull-normals.ts';
import { isSeenFromInside } from './inward-surface.ts';
import { isTransmissive } from './layer-blending.ts';
import type { OcclusionPatch } from './occlusion-patch.ts';
import { createEnvironmentUniforms } from './technique-environment.ts';
import { createTechniqueTwin } from './technique-twin.ts';
import { createTechniqueUniforms, type TechniqueUniforms } from './technique-uniforms.ts';
import { showsBehind } from './technique-wrapper.ts';
import type { TranslucentShadowPatch } from './translucent-shadow-patch.ts';
import type { TwinCache } from './twins.ts';

/** Creates the proxy plans of meshes that techniques draw, and updates the uniforms of these techniques. */
export interface TechniquePlans {
  /** Returns the plans of a mesh; null if no technique applies. `own` creates the material of parts to which no technique applies. */
  plan(master: Drawable, item: ObjectItem, depthFirst: number, own: (part: Material) => Material): readonly ProxyPlan[] | null;
  /** Disposes techniques that no `plan` has requested since the last call. */
  sweep(): void;
  /** Whether any technique is in use. */
  isUsed(): boolean;
  /** Applies this frame's values of the techniques' params. */
  update(): void;
  /** Applies the environment of the scene. Call it after the scene's environment was updated. */
  light(scene: Scene): void;
  /** Applies values of the view; called before every draw. */
  bind(view: DrawView): void;
}

export interface TechniquePlansOptions {
  readonly twins: TwinCache;
  readonly occlusion: OcclusionPatch | null;
  readonly translucentShadows: TranslucentShadowPatch;
  readonly onChange: () => void;
  /** GLSL and uniforms for techniques that read what is behind their objects; null where the page has none. */
  readonly behind: { readonly text: string; readonly uniforms: Readonly<Record<string, IUniform>> } | null;
}

/** Text in the vertex stage of techniques that read hull normals, which are computed only for these. */
const OUTWARD = '.outward';

/**
 * Added to the render order per pass, so that the first pass of all objects is drawn before the second of any: hulls are then mostly
 * hidden, and transparent passes find their background drawn.
 */
const PASS_AFTER_PASS = 1e-3;

/** Material of parts that a pass does not draw; three.js skips invisible materials. */
const NOTHING = new Material();
NOTHING.visible = false;

export function createTechniquePlans({ twins, occlusion, translucentShadows, onChange, behind }: TechniquePlansOptions): TechniquePlans {
  const environment = createEnvironmentUniforms();
  const renderSize: IUniform<Vector2> = { value: new Vector2(1, 1) };
  const ofScene = { ...environment.uniforms, ...behind?.uniforms, a_RENDERSIZE: renderSize };
  const curvature = createCurvatureNeeds();
  const ofTechniques = new Map<TechniqueView, { readonly key: string } & TechniqueUniforms>();

  const used = new Set<TechniqueView>();

  function uniformsOf(technique: TechniqueView): TechniqueUniforms {
    used.add(technique);
    const known = ofTechniques.get(technique);
    if (known?.key === technique.key) return known;
    const made = { key: technique.key, ...createTechniqueUniforms(technique) };
    // Plans are created after the values of the frame were set.
    made.update();
    ofTechniques.set(technique, made);
    return made;
  }

  function twinOf(
    part: Material,
    features: string,
    technique: TechniqueView,
    passIndex: number,
    depthOnly: boolean,
    edges: EdgeGeometry | null = null,
  ): Material {
    const variant = `${features}|${technique.key}|${passIndex}${depthOnly ? '|depth' : ''}${edges ? `|edges ${edges.id}` : ''}`;
    const shared = { ...ofScene, ...uniformsOf(technique).uniforms };
    return twins.get(part, variant, () =>
      createTechniqueTwin(part, {
        technique,
        passIndex,
        edges,
        depthOnly,
        shared,
        behind: behind?.text ?? '',
        occlusion,
        translucentShadows,
        onChange,
      }),
    );
  }

  return {
    plan: (master, item, depthFirst, own) => {
      if (!('isMesh' in master) || !item.techniques?.length) return null;
      const found = materialsOf(master).map((part) => techniqueFor(part, item));
      const passes = Math.max(...found.map((technique) => technique?.passes.length ?? 0));
      if (passes === 0) return null;
      const edges = edgesOf(master, found);
      const isDrawn = (technique: TechniqueView, passIndex: number, part?: Material): boolean => {
        const pass = technique.passes[passIndex];
        if (pass === undefined || pass.side === 'edges') return false;
        return !(part && pass.side === 'back' && technique.vertex.includes(OUTWARD) && isSeenFromInside(master.geometry, part.side));
      };
      if (found.some((technique) => technique?.passes.some((_, i) => isDrawn(technique, i)) && technique.vertex.includes(OUTWARD)))
        ensureHullNormals(master.geometry);
      for (const technique of found) if (technique) curvature.add(master, technique);
      const features = programFeatures(master);
      const draw = (passIndex: number, depthOnly: boolean): Material | Material[] =>
        mapMaterials(master, (part) => {
          const technique = techniqueFor(part, item);
          if (!technique) return passIndex === 0 && !depthOnly ? own(part) : NOTHING;
          return isDrawn(technique, passIndex, part) ? twinOf(part, features, technique, passIndex, depthOnly) : NOTHING;
        });
      const plans: ProxyPlan[] = [];
      const isGlass =
        behind !== null && materialsOf(master).some((part, i) => (found[i] ? showsBehind(found[i].fragment) : isTransmissive(part)));
      for (let i = 0; i < passes; i++) {
        const renderOrder = master.renderOrder + i * PASS_AFTER_PASS;
        for (const [technique, { geometry, part, ...drawn }] of edges) {
          const pass = technique.passes[i];
          if (pass?.side !== 'edges' || (pass.open && !drawn.isOpen)) continue;
          const material = twinOf(part, features, technique, i, false, { geometry, ...drawn });
          plans.push({ material, geometry, renderOrder, isGlass: behind !== null && showsBehind(technique.fragment) });
        }
        if (!found.some((technique, part) => (technique ? isDrawn(technique, i, materialsOf(master)[part]) : i === 0))) continue;
        plans.push({ material: draw(i, false), renderOrder, isGlass });
        // Glass shows what is behind it.
        if (isGlass) continue;
        // A fading surface shows what is already drawn; drawing its depth first prevents that this is a surface behind it.
        if (occlusion && !materialsOf(master).some((part) => part.transparent))
          plans.push({ material: draw(i, true), renderOrder: depthFirst, shows: occlusion.isSoft });
      }
      return plans;
    },
    sweep: () => {
      for (const technique of ofTechniques.keys()) if (!used.has(technique)) ofTechniques.delete(technique);
      used.clear();
      curvature.sweep();
    },
    isUsed: () => ofTechniques.size > 0,
    light: (scene) => environment.update(scene),
    update: () => {
      curvature.update();
      for (const { update } of ofTechniques.values()) update();
    },
    bind: (view) => {
      renderSize.value.set(view.viewport.widthPx, view.viewport.heightPx);
      for (const { bind } of ofTechniques.values()) bind(view);
    },
  };
}

/** The edges of a mesh and a material that they have in common, by the techniques that draw its edges. */
function edgesOf(master: Mesh, found: readonly (TechniqueView | null)[]): Map<TechniqueView, EdgeGeometry & { readonly part: Material }> {
  const edges = new Map<TechniqueView, EdgeGeometry & { readonly part: Material }>();
  const parts = materialsOf(master);
  for (const [i, technique] of found.entries()) {
    const part = parts[i];
    const passes = technique?.passes.filter(({ side }) => side === 'edges') ?? [];
    if (!technique || !part || edges.has(technique) || passes.length === 0) continue;
    // A single material is that of all groups.
    const isUsed = (group: number): boolean => !Array.isArray(master.material) || found[group] === technique;
    const made = edgeGeometryOf(
      master,
      isUsed,
      passes.every(({ open }) => open),
    );
    if (made) edges.set(technique, { ...made, part });
  }
  return edges;
}

function techniqueFor({ name }: Material, { techniques = [] }: ObjectItem): TechniqueView | null {
  for (let i = techniques.length - 1; i >= 0; i--) {
    const applied = techniques[i];
    if (applied && (applied.materials === null || applied.materials.includes(name))) return applied.technique;
  }
  return null;
}
