import { Matrix4, Mesh, MeshLambertMaterial, type Object3D, PlaneGeometry, Vector3 } from 'three';
import type { LoadedEnvironment } from '../../export/runtime/scene-backend.ts';
import type { LightItem, ObjectItem } from '../../nodes/kit/scene-lists.ts';
import type { TechniqueView } from '../../nodes/kit/technique-view.ts';
import {
  createLayer,
  drawView,
  item,
  lights,
  loadUrl,
  lookingAt,
  normalizing,
  objects,
  translation,
  viewOf,
} from '../browser/scenes-kit.ts';
import { drawnWith, loadImages, stand, technique, viewOfText } from '../browser/techniques-kit.ts';
import { dimmed, type LampName, type Lamps, lampsOf, reaching } from './light-tones-lamps.ts';
import { ASKED, type Lit, linear } from './light-tones-styles.ts';

/** Mean luminance of models that techniques draw, and the tone that the light asks for, from pictures by three.js' own materials. */

/** Shaded surfaces alone: no highlight, no color of their own. */
const VALUES = {
  toon: {},
  hatching: {},
  charcoal: {},
  gooch: { highlight: 0 },
  'loose-lines': { TIME: 0, suggestive: 0 },
  custom: { tint: [0, 0, 0, 0] },
  brick: { brickM: [2, 1], variation: 0, bump: 0, mortarM: 0, brickColor: [1, 1, 1, 1] },
} as const;

export type Style = keyof typeof VALUES;

/** So large that each model has a thousand pixels, among which the grain of charcoal evens out. */
const layer = createLayer(stand.gl, 320, 240);
const VIEWPORT = { x: 0, y: 0, widthPx: layer.widthPx, heightPx: layer.heightPx };
const CAMERA = lookingAt([1.6, 0.7, 1.5], [0, 0, 0]);
const STOPS = [-7, -5, -3, -2, -1, 0];
/** The reference is drawn this much darker, so that nothing brighter than white is cut off. */
const DARKER = 1 / 8;

/** Where each model stands, from the middle of the picture to the right and up, in meters, and how large it is. */
const PLACES = [
  [-0.9, 0.5],
  [0, 0.5],
  [0.9, 0.5],
  [-0.45, -0.5],
  [0.45, -0.5],
] as const;
const RADIUS_M = 0.46;
const [RIGHT, UP] = [0, 1].map((column) => new Vector3().setFromMatrixColumn(CAMERA.matrixWorld, column)) as [Vector3, Vector3];

/** All models stand in one picture, because most of the time goes into shaders and light, not into pixels. */
const models: { readonly root: Object3D; readonly own: ObjectItem }[] = [];
const panoramas = new Map<string, LoadedEnvironment>();

export async function prepare(modelNames: readonly string[], panoramaNames: readonly string[]): Promise<void> {
  await loadImages();
  for (const [i, name] of modelNames.entries()) {
    const root = (await loadUrl(stand.backend, `/models/${name}`)).instantiate();
    root.traverse((node) => {
      if (node instanceof Mesh) node.material = new MeshLambertMaterial({ flatShading: !node.geometry.attributes.normal });
    });
    const [right, up] = PLACES[i] ?? [Number.NaN, Number.NaN];
    const { x, y, z } = RIGHT.clone().multiplyScalar(right).addScaledVector(UP, up);
    const at = translation(x, y, z)
      .multiply(new Matrix4().makeScale(RADIUS_M, RADIUS_M, RADIUS_M))
      .multiply(normalizing(root));
    models.push({ root, own: item(root, { at }) });
  }
  for (const name of panoramaNames) {
    panoramas.set(name, await stand.backend.loadEnvironment(await (await fetch(`/panoramas/${name}`)).arrayBuffer()));
  }
}

/** A style without its outlines and strokes, which are its later passes. */
function surfaceOf(style: Style): TechniqueView {
  const view = technique(style, VALUES[style]);
  return { ...view, passes: view.passes.slice(0, 1) };
}

const drawnBy = (view: TechniqueView): ObjectItem[] => models.map(({ root, own }) => drawnWith(root, view, own.worldFromObject));
const plain = (): ObjectItem[] => models.map(({ own }) => own);

type Parts = 'all' | 'open' | 'around';

/** Scenes in one light. They stay, so that shaders and prefiltered light serve all pictures in it. */
interface Stage {
  readonly lamps: Lamps;
  /** Pictures at several brightnesses of the light. */
  shots(things: readonly ObjectItem[], factors: readonly number[], parts?: Parts, camera?: typeof CAMERA): Uint8Array[];
}

function createStage(lamps: Lamps): Stage {
  const { backend } = stand;
  const list = objects();
  const lit = lights();
  const ambient = { value: 0 };
  const set = (factor: number, parts: Parts): void => {
    const direct = parts === 'around' || !lamps.direct ? null : dimmed(lamps.direct, factor);
    if (direct && parts !== 'all') direct.shadow = null;
    lit.items.splice(0, lit.items.length, ...[direct, lamps.around(factor)].filter((light): light is LightItem => light !== null));
    lit.version++;
    ambient.value = lamps.ambient * factor;
  };
  set(1, 'all');
  const maps = lamps.direct?.shadow ? backend.createShadowMaps([list], [lit]) : null;
  const sceneWith = (shadowMaps: typeof maps) =>
    backend.serviceFor({ shadowMaps, occlusion: null }).createScene({ kind: 'shaded', ambient });
  const open = sceneWith(null);
  const shadowed = maps && sceneWith(maps);
  return {
    lamps,
    shots: (things, factors, parts = 'all', camera = CAMERA) => {
      list.items.splice(0, list.items.length, ...things);
      list.version++;
      const scene = (parts === 'all' && shadowed) || open;
      return factors.map((factor) => {
        set(factor, parts);
        scene.update([list], [lit]);
        if (scene === shadowed) maps?.update();
        layer.clear();
        scene.draw(drawView(viewOf(camera, VIEWPORT), layer.framebuffer));
        return layer.pixels();
      });
    },
  };
}

const stages = new Map<LampName, Stage>();

function stageOf(name: LampName): Stage {
  const stage = stages.get(name) ?? createStage(lampsOf(name, panoramas));
  stages.set(name, stage);
  return stage;
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
function around(stage: Stage): { towards: Vector3; onWhite: number; rise: number } {
  if (stage.lamps.ambient === 0 && !stage.lamps.around(1)) return { towards: new Vector3(0, 1, 0), onWhite: 0, rise: 0 };
  const plane = new Mesh(new PlaneGeometry(2, 2), new MeshLambertMaterial());
  const facing = (towards: Vector3): number => {
    plane.lookAt(towards);
    const camera = lookingAt([towards.x, towards.y, towards.z || 1e-4], [0, 0, 0]);
    const [pixels = new Uint8Array()] = stage.shots([item(plane)], [DARKER], 'around', camera);
    return luminanceAt(pixels, pixels.length / 8 + layer.widthPx / 2) / DARKER;
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

/** The light at a pixel, and the model that is there. */
type LitModel = Lit & { readonly model: number };

/** What is the same in all light. */
let surface: { readonly positions: Uint8Array; readonly normals: Uint8Array } | null = null;

function surfaceBy(stage: Stage): NonNullable<typeof surface> {
  const styled = (name: string, text: string): Uint8Array => stage.shots(drawnBy(viewOfText(text, name)), [1])[0] ?? new Uint8Array();
  return { positions: styled('positions', POSITIONS), normals: styled('normals', NORMALS) };
}

/** The light at each pixel, at full brightness; null beside the models. */
function reference(stage: Stage): (LitModel | null)[] {
  const { lamps } = stage;
  surface ??= surfaceBy(stage);
  const { positions, normals } = surface;
  const [shaded = new Uint8Array()] = stage.shots(plain(), [DARKER]);
  const [open = shaded] = lamps.direct?.shadow ? stage.shots(plain(), [DARKER], 'open') : [];
  const sky = around(stage);
  return Array.from({ length: shaded.length / 4 }, (_, i) => {
    if (shaded[i * 4 + 3] !== 255 || positions[i * 4 + 3] !== 255) return null;
    const received = luminanceAt(shaded, i) / DARKER;
    const without = luminanceAt(open, i) / DARKER;
    const normal = vectorAt(normals, i, 0.5).normalize();
    const position = vectorAt(positions, i, 0.4);
    const direct = lamps.direct ? reaching(lamps.direct, position) : { towards: sky.towards, onWhite: 0 };
    const strongest = direct.onWhite > sky.rise ? direct.towards : sky.towards;
    const cosine = normal.dot(strongest);
    // Lights with a shadow are alone.
    const lit = lamps.direct?.shadow && without > 0 ? Math.min(received / without, 1) : 1;
    return { received, onWhite: direct.onWhite + sky.onWhite, facing: cosine > 0 ? cosine * lit : cosine, model: modelAt(position) };
  });
}

/** The model whose place is nearest. */
function modelAt(position: Vector3): number {
  const [x, y] = [position.dot(RIGHT), position.dot(UP)];
  const away = PLACES.map(([right, up]) => Math.hypot(x - right, y - up));
  return away.indexOf(Math.min(...away));
}

const known = new Map<LampName, (LitModel | null)[]>();

export interface Tones {
  /** Mean luminance by brightness of the light, darkest first: as drawn, and as asked for. */
  readonly drawn: readonly number[];
  readonly asked: readonly number[];
  readonly pixels: number;
}

/** Of each model. */
export function tones(style: Style, lampName: LampName): Tones[] {
  const stage = stageOf(lampName);
  const lit = known.get(lampName) ?? reference(stage);
  known.set(lampName, lit);
  const factors = STOPS.map((stops) => 2 ** stops);
  const pictures = stage.shots(drawnBy(surfaceOf(style)), factors);
  const askedFor = ASKED[style] ?? (() => Number.NaN);
  return models.map((_, model) => {
    const own = lit.flatMap((one, i) => (one?.model === model ? [{ ...one, i }] : []));
    const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value / own.length, 0);
    return {
      drawn: pictures.map((picture) => mean(own.map(({ i }) => luminanceAt(picture, i)))),
      asked: factors.map((factor) =>
        mean(own.map(({ received, onWhite, facing }) => askedFor({ received: received * factor, onWhite: onWhite * factor, facing }))),
      ),
      pixels: own.length,
    };
  });
}

/** The picture itself, to be looked at. */
export function picture(style: Style | null, lampName: LampName, stops: number): number[] {
  const things = style ? drawnBy(technique(style)) : plain();
  return [...(stageOf(lampName).shots(things, [2 ** stops])[0] ?? [])];
}
