import {
  BoxGeometry,
  DataTexture,
  Mesh,
  MeshLambertMaterial,
  MeshPhysicalMaterial,
  type MeshPhysicalMaterialParameters,
  PlaneGeometry,
} from 'three';
import type { ShadowFilter } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/runtime.ts';
import { bulb, item, lookingAt, pixel, spot, sun, translation } from '../browser/scenes-kit.ts';
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

/** Of a pane close above the floor: by height in metres, with a box beside the lamp, which throws no shadow there, and without. */
export function lowPanes(kind: 'sun' | 'spot' | 'bulb', heights: readonly number[]) {
  const material = new MeshLambertMaterial({ transparent: true, opacity: 0.75 });
  const box = thing(new BoxGeometry(0.05, 0.05, 0.05), { at: translation(0.05, LAMP_M, 0) });
  return heights.map((heightM) => {
    const pane = thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { material, at: translation(0, heightM, 0) });
    return [underLamp(kind, 'soft', pane, box), underLamp(kind, 'soft', pane)];
  });
}

/** Of a solid plate so far below the lamp: by distance in metres, alone, and with another on the way to the floor. */
export function closeToLamp(filter: ShadowFilter, distances: readonly number[]) {
  const solid = (heightM: number): ObjectItem =>
    thing(new PlaneGeometry(0.6, 0.6).rotateX(-Math.PI / 2), { at: translation(0, heightM, 0) });
  const aside = (heightM: number): ObjectItem => thing(new BoxGeometry(0.01, 0.01, 0.01), { at: translation(0.05, heightM, 0) });
  return distances.map((distanceM) => [
    underLamp('spot', filter, solid(LAMP_M - distanceM)),
    underLamp('spot', filter, solid(0.3), aside(LAMP_M - distanceM)),
  ]);
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
