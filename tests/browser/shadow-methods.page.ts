import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ObjectItem } from '../../nodes/kit/scene-lists.ts';
import { item, loadUrl, lookingAt, midStride, sun, translation } from './scenes-kit.ts';
import { type Agreement, bentArm, byBoth, compare, desk, LIGHTS, SIDES, SUN, stand, thing, toImage } from './shadow-kit.ts';

/** What casts: a lifted truck, or a can, as in the paper's Figure 6. */
function caster(role: 'virtual' | 'phantom'): ObjectItem {
  const root = new Group();
  const tank = new Mesh<BufferGeometry>(new CylinderGeometry(0.16, 0.16, 0.5, 32), new MeshLambertMaterial());
  if (role === 'virtual') {
    const body = new Mesh(new BoxGeometry(0.6, 0.2, 0.3), new MeshLambertMaterial());
    tank.geometry = new SphereGeometry(0.2, 24, 16);
    tank.position.set(-0.1, 0.2, 0);
    root.add(body);
  }
  root.add(tank);
  return item(root, { role, at: translation(-0.35, 0.45, 0) });
}

/** What they fall on: a desk with a block on it. */
function receiver(role: 'virtual' | 'phantom'): ObjectItem {
  const root = new Group();
  const top = new Mesh(new PlaneGeometry(3, 3).rotateX(-Math.PI / 2), new MeshLambertMaterial());
  const block = new Mesh(new BoxGeometry(0.3, 0.2, 0.5), new MeshLambertMaterial());
  block.position.set(0.3, 0.1, 0.1);
  root.add(top, block);
  return item(root, { role, castsShadow: false });
}

/** Shadows in the four directions by one light, each by both methods. */
export function directions(light: string, picture = false) {
  const lamp = LIGHTS[light];
  if (!lamp) throw new Error(light);
  const result: Record<string, Agreement & { error: number; pictures?: number[][] }> = {};
  for (const [from, role] of [
    ['virtual', 'virtual'],
    ['real', 'phantom'],
  ] as const) {
    for (const [to, other] of [
      ['virtual', 'virtual'],
      ['real', 'phantom'],
    ] as const) {
      const on = to === 'virtual' ? 'everything' : 'phantoms';
      const [map, volume] = byBoth({ casters: [caster(role)], receivers: [receiver(other)], lights: [lamp], on });
      result[`${from} on ${to}`] = {
        ...compare(map, volume),
        error: stand.gl.getError(),
        ...(picture ? { pictures: [toImage(map), toImage(volume)] } : {}),
      };
    }
  }
  return result;
}

/** Things that are no closed surface of one piece, or that move: both methods, and what the volumes had to say. */
export function shapes() {
  const light = sun([-1, 1.4, 0.5], { shadow: SUN });
  const at = translation(-0.3, 0.45, 0);
  const open = new SphereGeometry(0.25, 24, 12, 0, Math.PI * 1.4, 0.4, 1.6);
  // Three sheets that share one edge.
  const fan = new BufferGeometry();
  fan.setAttribute('position', new Float32BufferAttribute([0, -0.2, 0, 0, 0.2, 0, 0.3, 0, 0, -0.2, 0, 0.25, -0.2, 0, -0.25], 3));
  fan.setIndex([0, 1, 2, 0, 1, 3, 1, 0, 4]);
  const torus = new TorusGeometry(0.2, 0.07, 16, 32);
  const spread = new InstancedMesh(new BoxGeometry(0.15, 0.15, 0.15), new MeshLambertMaterial(), 3);
  for (const [i, x] of [-0.25, 0, 0.25].entries()) spread.setMatrixAt(i, new Matrix4().makeRotationY(x * 3).setPosition(x, 0, x));
  const cast: Readonly<Record<string, ObjectItem>> = {
    open: thing(open, { at }),
    fan: thing(fan, { at }),
    torus: thing(torus, { at: new Matrix4().makeRotationX(1).premultiply(at) }),
    mirrored: thing(torus, { at: new Matrix4().makeScale(-1, 1.5, 1).premultiply(at) }),
    instances: item(spread, { at }),
    bent: item(bentArm(), { at: translation(-0.3, 0.2, 0) }),
  };
  return Object.fromEntries(
    Object.entries(cast).map(([name, one]) => {
      const [map, volume] = byBoth({ casters: [one], receivers: [desk()], lights: [light] });
      return [name, compare(map, volume)];
    }),
  );
}

/** Two views side by side, each with an eye of its own, against one of them alone. */
export function views() {
  const light = sun([-1, 1.4, 0.5], { shadow: SUN });
  const aspect = SIDES.widthPx / 2 / SIDES.heightPx;
  const [left, right] = [lookingAt([-0.1, 1.3, 1.4], [0.1, 0, 0], aspect), lookingAt([0.3, 1.3, 1.4], [0.1, 0, 0], aspect)];
  const [map, volume] = byBoth({ casters: [caster('virtual')], receivers: [desk()], lights: [light], camera: left, second: right });
  const half = (pixels: Uint8Array, from: number): Uint8Array =>
    pixels.filter((_, i) => Math.floor(i / 4) % SIDES.widthPx >= from && Math.floor(i / 4) % SIDES.widthPx < from + SIDES.widthPx / 2);
  return {
    left: compare(half(map, 0), half(volume, 0)),
    right: compare(half(map, SIDES.widthPx / 2), half(volume, SIDES.widthPx / 2)),
    between: compare(half(volume, 0), half(volume, SIDES.widthPx / 2)).overlap,
  };
}

/** An animated model from a file. */
export async function model(url: string, picture = false) {
  const loaded = await loadUrl(stand.backend, url);
  const { root, at } = midStride(loaded);
  const told: Omit<Diagnostic, 'nodeId'>[] = [];
  const [map, volume] = byBoth({
    casters: [item(root, { at })],
    receivers: [desk()],
    lights: [sun([-1, 1.5, 0.4], { shadow: SUN })],
    told,
  });
  const result = {
    ...compare(map, volume),
    told: told.map(({ code }) => code),
    pictures: picture ? [toImage(map), toImage(volume)] : [],
  };
  loaded.dispose();
  return result;
}
