import type { DerivedEnvironment, EnvironmentAsset } from '../../kit/assets.ts';
import { choiceIndex } from '../../kit/choice-options.ts';
import { type FoundLamps, NO_LAMPS } from '../../kit/panorama/found-lamps.ts';
import { findByPaper } from '../../kit/panorama/paper-method.ts';
import type { PanoramaPixels } from '../../kit/panorama/pixels.ts';
import { findBySolidAngle } from '../../kit/panorama/solid-angle-method.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { EnvironmentLightItem } from '../../kit/scene-lists.ts';
import type { definition } from './definition.ts';
import { createLampItem, directional, type LampItem, type LampSetting, MAX_SIZE_RAD } from './lamp-items.ts';
import { createLampSearch, type LampSearch } from './lamp-search.ts';

const KINDS = ['directional', 'spot', 'point'] as const;

/** A wide light needs no large map. */
const REST_MAP = { mapSizePx: 512, filter: 'pcss' } as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { params, config } = ctx;
  const { lights, environment: passedOn } = ctx.outputs;
  const map = { mapSizePx: Number(config.mapSize), filter: config.filter };
  const around: EnvironmentLightItem = {
    key: 'rest',
    kind: 'environment',
    environment: null,
    intensity: 0,
    rotationRad: 0,
    visible: false,
  };
  const setting: LampSetting = {
    intensity: 0,
    rotationRad: 0,
    distanceM: 0,
    centerWorld: params.centerM.value,
    castShadow: false,
    softness: 0,
    areaM: 0,
    biasPx: 0,
  };
  let searched: EnvironmentAsset | null = null;
  let search: LampSearch | null = null;
  let found: FoundLamps | null = null;
  let rest: DerivedEnvironment | null = null;
  let lamps: LampItem[] = [];
  let restShadow: LampItem | null = null;
  let kind: (typeof KINDS)[number] | null = null;

  function find(pixels: PanoramaPixels): Generator<undefined, FoundLamps> {
    const { lamps, iterations, intensities, clippedShare } = config;
    return config.method === 'paper'
      ? findByPaper(pixels, { lamps, iterations, intensities })
      : findBySolidAngle(pixels, { lamps, clippedShare });
  }

  function forget(): void {
    search = null;
    found = null;
    rest?.dispose();
    rest = null;
    listLamps();
  }

  function take(result: FoundLamps): void {
    found = result;
    search = null;
    if (searched && result.lamps.length > 0) rest = searched.withoutLamps(result.runs, result);
    if (result.none !== null) {
      ctx.report({
        code: 'SCR028',
        severity: 'info',
        message: `The whole panorama lights the scene, because no lamp was found in it: ${NO_LAMPS[result.none]}.`,
        fix: 'Use a panorama in which lamps or windows are visible, or another “Method”.',
      });
    }
    if (result.damaged > 0) {
      ctx.report({
        code: 'SCR029',
        severity: 'warning',
        message: `${result.damaged} pixels of the panorama have no valid brightness. They count as black, or as the brightest possible.`,
        fix: 'Export the panorama again without infinite or negative numbers.',
      });
    }
    listLamps();
  }

  function listLamps(): void {
    kind = KINDS[choiceIndex(params.kind.value, KINDS.length)] ?? 'directional';
    lamps = (found?.lamps ?? []).map((lamp, i) => createLampItem(`lamp ${i + 1}`, kind ?? 'directional', lamp, map));
    const wide = found?.rest && kind === 'directional' && lamps.length > 0 ? found.rest : null;
    restShadow = wide ? directional('shadow of the rest', { ...wide, sizeRad: MAX_SIZE_RAD }, REST_MAP, true) : null;
    lights.items.length = 0;
    for (const { item } of lamps) lights.items.push(item);
    if (restShadow) lights.items.push(restShadow.item);
    lights.items.push(around);
    lights.version++;
  }

  function updateLamps(panoramaIntensity: number): void {
    setting.intensity = params.intensity.value * panoramaIntensity;
    setting.rotationRad = around.rotationRad;
    setting.distanceM = params.distanceM.value;
    setting.centerWorld = params.centerM.value;
    setting.castShadow = params.castShadow.value;
    setting.softness = params.softness.value;
    setting.areaM = params.areaM.value;
    setting.biasPx = params.biasPx.value;
    for (let i = 0; i < lamps.length; i++) lamps[i]?.update(setting);
    setting.softness = 1;
    setting.biasPx = 1;
    setting.intensity = params.contact.value * params.ambient.value * panoramaIntensity;
    restShadow?.update(setting);
  }

  listLamps();
  return {
    update: () => {
      const { environment } = ctx.inputs;
      const asset = environment?.asset ?? null;
      const intensity = environment?.intensity ?? 0;
      if (asset !== searched) {
        forget();
        searched = asset;
        if (asset) search = createLampSearch(asset, find);
      }
      const result = search?.step(ctx.clock.held) ?? null;
      if (result) take(result);
      else if (KINDS[choiceIndex(params.kind.value, KINDS.length)] !== kind) listLamps();
      around.environment = rest ?? asset;
      around.intensity = params.ambient.value * intensity;
      around.rotationRad = params.rotationRad.value + (environment?.rotationRad ?? 0);
      around.visible = params.visible.value;
      updateLamps(intensity);
      passedOn.asset = asset;
      passedOn.intensity = intensity;
      passedOn.rotationRad = environment?.rotationRad ?? 0;
    },
    dispose: () => rest?.dispose(),
  };
}
