import { BackSide, DoubleSide, FrontSide, Material, Scene } from 'three';
import type { LayerEncoding } from '../../../nodes/kit/definition.ts';
import type { DrawnScene } from '../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import type { NumberView } from '../../../nodes/kit/value-views.ts';
import type { NeutralEnvironment } from './environments/neutral.ts';
import type { PanoramaStore } from './environments/panorama-store.ts';
import { createSceneEnvironment } from './environments/scene-environment.ts';
import type { Glass } from './glass/glass-scene.ts';
import type { LightLimits, TextureLimits } from './lights/light-limits.ts';
import { createLightRig } from './lights/light-rig.ts';
import type { RenderedShadowMaps } from './lights/shadow-maps.ts';
import { blendsWithoutDepth, createDepthTwin } from './materials/depth-twin.ts';
import { isOpaque, isTransmissive } from './materials/layer-blending.ts';
import { createLayerTwin, type LayerTwinOptions } from './materials/layer-twin.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import type { ShaderPatch } from './materials/shader-patch.ts';
import { createTechniquePlans } from './materials/technique-plans.ts';
import { createTranslucentShadowPatch } from './materials/translucent-shadow-patch.ts';
import { createTwinCache } from './materials/twins.ts';
import { type Drawable, mapMaterials, materialsOf, programFeatures } from './proxies/drawable.ts';
import type { ProxyPlan } from './proxies/proxy.ts';
import { createProxySet } from './proxies/proxy-set.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createViewCamera } from './view-camera.ts';

export interface ShadedSceneOptions {
  readonly renderer: SceneRenderer;
  readonly neutral: NeutralEnvironment;
  readonly panoramas: PanoramaStore;
  /** Brightness of the neutral environment; with 1 it alone renders a white matte surface white. */
  readonly ambient: NumberView;
  /** Encoding of the layer. */
  readonly encoding: LayerEncoding;
  readonly shadowMaps: RenderedShadowMaps | null;
  readonly occlusion: OcclusionPatch | null;
  /** Effects that materials compute at their end; null for none. */
  readonly effects: ShaderPatch | null;
  /** Draws glass; null where the page has none. */
  readonly glass: Glass | null;
  readonly watchLimits: LightLimits;
  readonly textureLimits: TextureLimits;
}

/**
 * Render orders. Phantoms come first, so that hidden fragments cost nothing; then the depth of surfaces that fade at a soft border; last
 * the depth of blended materials, for readers of the layer's depth.
 */
const PHANTOMS_FIRST = -2e9;
const DEPTH_FIRST = -1e9;
const BLENDED_DEPTH_LAST = 1e9;

type Side = LayerTwinOptions['side'];

/** Creates a scene that draws virtual objects with their own materials, lights and shadows, and the depth of phantoms. */
export function createShadedScene(options: ShadedSceneOptions): DrawnScene {
  const { renderer, encoding, shadowMaps, occlusion, effects, watchLimits, textureLimits } = options;
  const scene = new Scene();
  scene.matrixWorldAutoUpdate = false;
  const view = createViewCamera();
  const lights = createLightRig(scene);
  const translucentShadows = createTranslucentShadowPatch();
  const { maxTextures } = renderer.three.capabilities;
  const surroundings = createSceneEnvironment({ ...options, scene });
  const twins = createTwinCache();
  const proxies = createProxySet(scene, plan);
  let outdated = false;
  let lit = false;
  const onChange = (): void => {
    outdated = true;
  };
  const glass = options.glass?.forScene(scene, encoding) ?? null;
  const layerOptions = { encoding, occlusion, effects, translucentShadows, onChange, patchGlass: glass?.patch ?? null };
  const techniques = createTechniquePlans({ twins, translucentShadows, occlusion, onChange, behind: glass?.forTechniques ?? null });

  function plan(master: Drawable, item: ObjectItem): readonly ProxyPlan[] {
    const features = programFeatures(master);
    const depth = (): Material | Material[] =>
      mapMaterials(master, (part) => twins.get(part, `${features}|depth`, () => createDepthTwin(part, 'surface')));
    if (item.role === 'phantom') return [{ material: depth(), renderOrder: PHANTOMS_FIRST }];
    const twin = (part: Material, side: Side): Material =>
      twins.get(part, `${features}|${side ?? ''}${isTransmissive(part) ? '|glass' : ''}`, () =>
        createLayerTwin(part, { side, ...layerOptions }),
      );
    const byTechnique = techniques.plan(master, item, DEPTH_FIRST, (part) => twin(part, null));
    if (byTechnique) return byTechnique;
    const isGlass = glass !== null && materialsOf(master).some(isTransmissive);
    const draw = (side: Side, shown: (part: Material) => boolean = () => true): ProxyPlan => ({
      material: mapMaterials(master, (part) => (shown(part) ? twin(part, side) : NOTHING)),
      renderOrder: master.renderOrder,
      isGlass: isGlass && materialsOf(master).some((part) => isTransmissive(part) && shown(part)),
    });
    const solid = (part: Material): boolean => !isTransmissive(part);
    // The back of glass is drawn first, so that the front shows it.
    const colors = isTwoPass(master.material, isGlass)
      ? [draw(BackSide), draw(FrontSide)]
      : isGlass && materialsOf(master).some(solid)
        ? [draw(null, solid), draw(null, isTransmissive)]
        : [draw(null)];
    if (materialsOf(master).some(blendsWithoutDepth)) return [...colors, blendedDepth(master, features)];
    if (!occlusion || !materialsOf(master).every(isOpaque)) return colors;
    // A fading surface shows what is already drawn; drawing its depth first prevents that this is a surface behind it.
    return [{ material: depth(), renderOrder: DEPTH_FIRST, shows: occlusion.isSoft }, ...colors];
  }

  function blendedDepth(master: Drawable, features: string): ProxyPlan {
    const material = mapMaterials(master, (part) =>
      twins.get(part, `${features}|blended depth`, () => createDepthTwin(part, 'blended', occlusion)),
    );
    return { material, renderOrder: BLENDED_DEPTH_LAST };
  }

  return {
    update: (objects, lightLists) => {
      techniques.update();
      twins.sync();
      if (proxies.update(objects, outdated)) {
        outdated = false;
        twins.sweep();
        techniques.sweep();
        glass?.collect(proxies.proxies, BLENDED_DEPTH_LAST);
        lit = techniques.isUsed() || proxies.proxies.some(({ object }) => materialsOf(object).some(isLit));
      }
      watchLimits(lightLists);
      surroundings.update(lightLists, lit);
      techniques.light(scene);
      lights.update(lightLists);
    },
    draw: (drawView) => {
      view.set(drawView.view);
      textureLimits.tell(0, lights.bindShadows(shadowMaps, translucentShadows, maxTextures));
      occlusion?.bind(drawView);
      techniques.bind(drawView);
      if (glass?.hasGlass()) glass.draw(drawView, view.camera);
      else renderer.draw(drawView, scene, view.camera, encoding);
    },
    dispose: () => {
      glass?.dispose();
      proxies.dispose();
      twins.dispose();
      lights.dispose();
      surroundings.dispose();
    },
  };
}

/** Whether a material needs two passes, back faces first. three.js would recompile it between the passes; a proxy per side avoids that. */
function isTwoPass(material: Material | Material[], isGlass: boolean): boolean {
  if (Array.isArray(material) || material.side !== DoubleSide) return false;
  return isGlass || (material.transparent && !material.forceSinglePass);
}

/** Material of parts that another proxy draws; three.js skips invisible materials. */
const NOTHING = new Material();
NOTHING.visible = false;

const LIT = ['isMeshStandardMaterial', 'isMeshLambertMaterial', 'isMeshPhongMaterial'] as const;

function isLit(material: Material): boolean {
  return LIT.some((kind) => kind in material);
}
