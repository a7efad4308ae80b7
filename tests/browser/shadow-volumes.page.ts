import { BoxGeometry, DataTexture, Matrix4, type Mesh, MeshLambertMaterial, SphereGeometry } from 'three';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import { bulb, drawView, item, lights, lookingAt, objects, spot, sun, translation, viewOf } from './scenes-kit.ts';
import { ABOVE, bentArm, desk, LAMP, onFloor, plate, type Shot, SIDES, SUN, shoot, stand, thing } from './shadow-kit.ts';

/**
 * Where the shadow of a plate falls that is 0.4 m square and lies 0.5 m above the floor. Light from (-1, 1, 0) moves it by its height:
 * x from 0.3 to 0.7. A lamp 2 m above the floor at x -0.5 doubles distances to it times 2 / 1.5: x from (0.3 · 4/3 - 0.5) = -0.1 to
 * (0.7 · 4/3 - 0.5) = 0.433, z to ±0.267.
 */
export function geometry() {
  const shadowOf = (light: LightItem, casters: readonly ObjectItem[], camera = ABOVE): Uint8Array =>
    shoot(stand, { casters, receivers: [desk(), ...casters], lights: [light], method: 'volume', camera });
  const sunny = sun([-1, 1, 0], { shadow: SUN });
  const inSun = {
    middle: [0.5, 0],
    inNear: [0.31, 0],
    inFar: [0.69, 0.19],
    outNear: [0.29, 0],
    outFar: [0.71, 0.19],
    beside: [0.5, 0.21],
    under: [0, 0],
  } as const;
  const inLamp = {
    middle: [0.2, 0],
    inNear: [-0.09, 0],
    inFar: [0.42, 0.25],
    outNear: [-0.11, 0],
    outFar: [0.445, 0.25],
    beside: [0.2, 0.28],
  } as const;
  const at = [-0.5, 2, 0] as const;
  // The eye stands in the shadow, between plate and floor.
  const within = lookingAt([0.3, 0.3, 0.05], [0.5, 0, 0]);
  return {
    sun: onFloor(shadowOf(sunny, [plate()]), ABOVE, inSun),
    turnedOver: onFloor(shadowOf(sunny, [plate({ at: new Matrix4().makeRotationX(Math.PI).setPosition(0, 0.5, 0) })]), ABOVE, inSun),
    bulb: onFloor(shadowOf(bulb(at, 30, { shadow: LAMP }), [plate()]), ABOVE, inLamp),
    spot: onFloor(shadowOf(spot(at, [0, 0, 0], 30, { shadow: LAMP }), [plate()]), ABOVE, inLamp),
    within: onFloor(shadowOf(sunny, [plate()], within), within, { in: [0.5, 0], on: [0.55, 0.05] }),
    mirrored: onFloor(shadowOf(sunny, [plate({ at: new Matrix4().makeScale(-1, 1, 1).setPosition(0, 0.5, 0) })]), ABOVE, inSun),
    error: stand.gl.getError(),
  };
}

/** Several lights: one of two is half a shadow; more than maps can do. */
export function lamps() {
  const left = sun([-1, 1, 0], { shadow: SUN });
  const right = sun([1, 1, 0], { shadow: SUN });
  const middle = { middle: [0.5, 0] } as const;
  const alpha = (shot: Partial<Shot>): number => {
    const pixels = shoot(stand, { casters: [plate()], receivers: [desk()], lights: [left], method: 'volume', camera: ABOVE, ...shot });
    return onFloor(pixels, ABOVE, middle).middle ?? -1;
  };
  const holes = new MeshLambertMaterial({ alphaTest: 0.5, map: new DataTexture(new Uint8Array(4).fill(255), 1, 1) });
  const told: Omit<Diagnostic, 'nodeId'>[] = [];
  const veiled: Omit<Diagnostic, 'nodeId'>[] = [];
  return {
    one: alpha({}),
    two: alpha({ lights: [left, right] }),
    oneWithoutShadow: alpha({ lights: [left, sun([1, 1, 0])] }),
    eight: alpha({ lights: Array.from({ length: 8 }, () => left) }),
    none: alpha({ casters: [] }),
    noCaster: alpha({ casters: [plate({ castsShadow: false })] }),
    faint: alpha({ casters: [plate({ material: new MeshLambertMaterial({ transparent: true, opacity: 0.3 }) })], told: veiled }),
    dense: alpha({ casters: [plate({ material: new MeshLambertMaterial({ transparent: true, opacity: 0.7 }) })] }),
    noReceiver: alpha({ receivers: [desk({ receivesShadow: false })] }),
    holes: alpha({ casters: [plate({ material: holes })], told }),
    told: [told, veiled]
      .flat()
      .map(({ code, port, message }) => `${code} at ${port}: ${message.includes('ignores its transparency') ? 'see-through' : 'shape'}`),
    error: stand.gl.getError(),
  };
}

/** A lit surface that casts, closed, open or bent: how many pixels its own volume darkens, and by how much at most. */
export function acne() {
  const light = sun([-0.4, 1, 0.6], { shadow: SUN });
  const darkened = (one: ObjectItem): { count: number; most: number } => {
    const pixels = shoot(stand, { casters: [one], receivers: [one], lights: [light], method: 'volume', on: 'everything' });
    const alphas = pixels.filter((value, i) => i % 4 === 3 && value > 0);
    return { count: alphas.length, most: alphas.reduce((most, alpha) => Math.max(most, alpha), 0) };
  };
  return {
    ball: darkened(thing(new SphereGeometry(0.4, 48, 32))),
    box: darkened(thing(new BoxGeometry(0.5, 0.5, 0.5), { at: new Matrix4().makeRotationY(0.5) })),
    floor: darkened(desk({ castsShadow: true })),
    bent: darkened(item(bentArm())),
  };
}

/** Casters, lights and matrices change while running; everything is freed. */
export function running() {
  const { backend, layer } = stand;
  const before = backend.counts();
  const light = sun([-1, 1, 0], { shadow: { ...SUN } });
  const lightList = lights(light);
  const at = translation(0, 0.5, 0);
  const casters = objects(plate({ at }));
  const scene = backend
    .serviceFor({ shadowMaps: null, occlusion: null })
    .createScene({ kind: 'shadow-catcher', strength: { value: 0.5 }, color: { value: Float64Array.of(0, 0, 0, 1) }, volumesOf: [casters] });
  const floor = objects(desk());
  const draw = (): number => {
    scene.update([floor], [lightList]);
    layer.clear();
    scene.draw(drawView(viewOf(ABOVE, { x: 0, y: 0, ...SIDES }), layer.framebuffer));
    return onFloor(layer.pixels(), ABOVE, { at: [0.5, 0] }).at ?? -1;
  };
  const on = draw();
  at.setPosition(0, 0.5, 0.6);
  const moved = draw();
  at.setPosition(0, 0.5, 0);
  const back = draw();
  const { shadow } = light;
  light.shadow = null;
  const off = draw();
  light.shadow = shadow;
  light.towardsLightWorld.set([Math.SQRT1_2, Math.SQRT1_2, 0]);
  const turned = draw();
  light.towardsLightWorld.set([-Math.SQRT1_2, Math.SQRT1_2, 0]);
  lightList.items.push(sun([1, 1, 0]));
  lightList.version++;
  const two = draw();
  casters.items.length = 0;
  casters.version++;
  const empty = draw();
  scene.dispose();
  // The list's owner frees what is in it.
  for (const { root } of floor.items) (root as Mesh).geometry.dispose();
  const { geometries, textures, programs } = backend.counts();
  return {
    alphas: { on, moved, back, off, turned, two, empty },
    left: [geometries - before.geometries, textures - before.textures, programs - before.programs],
    error: stand.gl.getError(),
  };
}
