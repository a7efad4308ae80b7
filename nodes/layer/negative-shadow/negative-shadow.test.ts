import { expect, test } from '@jest/globals';
import { BoxGeometry, Group, Matrix4, Mesh } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { DirectionalLightItem, LightList, ObjectList, PointLightItem } from '../../kit/scene-lists.ts';
import type { ShadowCatcherLook } from '../../kit/scene-look.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** A box of 0.6 × 1 × 0.8 m on a table at 0.7 m. */
function boxOnTable(): ObjectList {
  const root = new Group().add(new Mesh(new BoxGeometry(0.6, 1, 0.8)));
  root.updateMatrixWorld(true);
  const worldFromObject = new Matrix4().makeTranslation(1, 1.2, -2);
  return { version: 1, items: [{ key: 'box', root, worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true }] };
}

function sun(azimuthRad: number, elevationRad: number, more: Partial<DirectionalLightItem> = {}): DirectionalLightItem {
  const [horizontal, up] = [Math.cos(elevationRad), Math.sin(elevationRad)];
  return {
    key: 'sun',
    kind: 'directional',
    radiance: new Float32Array(3).fill(1),
    towardsLightWorld: Float32Array.of(horizontal * Math.sin(azimuthRad), up, horizontal * Math.cos(azimuthRad)),
    shadow: null,
    ...more,
  };
}

function make(items: LightList['items'], blend: string, params = {}, cameraMean: Float32Array | null = null) {
  let look: ShadowCatcherLook | null = null;
  const scenes = {
    createScene: (wanted: ShadowCatcherLook) => {
      look = wanted;
      return { update: () => {}, draw: () => {}, dispose: () => {} };
    },
  };
  const lights: LightList[] = [{ version: 1, items }];
  const inputs = { casters: [boxOnTable()], receivers: [], lights };
  const services = { scenes: scenes as never, session: { blend, cameraMean } as never };
  const { ctx, set, reports } = fakeContext(definition, { params: { margin: 0, maxStretchM: 1.5, ...params }, inputs, services });
  const node = create(ctx);
  node.update({} as never);
  const { glow, strength } = look as unknown as Required<ShadowCatcherLook>;
  return { node, set, reports, glow, strength, item: inputs.casters[0]?.items[0] };
}

test('under a light from straight above, the light is a circle around the object on its base', () => {
  const { glow } = make([sun(0, Math.PI / 2)], 'additive');
  expect([glow.on, glow.count]).toEqual([true, 1]);
  const [x, z] = glow.places;
  const [longer, shorter, height] = glow.sizes;
  expect([x, z, longer, shorter, height]).toEqual([1, -2, 0.5, 0.5, 0.7].map((n) => expect.closeTo(n, 5)));
});

test('it stretches away from the light by half of h·cot(e), and keeps its width', () => {
  // From the right at 45°: the shadow of 1 m falls to the left.
  const { glow } = make([sun(Math.PI / 2, Math.PI / 4)], 'additive');
  expect([...glow.places.slice(0, 4)]).toEqual([1 - 0.5, -2, -1, 0].map((n) => expect.closeTo(n, 5)));
  expect([...glow.sizes.slice(0, 2)]).toEqual([0.5 + 0.5, 0.5].map((n) => expect.closeTo(n, 5)));
});

test('a low light stretches it up to the maximum; a light below the ground adds none', () => {
  const { glow } = make([sun(0, 0.1), sun(0, -0.5)], 'additive');
  expect([glow.count, glow.sizes[0]]).toEqual([1, expect.closeTo(0.5 + 0.75, 5)]);
});

test('each light has a spot, by its direction from the object; ambient light has none', () => {
  const point: PointLightItem = {
    key: 'bulb',
    kind: 'point',
    intensityCd: new Float32Array(3),
    positionWorld: Float32Array.of(1, 1.7, -3),
    rangeM: 0,
    shadow: null,
  };
  const { glow } = make([sun(0, 1), point, sun(0, 1, { onlyShadows: true })], 'additive');
  expect(glow.count).toBe(2);
  // The bulb is behind the object at 45°: the shadow falls to the front.
  expect([...glow.places.slice(4, 8)]).toEqual([1, -2 + 0.5, 0, 1].map((n) => expect.closeTo(n, 5)));
});

test('an object that is hidden or casts no shadow has none, from the frame on in which that changes', () => {
  const { glow, node, item } = make([sun(0, 1)], 'additive');
  const counts = [{ hidden: true }, { hidden: false }, { castsShadow: false }].map((change) => {
    Object.assign(item ?? {}, change);
    node.update({} as never);
    return glow.count;
  });
  expect(counts).toEqual([0, 1, 0]);
});

test('on displays that can darken it is an ordinary shadow with its own strength', () => {
  const { glow, strength, reports } = make([sun(0, 1)], 'alpha');
  expect([glow.on, strength.value]).toEqual([false, 0.5]);
  expect(reports).toEqual([expect.objectContaining({ code: 'SCR015', port: 'receivers' })]);
  expect(make([sun(0, 1)], 'additive').strength.value).toBe(1);
});

test('warns where a shadow is less than two levels of 8 bits darker than its surroundings: by its base, or by the room', () => {
  const faint = (params: object, room: number | null = null, blend = 'additive') =>
    make([sun(0, 1)], blend, params, room === null ? null : new Float32Array(3).fill(room)).reports.some(({ code }) => code === 'SCR049');
  expect([faint({}), faint({ base: [0.003, 0.003, 0.003, 1] }), faint({ depthOfShadow: 0.05 })]).toEqual([false, true, true]);
  // Linear 2 × 0.0045 on a room of 0.05 are 5.4 levels of sRGB, on a room of 0.6 are 1.3.
  expect([faint({}, 0.05), faint({}, 0.6), faint({}, 0.6, 'alpha')]).toEqual([false, true, false]);
});
