import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { Player } from '../../export/runtime/player.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { createSessionInput, nextTap } from '../../export/runtime/sessions/input/session-input.ts';
import { setFrustum, setRigidInverse } from '../../export/runtime/sessions/matrix.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { ParamValue } from '../../nodes/kit/definition.ts';
import { MIDDLE_M, moved, type Place, RAIL_M } from '../../tools/examples/gallery-place.ts';
import { frame, stand, view } from './runtime-kit.ts';

/** What is done before a frame. */
export interface Deed {
  readonly params?: readonly (readonly [node: string, param: string, value: ParamValue])[];
  readonly taps?: number;
  readonly stick?: readonly [number, number];
  /** How many frames are drawn at the end; 1 unless given. */
  readonly drawn?: number;
}

export interface CellLook {
  /** Middle of what is bright in the cell, meters from the foot of its rail; null where nothing is. */
  readonly ball: readonly [number, number] | null;
  /** In the middle of the cell, bytes. */
  readonly color: readonly number[];
}

const WIDTH_PX = 408;
const HEIGHT_PX = 600;
/** The wall is looked at straight on, from this far in front of it; so much is seen of it from top to bottom. */
const AWAY_M = 1.8;
const SEEN_M = 1.26;
const METERS_PER_PX = SEEN_M / HEIGHT_PX;
/** What belongs to a cell around the foot of its rail, in heights of the rail. */
const CELL = { side: 0.75, below: 0.25, above: 1.25 } as const;
/** A ball, but no rail and no background. */
const BRIGHT = 100;

let gl: WebGL2RenderingContext;
let player: Player;
let told: () => readonly unknown[];
let index = 0;
const input = createSessionInput();
const wall = view(0, 0, WIDTH_PX, HEIGHT_PX);

export async function begin(program: Program, assetsUrl: string): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH_PX;
  canvas.height = HEIGHT_PX;
  document.body.append(canvas);
  gl = canvas.getContext('webgl2', { antialias: false, depth: true, preserveDrawingBuffer: true }) as WebGL2RenderingContext;
  const assets = createFetchAssetSource(new URL(assetsUrl, location.href).href, (...args) => fetch(...args));
  const made = await stand(program, { gl, modules: RUNTIMES, createScenes, assets, held: true });
  player = made.player;
  told = made.diagnostics;
  player.setSession({ world: 'none', blend: 'opaque' });
  const y = SEEN_M / 2 / AWAY_M;
  const x = (y * WIDTH_PX) / HEIGHT_PX;
  setFrustum(wall.clipFromView, -x, x, -y, y, 0.1, 100);
  wall.worldFromView.set(moved(MIDDLE_M, 0, 0, AWAY_M), 12);
  setRigidInverse(wall.viewFromWorld, wall.worldFromView);
}

/** Frames of a thirtieth of a second up to this one, after the deed; the last ones are drawn. */
export async function playTo(last: number, { params = [], taps = 0, stick, drawn = 1 }: Deed = {}): Promise<void> {
  for (const [node, param, value] of params) {
    if (!player.setParam(node, param, value)) throw new Error(`${node}.${param} cannot be set.`);
  }
  if (stick) {
    input.right.connected = true;
    input.right.stick.set(stick);
  }
  input.tapCount = 0;
  for (let i = 0; i < taps; i++) nextTap(input);
  for (; index <= last; index++) {
    if (index > last - drawn) await player.drawSettled(frame(index, [wall], { input }));
    else player.draw(frame(index, [], { input }));
    input.tapCount = 0;
  }
}

export async function recompile(program: Program): Promise<string> {
  return (await player.replaceProgram(program)).outcome;
}

/** Starts over: the frames count from 0 again. */
export function reset(): void {
  player.reset();
  index = 0;
}

/** Of cells with their feet here, as the last frame drew them. */
export function look(feet: readonly Place[]): CellLook[] {
  const picture = readWall();
  return feet.map(([footX, footY]) => {
    const [left, right] = [footX - CELL.side * RAIL_M, footX + CELL.side * RAIL_M].map(pixelX) as [number, number];
    const [bottom, top] = [footY - CELL.below * RAIL_M, footY + CELL.above * RAIL_M].map(pixelY) as [number, number];
    let [count, sumX, sumY] = [0, 0, 0];
    for (let y = bottom; y < top; y++) {
      for (let x = left; x < right; x++) {
        if (Math.max(...colorAt(picture, x, y)) < BRIGHT) continue;
        count++;
        sumX += x + 0.5;
        sumY += y + 0.5;
      }
    }
    const ball = count === 0 ? null : ([metersX(sumX / count) - footX, metersY(sumY / count) - footY] as const);
    return { ball, color: [...colorAt(picture, pixelX(footX), pixelY(footY + RAIL_M / 2))] };
  });
}

/** A part of the wall, RGB bytes from the lower left. */
export interface Piece {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly rgb: readonly number[];
}

/** Pieces of the wall of this size around these places. */
export function piecesAt(middles: readonly Place[], [widthM, heightM]: readonly [number, number]): Piece[] {
  const picture = readWall();
  const [widthPx, heightPx] = [Math.round(widthM / METERS_PER_PX), Math.round(heightM / METERS_PER_PX)];
  return middles.map(([xM, yM]) => {
    const [left, bottom] = [pixelX(xM - widthM / 2), pixelY(yM - heightM / 2)];
    const rgb: number[] = [];
    for (let y = 0; y < heightPx; y++) for (let x = 0; x < widthPx; x++) rgb.push(...colorAt(picture, left + x, bottom + y));
    return { widthPx, heightPx, rgb };
  });
}

function readWall(): Uint8Array {
  const pixels = new Uint8Array(WIDTH_PX * HEIGHT_PX * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, WIDTH_PX, HEIGHT_PX, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

function colorAt(picture: Uint8Array, x: number, y: number): Uint8Array {
  return picture.subarray((y * WIDTH_PX + x) * 4, (y * WIDTH_PX + x) * 4 + 3);
}

const pixelX = (meters: number): number => Math.round(WIDTH_PX / 2 + (meters - MIDDLE_M[0]) / METERS_PER_PX);
const pixelY = (meters: number): number => Math.round(HEIGHT_PX / 2 + (meters - MIDDLE_M[1]) / METERS_PER_PX);
const metersX = (pixels: number): number => (pixels - WIDTH_PX / 2) * METERS_PER_PX + MIDDLE_M[0];
const metersY = (pixels: number): number => (pixels - HEIGHT_PX / 2) * METERS_PER_PX + MIDDLE_M[1];

export function problems(): readonly unknown[] {
  return [...told(), ...(gl.getError() === 0 ? [] : ['GL error'])];
}

export function end(): unknown {
  player.dispose();
  return player.counts();
}
