import { BufferGeometry, DoubleSide, Float32BufferAttribute, type Intersection, Mesh, MeshLambertMaterial, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import type { ShadowFilter } from '../../nodes/kit/light-shadow.ts';
import type { DirectLightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { SceneLook } from '../../nodes/kit/scene-look.ts';
import {
  bulb,
  createStand,
  drawView,
  item,
  lights,
  loadUrl,
  lookingAt,
  normalizing,
  objects,
  spot,
  sun,
  viewOf,
} from '../browser/scenes-kit.ts';

/** Shadows that models cast on their own lit sides, beside rays against their triangles. */

const WIDTH = 360;
const HEIGHT = 270;
const stand = createStand(WIDTH, HEIGHT, createScenesWith({ decoders: ALL_DECODERS, files: () => Promise.reject(new Error('none')) }));

export type Kind = 'sun' | 'spot' | 'point';

/** As the nodes of these lights set their shadows by default. */
const MAP_PX = 1024;
const BIAS_PX = 2.5;
const AREA_M = 5;
const FROM = new Vector3(1.5, 2.2, 1.8);

function lightOf(kind: Kind, filter: ShadowFilter, shadow: boolean): DirectLightItem {
  const local = shadow ? { mapSizePx: MAP_PX, biasPx: BIAS_PX, filter, sourceM: 0.1 } : null;
  switch (kind) {
    case 'sun': {
      const mapSizePx = 2 * MAP_PX;
      const map = { areaM: AREA_M, mapSizePx, bias: 0, normalBiasM: (BIAS_PX * AREA_M) / mapSizePx, filter, sourceRad: 0.1 };
      return sun([FROM.x, FROM.y, FROM.z], { shadow: shadow ? map : null });
    }
    case 'spot':
      return spot([FROM.x, FROM.y, FROM.z], [0, 0, 0], 34, { halfAngleRad: 0.8, penumbra: 0.2, shadow: local });
    case 'point':
      return bulb([FROM.x, FROM.y, FROM.z], 34, { shadow: local });
  }
}

/** Meters of a texel of the map at the distance of the model. */
function texelM(kind: Kind): number {
  if (kind === 'sun') return AREA_M / (2 * MAP_PX);
  return (2 * FROM.length() * (kind === 'spot' ? Math.tan(0.8) : 1)) / MAP_PX;
}

interface Model {
  readonly own: ObjectItem;
  readonly bvh: MeshBVH;
  readonly pixels: readonly Pixel[];
  readonly covered: number;
}

/** A pixel that is well inside of the model's outlines. */
interface Pixel {
  readonly index: number;
  readonly point: Vector3;
  /** Of the triangle, on the side of the camera. */
  readonly normal: Vector3;
}

const CAMERA = lookingAt([1.9, 0.9, 1.1], [0, 0, 0], WIDTH / HEIGHT);
const models = new Map<string, Model>();

/** Triangles in world space, as they are drawn: after morphing and skinning. */
function bake(own: ObjectItem): BufferGeometry {
  const positions: number[] = [];
  const at = new Vector3();
  own.root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const { index, attributes } = node.geometry as BufferGeometry;
    const count = index?.count ?? attributes.position?.count ?? 0;
    for (let i = 0; i < count; i++) {
      node
        .getVertexPosition(index ? index.getX(i) : i, at)
        .applyMatrix4(node.matrixWorld)
        .applyMatrix4(own.worldFromObject);
      positions.push(at.x, at.y, at.z);
    }
  });
  const baked = new BufferGeometry();
  baked.setAttribute('position', new Float32BufferAttribute(positions, 3));
  return baked;
}

export async function load(name: string, normals: 'flat' | 'smooth' = 'flat'): Promise<{ covered: number; inside: number }> {
  const root = (await loadUrl(stand.backend, `/models/${name}`)).instantiate(normals);
  root.traverse((node) => {
    // One matte, opaque material: what a surface is made of does not matter here.
    if (node instanceof Mesh) {
      const flatShading = Boolean((Array.isArray(node.material) ? node.material[0] : node.material)?.flatShading);
      node.material = new MeshLambertMaterial({ flatShading, side: DoubleSide });
    }
  });
  const own = item(root, { at: normalizing(root) });
  const bvh = new MeshBVH(bake(own));
  const hits = Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    const to = new Vector3((((i % WIDTH) + 0.5) / WIDTH) * 2 - 1, ((Math.floor(i / WIDTH) + 0.5) / HEIGHT) * 2 - 1, 0.5).unproject(CAMERA);
    return bvh.raycastFirst(new Ray(CAMERA.position.clone(), to.sub(CAMERA.position).normalize()), DoubleSide);
  });
  const pixels = hits.flatMap((hit, index): Pixel[] => {
    if (!hit?.face || !isInside(hits, index, hit)) return [];
    const { normal } = hit.face;
    const facing = normal.dot(CAMERA.position.clone().sub(hit.point)) < 0 ? -1 : 1;
    return [{ index, point: hit.point, normal: normal.clone().multiplyScalar(facing) }];
  });
  const covered = hits.filter((hit) => hit !== null).length;
  models.set(name, { own, bvh, pixels, covered });
  return { covered, inside: pixels.length };
}

/** Whether no outline is within two pixels: all are hit, on a surface that goes on. */
function isInside(hits: readonly (Intersection | null)[], index: number, { distance }: Intersection): boolean {
  const [x, y] = [index % WIDTH, Math.floor(index / WIDTH)];
  if (x < 2 || y < 2 || x >= WIDTH - 2 || y >= HEIGHT - 2) return false;
  for (let dy = -2; dy <= 2; dy++) {
    for (let dx = -2; dx <= 2; dx++) {
      const beside = hits[index + dy * WIDTH + dx];
      if (!beside || Math.abs(beside.distance - distance) > 0.06) return false;
    }
  }
  return true;
}

/**
 * Half the width of a shadow's edge, in texels: closer to a true shadow, a lit pixel may be in its edge. The offset alone moves an edge by
 * up to 2.5 texels.
 */
const EDGE_TEXELS: Readonly<Record<ShadowFilter, number>> = { basic: 2.5, pcf: 2.5, soft: 3, vsm: 6, pcss: 3 };
/** Radius of a penumbra per meter between caster and receiver. */
const PENUMBRA = 0.08;

/** Pixels that all light reaches, by rays. Filters with equal edges share them. */
function litPixels(name: string, model: Model, kind: Kind, filter: ShadowFilter): readonly Pixel[] {
  const key = `${name} ${kind} ${EDGE_TEXELS[filter]} ${filter === 'pcss'}`;
  let lit = litByRays.get(key);
  if (!lit) {
    lit = model.pixels.filter((pixel) => {
      const towards = kind === 'sun' ? FROM.clone().normalize() : FROM.clone().sub(pixel.point).normalize();
      return pixel.normal.dot(towards) > 0.2 && isLit(model, pixel, kind, filter);
    });
    litByRays.set(key, lit);
  }
  return lit;
}

const litByRays = new Map<string, readonly Pixel[]>();

/** Whether all of the light around a point reaches it, by rays. */
function isLit({ bvh }: Model, { point, normal }: Pixel, kind: Kind, filter: ShadowFilter): boolean {
  const towards = kind === 'sun' ? FROM.clone().normalize() : FROM.clone().sub(point).normalize();
  const side = new Vector3().crossVectors(towards, Math.abs(towards.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0)).normalize();
  const up = new Vector3().crossVectors(side, towards);
  const edgeM = EDGE_TEXELS[filter] * texelM(kind);
  // Shadows of the surface itself are what is looked for, so the rays begin above it.
  const from = point.clone().addScaledVector(normal, 1e-4);
  for (let i = 0; i < 9; i++) {
    const angle = (i * Math.PI) / 4;
    const off = new Vector3().addScaledVector(side, Math.cos(angle)).addScaledVector(up, Math.sin(angle));
    const origin = from.clone();
    const direction = towards.clone();
    if (i < 8) {
      // Stays on the plane of the surface.
      const shift = off.clone().multiplyScalar(edgeM);
      shift.addScaledVector(towards, -shift.dot(normal) / Math.max(towards.dot(normal), 0.05));
      origin.add(shift);
      if (filter === 'pcss') direction.addScaledVector(off, PENUMBRA).normalize();
    }
    if (bvh.raycastFirst(new Ray(origin, direction), DoubleSide)) return false;
  }
  // Closer to another surface than a few texels, the map cannot tell which of the two it shows.
  const lifted = point.clone().addScaledVector(normal, EDGE_TEXELS[filter] * texelM(kind) * 1.5);
  if (bvh.raycastFirst(new Ray(lifted, towards), DoubleSide)) return false;
  return true;
}

/**
 * Pictures of all models in a light with a filter, each alone; null: no shadow layer, but objects in a scene. All scenes stay until the last
 * is drawn, so that three.js compiles what they have in common once.
 */
function drawAll(kind: Kind, filter: ShadowFilter | null, shadow: boolean): Map<string, Uint8Array> {
  const { backend, layer } = stand;
  const look: SceneLook = filter
    ? { kind: 'shadow-catcher', strength: { value: 1 }, color: { value: Float64Array.of(0, 0, 0, 1) }, on: 'everything' }
    : { kind: 'shaded', ambient: { value: 0 } };
  const drawn: { dispose(): void }[] = [];
  const pictures = [...models].map(([name, { own }]): [string, Uint8Array] => {
    const [list, lit] = [objects(own), lights(lightOf(kind, filter ?? 'pcf', shadow))];
    const shadowMaps = shadow ? backend.createShadowMaps([list], [lit]) : null;
    const scene = backend.serviceFor({ shadowMaps, occlusion: null, report: () => {} }).createScene(look);
    drawn.push(scene, ...(shadowMaps ? [shadowMaps] : []));
    scene.update([list], [lit]);
    shadowMaps?.update();
    layer.clear();
    scene.draw(drawView(viewOf(CAMERA, { x: 0, y: 0, widthPx: WIDTH, heightPx: HEIGHT }), layer.framebuffer));
    return [name, layer.pixels()];
  });
  for (const one of drawn) one.dispose();
  return new Map(pictures);
}

const linear = (byte: number): number => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);

export interface Acne {
  /** Pixels that all light reaches, by rays, and those of them that are drawn at least a tenth darker. */
  readonly lit: number;
  readonly wrong: number;
}

/** In a light with a filter; null: three.js' own, of objects in a scene; else that of a shadow layer. Of each model, by name. */
export function acne(kind: Kind, filter: ShadowFilter | null): Record<string, Acne> {
  const shadowed = drawAll(kind, filter, true);
  const open = filter ? null : drawAll(kind, filter, false);
  const at = (pixels: Uint8Array | undefined, index: number): number => linear(pixels?.[index * 4] ?? 0);
  const found = [...models].map(([name, model]): [string, Acne] => {
    const [pixels, without] = [shadowed.get(name), open?.get(name)];
    const lit = litPixels(name, model, kind, filter ?? 'pcf');
    const isDark = ({ index }: Pixel): boolean =>
      open ? at(pixels, index) < 0.9 * at(without, index) : (pixels?.[index * 4 + 3] ?? 0) > 25;
    return [name, { lit: lit.length, wrong: lit.filter(isDark).length }];
  });
  return Object.fromEntries(found);
}

/** The picture of a model in a light, to be looked at. */
export function picture(name: string, kind: Kind): number[] {
  return [...(drawAll(kind, null, true).get(name) ?? [])];
}
