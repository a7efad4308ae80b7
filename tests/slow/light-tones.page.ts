import { Mesh, MeshLambertMaterial, type Object3D, PlaneGeometry, Vector3 } from 'three';
import type { LoadedEnvironment } from '../../export/runtime/scene-backend.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { TechniqueView } from '../../nodes/kit/technique-view.ts';
import { drawView, item, lights, loadUrl, lookingAt, normalizing, objects, viewOf } from '../browser/scenes-kit.ts';
import { drawnWith, loadImages, stand, technique, viewOfText } from '../browser/techniques-kit.ts';
import { dimmed, type LampName, type Lamps, lampsOf, reaching } from './light-tones-lamps.ts';
import { ASKED, type Lit, linear } from './light-tones-styles.ts';

/** Mean luminance of models that techniques draw, and the tone that the light asks for, from pictures by three.js' own materials. */

/** Shaded surfaces alone: no outlines, no color of their own. */
const VALUES = {
  toon: { outlinePx: 0 },
  hatching: { linePx: 0 },
  charcoal: { linePx: 0 },
  gooch: { linePx: 0, highlight: 0 },
  'loose-lines': { strokePx: 0, loosePx: 0, TIME: 0 },
  custom: { tint: [0, 0, 0, 0] },
  brick: { brickM: [2, 1], variation: 0, bump: 0, mortarM: 0, brickColor: [1, 1, 1, 1] },
} as const;

export type Style = keyof typeof VALUES;

const CAMERA = lookingAt([1.6, 0.7, 1.5], [0, 0, 0]);
const STOPS = [-7, -5, -3, -2, -1, 0];
/** The reference is drawn this much darker, so that nothing brighter than white is cut off. */
const DARKER = 1 / 8;

const models = new Map<string, { readonly root: Object3D; readonly own: ObjectItem }>();
const panoramas = new Map<string, LoadedEnvironment>();

export async function prepare(modelNames: readonly string[], panoramaNames: readonly string[]): Promise<void> {
  await loadImages();
  for (const name of modelNames) {
    const root = (await loadUrl(stand.backend, `/models/${name}`)).instantiate();
    root.traverse((node) => {
      if (node instanceof Mesh) node.material = new MeshLambertMaterial({ flatShading: !node.geometry.attributes.normal });
    });
    models.set(name, { root, own: item(root, { at: normalizing(root) }) });
  }
  for (const name of panoramaNames) {
    panoramas.set(name, await stand.backend.loadEnvironment(await (await fetch(`/panoramas/${name}`)).arrayBuffer()));
  }
}

type Parts = 'all' | 'open' | 'around';

/** Pictures of an object at several brightnesses of a light; the scene compiles once. */
function shots(thing: ObjectItem, lamps: Lamps, factors: readonly number[], parts: Parts = 'all', camera = CAMERA): Uint8Array[] {
  const { backend, layer } = stand;
  const list = objects(thing);
  const lit = lights();
  const set = (factor: number): void => {
    const direct = parts === 'around' || !lamps.direct ? null : dimmed(lamps.direct, factor);
    if (direct && parts === 'open') direct.shadow = null;
    lit.items.splice(0, lit.items.length, ...[direct, lamps.around(factor)].filter((light): light is LightItem => light !== null));
    lit.version++;
  };
  set(1);
  const shadowMaps = parts === 'all' && lamps.direct?.shadow ? backend.createShadowMaps([list], [lit]) : null;
  const ambient = { value: 0 };
  const scene = backend.serviceFor({ shadowMaps, occlusion: null }).createScene({ kind: 'shaded', ambient });
  const drawn = factors.map((factor) => {
    ambient.value = lamps.ambient * factor;
    set(factor);
    scene.update([list], [lit]);
    shadowMaps?.update();
    layer.clear();
    backend.invalidateState();
    scene.draw(drawView(viewOf(camera), layer.framebuffer));
    return layer.pixels();
  });
  scene.dispose();
  shadowMaps?.dispose();
  return drawn;
}

function luminanceAt(pixels: Uint8Array, i: number): number {
  const [r = 0, g = 0, b = 0] = [0, 1, 2].map((c) => linear((pixels[i * 4 + c] ?? 0) / 255));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Position and normal of each pixel, as colors. */
const POSITIONS = `/*{ "INPUTS": [] }*/
vec4 surface(const in Surface s) { return vec4(s.position * 0.4 + 0.5, 1.0); }`;
const NORMALS = `/*{ "INPUTS": [] }*/
vec4 surface(const in Surface s) { return vec4(s.normal * 0.5 + 0.5, 1.0); }`;

function vectorAt(pixels: Uint8Array, i: number, scale: number): Vector3 {
  const [x = 0, y = 0, z = 0] = [0, 1, 2].map((c) => (linear((pixels[i * 4 + c] ?? 0) / 255) - 0.5) / scale);
  return new Vector3(x, y, z);
}

/** What white planes that face each way receive of the environment: its direction, and the luminance there. */
function around(lamps: Lamps): { towards: Vector3; onWhite: number; rise: number } {
  const facing = (towards: Vector3): number => {
    const plane = new Mesh(new PlaneGeometry(2, 2), new MeshLambertMaterial());
    plane.lookAt(towards);
    const camera = lookingAt([towards.x, towards.y, towards.z || 1e-4], [0, 0, 0]);
    const [pixels = new Uint8Array()] = shots(item(plane), lamps, [DARKER], 'around', camera);
    return luminanceAt(pixels, pixels.length / 8 + 80) / DARKER;
  };
  const rise = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map(
    (axis) => facing(axis) - facing(axis.clone().negate()),
  );
  const [x = 0, y = 0, z = 0] = rise;
  const towards = new Vector3(x, y, z);
  if (towards.lengthSq() === 0) return { towards: new Vector3(0, 1, 0), onWhite: 0, rise: 0 };
  towards.normalize();
  const onWhite = facing(towards);
  return { towards, onWhite, rise: onWhite - facing(towards.clone().negate()) };
}

/** The light at each pixel of a model, at full brightness; null beside it. */
function reference(model: string, lamps: Lamps): (Lit | null)[] {
  const { own, root } = models.get(model) ?? { own: item(new Mesh()), root: new Mesh() };
  const styled = (name: string, text: string): Uint8Array =>
    shots(drawnWith(root, viewOfText(text, name), own.worldFromObject), lamps, [1])[0] ?? new Uint8Array();
  const [positions, normals] = [styled('positions', POSITIONS), styled('normals', NORMALS)];
  const [shaded = new Uint8Array()] = shots(own, lamps, [DARKER]);
  const [open = shaded] = lamps.direct?.shadow ? shots(own, lamps, [DARKER], 'open') : [];
  const sky = around(lamps);
  return Array.from({ length: shaded.length / 4 }, (_, i) => {
    if (shaded[i * 4 + 3] !== 255 || positions[i * 4 + 3] !== 255) return null;
    const received = luminanceAt(shaded, i) / DARKER;
    const without = luminanceAt(open, i) / DARKER;
    const normal = vectorAt(normals, i, 0.5).normalize();
    const direct = lamps.direct ? reaching(lamps.direct, vectorAt(positions, i, 0.4)) : { towards: sky.towards, onWhite: 0 };
    const strongest = direct.onWhite > sky.rise ? direct.towards : sky.towards;
    const cosine = normal.dot(strongest);
    // Lights with a shadow are alone.
    const lit = lamps.direct?.shadow && without > 0 ? Math.min(received / without, 1) : 1;
    return { received, onWhite: direct.onWhite + sky.onWhite, facing: cosine > 0 ? cosine * lit : cosine };
  });
}

const known = new Map<string, (Lit | null)[]>();

export interface Tones {
  /** Mean luminance by brightness of the light, darkest first: as drawn, and as asked for. */
  readonly drawn: readonly number[];
  readonly asked: readonly number[];
  readonly pixels: number;
}

export function tones(style: Style, model: string, lampName: LampName): Tones {
  const lamps = lampsOf(lampName, panoramas);
  const key = `${model} ${lampName}`;
  const lit = known.get(key) ?? reference(model, lamps);
  known.set(key, lit);
  const { root, own } = models.get(model) ?? { own: item(new Mesh()), root: new Mesh() };
  const view: TechniqueView = technique(style, VALUES[style]);
  const factors = STOPS.map((stops) => 2 ** stops);
  const pictures = shots(drawnWith(root, view, own.worldFromObject), lamps, factors);
  const pixels = lit.filter((one) => one !== null).length;
  const mean = (at: (one: Lit, i: number) => number): number => lit.reduce((sum, one, i) => (one ? sum + at(one, i) / pixels : sum), 0);
  const askedFor = ASKED[style] ?? (() => Number.NaN);
  return {
    drawn: pictures.map((picture) => mean((_, i) => luminanceAt(picture, i))),
    asked: factors.map((factor) =>
      mean(({ received, onWhite, facing }) => askedFor({ received: received * factor, onWhite: onWhite * factor, facing })),
    ),
    pixels,
  };
}

/** The picture itself, to be looked at. */
export function picture(style: Style | null, model: string, lampName: LampName, stops: number): number[] {
  const { root, own } = models.get(model) ?? { own: item(new Mesh()), root: new Mesh() };
  const thing = style ? drawnWith(root, technique(style), own.worldFromObject) : own;
  return [...(shots(thing, lampsOf(lampName, panoramas), [2 ** stops])[0] ?? [])];
}
