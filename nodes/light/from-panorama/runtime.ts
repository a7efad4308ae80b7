import type { DerivedEnvironment, EnvironmentAsset } from '../../kit/assets.ts';
import { type FoundLamp, type FoundLamps, NO_LAMPS } from '../../kit/panorama/found-lamps.ts';
import { lampOptionsOf } from '../../kit/panorama/lamp-options.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { EnvironmentLightItem } from '../../kit/scene-lists.ts';
import { createClippedLamps } from './clipped-lamps.ts';
import type { definition } from './definition.ts';
import { kindOf, lampChanges } from './lamp-changes.ts';
import { createLampItem, directional, type LampItem, type LampKind, type LampSetting, MAX_SIZE_RAD, turn } from './lamp-items.ts';
import { type LampSearch, startLampSearch } from './lamp-search.ts';
import { createRoomDistances } from './room-distances.ts';

/** The shadow map of the rest of the panorama, which is a wide light and needs no large map. */
const REST_MAP = { mapSizePx: 512, filter: 'pcss' } as const;

/** A lamp of the output list, as it was found, with its current direction and light. */
interface Listed {
  readonly kind: LampKind;
  readonly found: FoundLamp;
  readonly towards: [x: number, y: number, z: number];
  readonly irradiance: [red: number, green: number, blue: number];
  readonly item: LampItem;
}

// Written and read within one call.
const scratchTowards = new Float32Array(3);

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
  /** What was found, until it can be listed. */
  let waiting: FoundLamps | null = null;
  let rest: DerivedEnvironment | null = null;
  let lamps: Listed[] = [];
  let restShadow: LampItem | null = null;
  const changes = lampChanges(params);
  const clippedLamps = createClippedLamps(ctx.session, config.clippedFrom === 'estimate');
  const distances = createRoomDistances(ctx.session, config.distanceFrom === 'room');

  function forget(): void {
    search?.dispose();
    search = null;
    found = null;
    waiting = null;
    rest?.dispose();
    rest = null;
    listLamps();
  }

  function take(result: FoundLamps): void {
    search = null;
    waiting = result;
    if (searched && result.lamps.length > 0) rest = searched.withoutLamps(result.runs, result);
    if (result.none !== null) {
      ctx.report({
        code: 'SCR028',
        severity: 'info',
        message: `The whole panorama lights the scene, because no lamp was found in it: ${NO_LAMPS[result.none]}.`,
        fix: 'Use a panorama in which lamps or windows are visible, or another “Method”.',
      });
    }
    if ((result.more ?? 0) > result.lamps.length) {
      ctx.report({
        code: 'SCR028',
        severity: 'info',
        message: `Of more than ${result.lamps.length + (result.more ?? 0) - 1} lamps that are about as bright, ${result.lamps.length} are lights with shadows. The others light from all sides.`,
        fix: 'Raise “Lamps”, or use a panorama in which few lamps stand out.',
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
  }

  /** Lists the lamps once the panorama without them can be drawn: before, their light would count twice. */
  function listWhenReady(): void {
    if (!waiting || rest?.ready === false) return;
    found = waiting;
    waiting = null;
    listLamps();
  }

  /**
   * Returns the result of the search when it is there, null before. If the search has failed, reports that; the whole panorama then lights
   * the scene.
   */
  function arrived(): FoundLamps | null {
    try {
      return search?.take() ?? null;
    } catch (error) {
      search = null;
      ctx.report({
        code: 'SCR028',
        severity: 'warning',
        message: `The whole panorama lights the scene, because it could not be searched for lamps: ${String((error as Error).message).replace(/\.$/, '')}.`,
        fix: 'Reload the page, or use a smaller panorama.',
      });
      return null;
    }
  }

  function listLamps(): void {
    lamps = (found?.lamps ?? []).map((lamp, i): Listed => {
      const kind = kindOf(params.kind.value, changes[i]);
      const towards: [number, number, number] = [...lamp.towards];
      const irradiance: [number, number, number] = [...lamp.irradiance];
      const item = createLampItem(`lamp ${i + 1}`, kind, { ...lamp, towards, irradiance }, map);
      return { kind, found: lamp, towards, irradiance, item };
    });
    const areFar = lamps.length > 0 && lamps.every(({ kind }) => kind === 'directional');
    const wide = areFar ? (found?.rest ?? null) : null;
    restShadow = wide ? directional('shadow of the rest', { ...wide, sizeRad: MAX_SIZE_RAD }, REST_MAP, true) : null;
    lights.items.length = 0;
    for (const { item } of lamps) lights.items.push(item.item);
    if (restShadow) lights.items.push(restShadow.item);
    lights.items.push(around);
    lights.version++;
  }

  function haveOtherKinds(): boolean {
    for (let i = 0; i < lamps.length; i++) if (lamps[i]?.kind !== kindOf(params.kind.value, changes[i])) return true;
    return false;
  }

  function updateLamps(panoramaIntensity: number): void {
    setting.intensity = params.intensity.value * panoramaIntensity;
    setting.rotationRad = around.rotationRad;
    setting.centerWorld = params.centerM.value;
    setting.castShadow = params.castShadow.value;
    setting.softness = params.softness.value;
    setting.areaM = params.areaM.value;
    setting.biasPx = params.biasPx.value;
    for (let i = 0; i < lamps.length; i++) {
      const lamp = lamps[i];
      if (!lamp) continue;
      const change = changes[i];
      if (change?.pinned.value) writeDirection(lamp.towards, change.azimuthRad.value, change.elevationRad.value);
      else for (let c = 0; c < 3; c++) lamp.towards[c] = lamp.found.towards[c] ?? 0;
      clippedLamps.write(lamp.irradiance, lamp.found);
      setting.distanceM = change && change.distanceM.value > 0 ? change.distanceM.value : params.distanceM.value;
      if (lamp.kind !== 'directional' && !(change && change.distanceM.value > 0)) {
        turn(scratchTowards, lamp.towards, setting.rotationRad);
        setting.distanceM = distances.along(i, setting.centerWorld, scratchTowards) ?? setting.distanceM;
      }
      lamp.item.update(setting);
    }
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
        if (asset) search = startLampSearch(asset, lampOptionsOf(config), ctx.workers, ctx.clock.held);
      }
      const result = arrived();
      if (result) take(result);
      if (waiting) listWhenReady();
      else if (haveOtherKinds()) listLamps();
      around.environment = rest?.ready ? rest : asset;
      around.intensity = params.ambient.value * intensity;
      around.rotationRad = params.rotationRad.value + (environment?.rotationRad ?? 0);
      around.visible = params.visible.value;
      clippedLamps.update(found);
      updateLamps(intensity);
      passedOn.asset = asset;
      passedOn.intensity = intensity;
      passedOn.rotationRad = environment?.rotationRad ?? 0;
    },
    dispose: () => {
      search?.dispose();
      rest?.dispose();
    },
  };
}

function writeDirection(into: [number, number, number], azimuthRad: number, elevationRad: number): void {
  into[0] = Math.sin(azimuthRad) * Math.cos(elevationRad);
  into[1] = Math.sin(elevationRad);
  into[2] = Math.cos(azimuthRad) * Math.cos(elevationRad);
}
