import {
  BoxGeometry,
  DataTexture,
  Mesh,
  MeshLambertMaterial,
  MeshPhysicalMaterial,
  type MeshPhysicalMaterialParameters,
  PlaneGeometry,
} from 'three';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ShadowFilter } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import {
  bulb,
  createStand,
  drawView,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  spot,
  sun,
  translation,
  viewOf,
} from '../browser/scenes-kit.ts';
import { desk, SIDES, shoot, stand, thing } from '../browser/shadow-kit.ts';

/** Straight down from 2 m. */
const ABOVE = lookingAt([0, 2, 1e-3], [0, 0, 0]);
const LAMP_M = 2.2;

/** Alpha on the floor under the middle of casters, in a light with a box of 5 cm at the lamp. */
function underLamp(kind: 'sun' | 'spot' | 'bulb', filter: ShadowFilter, ...casters: ObjectItem[]): number {
  const shadow = { mapSizePx: 1024, filter } as const;
  const light: LightItem = {
    sun: () => sun([0, 1, 0], { shadow: { ...shadow, areaM: 3, bias: 0, normalBiasM: 0.005 } }),
    spot: () => spot([0, LAMP_M, 0], [0, 0, 0], 30, { shadow: { ...shadow, biasPx: 2 }, halfAngleRad: 0.6 }),
    bulb: () => bulb([0, LAMP_M, 0], 30, { shadow: { ...shadow, biasPx: 2 } }),
  }[kind]();
  const pixels = shoot(stand, { casters, receivers: [desk()], lights: [light], method: 'map', camera: ABOVE, strength: 1 });
  return pixel(pixels, SIDES.widthPx / 2, SIDES.heightPx / 2, SIDES.widthPx)[3] ?? -1;
}

/** Of a pane close above the floor: by height in meters, with a box beside the lamp, which throws no shadow there, and without. */
export function lowPanes(kind: 'sun' | 'spot' | 'bulb', heights: readonly number[]) {
  const material = new MeshLambertMaterial({ transparent: true, opacity: 0.75 });
  const box = thing(new BoxGeometry(0.05, 0.05, 0.05), { at: translation(0.05, LAMP_M, 0) });
  return heights.map((heightM) => {
    const pane = thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { material, at: translation(0, heightM, 0) });
    return [underLamp(kind, 'soft', pane, box), underLamp(kind, 'soft', pane)];
  });
}

/** Of a solid plate so far below the lamp: by distance in meters, alone, and with another on the way to the floor. */
export function closeToLamp(filter: ShadowFilter, distances: readonly number[]) {
  const solid = (heightM: number): ObjectItem =>
    thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { at: translation(0, heightM, 0) });
  const aside = (heightM: number): ObjectItem => thing(new BoxGeometry(0.01, 0.01, 0.01), { at: translation(0.05, heightM, 0) });
  return distances.map((distanceM) => [
    underLamp('spot', filter, solid(LAMP_M - distanceM)),
    underLamp('spot', filter, solid(0.3), aside(LAMP_M - distanceM)),
  ]);
}

/** Of a solid plate close above the floor, by height in meters, with a box beside the lamp, which throws no shadow there. */
export function lowPlates(filter: ShadowFilter, heights: readonly number[]) {
  const box = thing(new BoxGeometry(0.05, 0.05, 0.05), { at: translation(0.05, LAMP_M, 0) });
  return heights.map((heightM) =>
    underLamp('spot', filter, thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { at: translation(0, heightM, 0) }), box),
  );
}

/** Of panes of glass as files have them: what is not blended, and lets light through. */
export function glass(kind: 'sun' | 'spot' | 'bulb') {
  const pane = (parameters: MeshPhysicalMaterialParameters): ObjectItem => {
    const mesh = new Mesh(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), new MeshPhysicalMaterial(parameters));
    return item(mesh, { at: translation(0, 0.5, 0) });
  };
  const dark = new DataTexture(Uint8Array.of(255, 255, 255, 0), 1, 1);
  dark.needsUpdate = true;
  return {
    clear: underLamp(kind, 'soft', pane({ transmission: 1 })),
    smoked: underLamp(kind, 'soft', pane({ transmission: 0.25 })),
    // Alpha counts where it is blended or cut alone.
    unblended: underLamp(kind, 'soft', pane({ transmission: 0.25, opacity: 0.1, map: dark })),
    blended: underLamp(kind, 'soft', pane({ transmission: 0.5, opacity: 0.5, transparent: true })),
    cut: underLamp(kind, 'soft', pane({ transmission: 0.25, alphaTest: 0.5, map: dark })),
    solid: underLamp(kind, 'soft', pane({})),
    error: stand.gl.getError(),
  };
}

/** A device with as many texture units as WebGL 2 promises, and no more. */
const fewUnits = createStand(SIDES.widthPx, SIDES.heightPx, (host) => {
  const { gl } = host;
  const read = gl.getParameter.bind(gl);
  gl.getParameter = (name: GLenum): unknown => (name === gl.MAX_TEXTURE_IMAGE_UNITS ? 16 : read(name));
  return createScenes(host);
});

/** What layers report, over two draws, for a number of lights on a transparent pane or a solid plate. */
export function manyLights(shown: 'phantoms' | 'things', filter: ShadowFilter, count: number, opacity: number) {
  const { backend, layer, gl } = fewUnits;
  const lamps = Array.from({ length: count }, (_, i) => {
    const shadow = { mapSizePx: 64, areaM: 3, bias: 0, normalBiasM: 0.01, filter } as const;
    return sun([0.02 * i, 1, 0], { radiance: 1, shadow });
  });
  const material = new MeshLambertMaterial({ transparent: opacity < 1, opacity });
  const casters = objects(
    thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { material, at: translation(0, 0.5, 0), receivesShadow: false }),
  );
  const told: string[] = [];
  const lamplight = lights(...lamps);
  const maps = backend.createShadowMaps([casters], [lamplight]);
  const report = ({ code, message }: Omit<Diagnostic, 'nodeId'>): void => void told.push(`${code} ${message}`);
  const scene = backend
    .serviceFor({ shadowMaps: maps, occlusion: null, report })
    .createScene(
      shown === 'things'
        ? { kind: 'shaded', ambient: { value: 0 } }
        : { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) }, on: 'phantoms' },
    );
  const floor = shown === 'things' ? thing(new PlaneGeometry(3, 3).rotateX(-Math.PI / 2), { castsShadow: false }) : desk();
  scene.update([objects(floor)], [lamplight]);
  maps.update();
  layer.clear();
  for (let frame = 0; frame < 2; frame++) scene.draw(drawView(viewOf(ABOVE, { x: 0, y: 0, ...SIDES }), layer.framebuffer));
  scene.dispose();
  maps.dispose();
  return { told: [...new Set(told)], error: gl.getError() };
}
