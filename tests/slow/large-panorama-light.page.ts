import { DataUtils, Mesh, MeshStandardMaterial, SphereGeometry } from 'three';
import type { LoadedEnvironment } from '../../export/runtime/scene-backend.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { DerivedEnvironment } from '../../nodes/kit/assets.ts';
import { createStand, difference, drawView, item, lights, lookingAt, objects, type Stand, viewOf } from '../browser/scenes-kit.ts';

type Size = readonly [widthPx: number, heightPx: number];

/** Stripes, a fine pattern and a lamp. */
function valueAt(x: number, y: number, [widthPx, heightPx]: Size): number {
  const isLamp = Math.hypot(x - widthPx * 0.4, y - heightPx * 0.4) < widthPx / 60;
  return isLamp ? 1 : 0.1 + 0.2 * ((x >> 5) & 1) + 0.3 * ((x ^ y) & 1);
}

function halves(size: Size) {
  const [widthPx, heightPx] = size;
  const data = new Uint16Array(widthPx * heightPx * 4);
  for (let i = 0; i < widthPx * heightPx; i++) {
    const value = valueAt(i % widthPx, Math.floor(i / widthPx), size);
    data.fill(DataUtils.toHalfFloat(value === 1 ? 30 : value), i * 4, i * 4 + 3);
    data[i * 4 + 3] = 0x3c00;
  }
  return { widthPx, heightPx, channels: 4 as const, data };
}

async function png(size: Size): Promise<ArrayBuffer> {
  const [widthPx, heightPx] = size;
  const image = new ImageData(widthPx, heightPx);
  for (let i = 0; i < widthPx * heightPx; i++) {
    image.data.fill(255 * valueAt(i % widthPx, Math.floor(i / widthPx), size), i * 4, i * 4 + 3);
    image.data[i * 4 + 3] = 255;
  }
  const canvas = new OffscreenCanvas(widthPx, heightPx);
  canvas.getContext('2d')?.putImageData(image, 0, 0);
  return (await canvas.convertToBlob()).arrayBuffer();
}

/** What the GPU is told between two waits, at most. */
interface Turns {
  turns: number;
  rows: number;
  levelPx: number;
  facePx: number;
}

/** Counts what a page uploads and draws per turn. */
function countedStand(): { readonly stand: Stand; readonly most: Turns } {
  const most: Turns = { turns: 0, rows: 0, levelPx: 0, facePx: 0 };
  const now = { rows: 0, levelPx: 0, facePx: 0 };
  const end = (): void => {
    most.turns++;
    for (const key of ['rows', 'levelPx', 'facePx'] as const) {
      most[key] = Math.max(most[key], now[key]);
      now[key] = 0;
    }
  };
  const stand = createStand(undefined, undefined, ({ gl, canvas }) => {
    const delay = (): Promise<void> => {
      end();
      return new Promise((resolve) => setTimeout(resolve, 0));
    };
    const { texSubImage2D, drawArrays, drawElements } = gl;
    const area = (): number => {
      const box = gl.getParameter(gl.isEnabled(gl.SCISSOR_TEST) ? gl.SCISSOR_BOX : gl.VIEWPORT) as Int32Array;
      return (box[2] ?? 0) * (box[3] ?? 0);
    };
    Object.assign(gl, {
      texSubImage2D: (...all: number[]) => {
        now.rows += all.length > 7 ? (all[5] ?? 0) : Number.POSITIVE_INFINITY;
        texSubImage2D.apply(gl, all as never);
      },
      drawArrays: (...all: [number, number, number]) => {
        now.levelPx += area();
        drawArrays.apply(gl, all);
      },
      drawElements: (...all: [number, number, number, number]) => {
        now.facePx += area();
        drawElements.apply(gl, all);
      },
    });
    return createScenes({ gl, canvas, delay });
  });
  return { stand, most };
}

/** A mirror, a rough ball and the panorama behind them. */
function shoot({ backend, layer }: Stand, environment: LoadedEnvironment | DerivedEnvironment): Uint8Array {
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 1 } });
  const balls = [0, 0.3, 1].map((roughness, i) => {
    const ball = new Mesh(new SphereGeometry(0.2, 48, 32), new MeshStandardMaterial({ roughness, metalness: 1 }));
    ball.position.x = (i - 1) * 0.45;
    return item(ball);
  });
  const sky = { key: 'sky', kind: 'environment', environment, intensity: 0.6, rotationRad: 0.4, visible: true } as const;
  scene.update([objects(...balls)], [lights(sky)]);
  layer.clear();
  scene.draw(drawView(viewOf(lookingAt([0, 0, 1.2], [0, 0, 0])), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();
  return pixels;
}

export interface Lit {
  readonly most: Turns;
  /** Without its lamp; null for half floats, to save time. */
  readonly most2: Turns | null;
  readonly readyAtOnce: readonly boolean[];
  readonly whole: ReturnType<typeof difference>;
  readonly filled: ReturnType<typeof difference> | null;
  readonly lampGone: number;
  readonly errors: readonly number[];
}

/** Lights a scene by a panorama as renders and as pages load it, then without its lamp. */
export async function light(kind: 'halves' | 'png', widthPx: number, heightPx: number): Promise<Lit> {
  const size: Size = [widthPx, heightPx];
  const plain = createStand();
  const { stand, most } = countedStand();
  const bytes = kind === 'png' ? await png(size) : null;
  const pixels = bytes ? null : halves(size);
  const load = async ({ backend }: Stand): Promise<LoadedEnvironment> =>
    bytes ? backend.loadEnvironment(bytes.slice(0)) : backend.createEnvironment(pixels as NonNullable<typeof pixels>);
  const [wanted, got] = [await load(plain), await load(stand)];
  const readyAtOnce = [wanted.ready, got.ready];
  await untilReady(got);
  const loaded = { ...most };
  const [a, b] = [shoot(plain, wanted), shoot(stand, got)];
  const withoutLamp = kind === 'png' ? await fill([plain, stand], [wanted, got], most, a) : { most2: null, filled: null, lampGone: 0 };
  wanted.dispose();
  got.dispose();
  const errors = [plain.gl.getError(), stand.gl.getError()];
  return { most: loaded, readyAtOnce, whole: difference(a, b, 1), ...withoutLamp, errors };
}

type Two<T> = readonly [T, T];

/** The same without the lamp. */
async function fill([plain, stand]: Two<Stand>, [wanted, got]: Two<LoadedEnvironment>, most: Turns, withLamp: Uint8Array) {
  Object.assign(most, { turns: 0, rows: 0, levelPx: 0, facePx: 0 });
  // The lamp and a little around it, in an image of a quarter of the width.
  const runs: number[] = [];
  const searched = { widthPx: wanted.widthPx >> 2, heightPx: wanted.heightPx >> 2 };
  const reach = searched.widthPx / 50;
  const [x, y] = [searched.widthPx * 0.4, searched.heightPx * 0.4];
  for (let row = Math.ceil(y - reach); row < y + reach; row++) runs.push(row, Math.floor(x - reach), Math.ceil(x + reach));
  const [wantedRest, gotRest] = [wanted.withoutLamps(runs, searched), got.withoutLamps(runs, searched)];
  await untilReady(gotRest);
  const [c, d] = [shoot(plain, wantedRest), shoot(stand, gotRest)];
  wantedRest.dispose();
  gotRest.dispose();
  return { most2: { ...most }, filled: difference(c, d, 1), lampGone: difference(withLamp, c, 8).pixels };
}

async function untilReady(environment: DerivedEnvironment): Promise<void> {
  while (!environment.ready) await new Promise((resolve) => setTimeout(resolve, 4));
}
