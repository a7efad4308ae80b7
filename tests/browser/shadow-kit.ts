import {
  Bone,
  BoxGeometry,
  type BufferGeometry,
  Float32BufferAttribute,
  Mesh,
  MeshLambertMaterial,
  type PerspectiveCamera,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { LightShadow, LocalLightShadow } from '../../nodes/kit/light-shadow.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { ShadowCatcherLook, ShadowStrokes } from '../../nodes/kit/scene-look.ts';
import {
  bulb,
  createStand,
  drawView,
  type ItemOptions,
  item,
  lights,
  lookingAt,
  objects,
  pixel,
  type Stand,
  spot,
  sun,
  translation,
  viewOf,
} from './scenes-kit.ts';

type SceneRoom = NonNullable<ShadowCatcherLook['room']>;

export type Method = 'map' | 'volume';

export const CAMERA = lookingAt([0.2, 1.3, 1], [0.2, 0.1, 0]);
export const SUN: LightShadow = { areaM: 2, mapSizePx: 1024, bias: 0, normalBiasM: (2.5 * 2) / 1024 };
export const LAMP: LocalLightShadow = { mapSizePx: 1024, biasPx: 2 };
export const LIGHTS: Readonly<Record<string, LightItem>> = {
  sun: sun([-1, 1.4, 0.5], { shadow: SUN }),
  spot: spot([-1.2, 1.8, 0.5], [0.1, 0.1, 0], 30, { shadow: LAMP, halfAngleRad: 0.7 }),
  bulb: bulb([-1, 1.6, 0.4], 30, { shadow: LAMP }),
};

/** Large, so that the pixel along an edge, where the one is soft and the other is not, is a small part. */
export const SIDES = { widthPx: 480, heightPx: 360 } as const;
export const stand = createStand(SIDES.widthPx, SIDES.heightPx);

export function thing(geometry: BufferGeometry, options: ItemOptions & { material?: MeshLambertMaterial } = {}): ObjectItem {
  return item(new Mesh(geometry, options.material ?? new MeshLambertMaterial()), options);
}

export const desk = (options: ItemOptions = {}): ObjectItem =>
  thing(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2), { role: 'phantom', castsShadow: false, ...options });

export interface Shot {
  readonly casters: readonly ObjectItem[];
  readonly receivers: readonly ObjectItem[];
  readonly lights: readonly LightItem[];
  readonly method: Method;
  readonly on?: 'phantoms' | 'everything';
  readonly camera?: PerspectiveCamera;
  readonly told?: Omit<Diagnostic, 'nodeId'>[];
  /** Depth of the real room, with the tolerance. */
  readonly room?: SceneRoom;
  readonly strength?: number;
  readonly strokes?: ShadowStrokes;
  /** Two halves of the target, each with a camera of its own. */
  readonly second?: PerspectiveCamera;
}

/** One frame as the player draws it: scene and maps updated, then the views. */
export function shoot({ backend, layer }: Stand, shot: Shot): Uint8Array {
  const casters = objects(...shot.casters);
  const lightList = lights(...shot.lights);
  const volumes = shot.method === 'volume';
  const maps = volumes ? null : backend.createShadowMaps([casters], [lightList]);
  const report = (diagnostic: Omit<Diagnostic, 'nodeId'>): void => void shot.told?.push(diagnostic);
  const scene = backend.serviceFor({ shadowMaps: maps, occlusion: null, report }).createScene({
    kind: 'shadow-catcher',
    strength: { value: shot.strength ?? 0.5 },
    color: { value: Float64Array.of(0, 0, 0, 1) },
    on: shot.on ?? 'phantoms',
    ...(volumes ? { volumesOf: [casters] } : {}),
    ...(shot.room ? { room: shot.room } : {}),
    ...(shot.strokes ? { strokes: shot.strokes } : {}),
  });
  scene.update([objects(...shot.receivers)], [lightList]);
  maps?.update();
  layer.clear();
  const camera = shot.camera ?? CAMERA;
  if (shot.second) {
    const half = { y: 0, widthPx: SIDES.widthPx / 2, heightPx: SIDES.heightPx };
    scene.draw(drawView(viewOf(camera, { x: 0, ...half }), layer.framebuffer, 0));
    scene.draw(drawView(viewOf(shot.second, { x: half.widthPx, ...half }), layer.framebuffer, 1));
  } else {
    scene.draw(drawView(viewOf(camera, { x: 0, y: 0, ...SIDES }), layer.framebuffer));
  }
  const pixels = layer.pixels();
  scene.dispose();
  maps?.dispose();
  return pixels;
}

export interface Agreement {
  /** Pixels in both shadows, of those in either. */
  readonly overlap: number;
  /** Pixels whose alpha differs by less than a quarter of a full shadow, of all. */
  readonly alike: number;
  readonly shadowed: number;
}

export function compare(a: Uint8Array, b: Uint8Array): Agreement {
  let [both, either, alike] = [0, 0, 0];
  for (let at = 3; at < a.length; at += 4) {
    const [x = 0, y = 0] = [a[at], b[at]];
    if (x > 64 && y > 64) both++;
    if (x > 64 || y > 64) either++;
    if (Math.abs(x - y) < 32) alike++;
  }
  return { overlap: both / either, alike: alike / (a.length / 4), shadowed: either };
}

export const byBoth = (shot: Omit<Shot, 'method'>): [map: Uint8Array, volume: Uint8Array] => [
  shoot(stand, { ...shot, method: 'map' }),
  shoot(stand, { ...shot, method: 'volume' }),
];

export const toImage = (pixels: Uint8Array): number[] => [...pixels];

/** Alpha at points of the floor, which is drawn in a picture of these sides. */
export function onFloor(pixels: Uint8Array, camera: PerspectiveCamera, points: Readonly<Record<string, readonly [number, number]>>) {
  return Object.fromEntries(
    Object.entries(points).map(([name, [x, z]]) => {
      const { x: u, y: v } = new Vector3(x, 0, z).project(camera);
      const at = [Math.floor((u * 0.5 + 0.5) * SIDES.widthPx), Math.floor((v * 0.5 + 0.5) * SIDES.heightPx)] as const;
      return [name, pixel(pixels, ...at, SIDES.widthPx)[3] ?? -1];
    }),
  );
}

export const plate = (options: ItemOptions & { material?: MeshLambertMaterial } = {}): ObjectItem =>
  thing(new PlaneGeometry(0.4, 0.4).rotateX(-Math.PI / 2), { at: translation(0, 0.5, 0), ...options });
export const ABOVE = lookingAt([0, 2, 1.2], [0, 0, 0]);

/** A closed bar with two bones, the upper one turned by a right angle. */
export function bentArm(): SkinnedMesh {
  const geometry = new BoxGeometry(0.12, 0.6, 0.12, 2, 8, 2).translate(0, 0.3, 0);
  const { position } = geometry.attributes;
  const indices: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < (position?.count ?? 0); i++) {
    const upper = Math.min(Math.max((position?.getY(i) ?? 0) / 0.6, 0), 1);
    indices.push(0, 1, 0, 0);
    weights.push(1 - upper, upper, 0, 0);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
  const lower = new Bone();
  const upper = new Bone();
  upper.position.y = 0.3;
  lower.add(upper);
  const mesh = new SkinnedMesh(geometry, new MeshLambertMaterial());
  mesh.add(lower);
  mesh.bind(new Skeleton([lower, upper]));
  upper.rotation.z = -1.2;
  mesh.updateMatrixWorld(true);
  return mesh;
}
