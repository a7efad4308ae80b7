import type { Program } from '../../export/program/program.ts';
import type { Player } from '../../export/runtime/player.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { createSessionInput, nextTap } from '../../export/runtime/sessions/input/session-input.ts';
import { setFrustum, setRigidInverse } from '../../export/runtime/sessions/matrix.ts';
import type { SlotValue } from '../../export/runtime/values/slots.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand, view } from './runtime-kit.ts';

/** What is done before a frame. */
export interface Deed {
  readonly params?: readonly (readonly [node: string, param: string, value: SlotValue])[];
  readonly taps?: number;
  readonly stick?: readonly [number, number];
}

export interface CellLook {
  /** Middle of what is bright in the cell, metres from the foot of its rail; null where nothing is. */
  readonly ball: readonly [number, number] | null;
  /** In the middle of the cell, bytes. */
  readonly color: readonly number[];
}

const WIDTH_PX = 960;
const HEIGHT_PX = 720;
/** The wall is looked at straight on: its middle, how far away, and what is seen of it from top to bottom. */
const EYE = [0, 0.86, 1.8] as const;
const SEEN_M = 1.36;
const METRES_PER_PX = SEEN_M / HEIGHT_PX;
/** What belongs to a cell around the foot of its rail, metres. */
const CELL_M = { side: 0.105, below: 0.042, above: 0.178, middle: 0.07 } as const;
/** A ball, but no rail and no background. */
const BRIGHT = 100;

let gl: WebGL2RenderingContext;
let player: Player;
let told: () => readonly unknown[];
let index = 0;
const input = createSessionInput();
const wall = view(0, 0, WIDTH_PX, HEIGHT_PX);

export async function begin(program: Program): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.width = WIDTH_PX;
  canvas.height = HEIGHT_PX;
  document.body.append(canvas);
  gl = canvas.getContext('webgl2', { antialias: false, depth: true, preserveDrawingBuffer: true }) as WebGL2RenderingContext;
  const made = await stand(program, { gl, modules: RUNTIMES, createScenes });
  player = made.player;
  told = made.diagnostics;
  player.setSession({ world: 'none', blend: 'opaque' });
  const y = (SEEN_M / 2 / EYE[2]) as number;
  const x = (y * WIDTH_PX) / HEIGHT_PX;
  setFrustum(wall.clipFromView, -x, x, -y, y, 0.1, 100);
  wall.worldFromView.set(EYE, 12);
  setRigidInverse(wall.viewFromWorld, wall.worldFromView);
}

/** Frames of a thirtieth of a second up to this one, after the deed; only the last is drawn. */
export function playTo(last: number, { params = [], taps = 0, stick }: Deed = {}): void {
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
    player.draw(frame(index, index === last ? [wall] : [], { input }));
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
export function look(feet: readonly (readonly [number, number])[]): CellLook[] {
  const pixels = new Uint8Array(WIDTH_PX * HEIGHT_PX * 4);
  gl.readPixels(0, 0, WIDTH_PX, HEIGHT_PX, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const at = (x: number, y: number) => pixels.subarray((y * WIDTH_PX + x) * 4, (y * WIDTH_PX + x) * 4 + 3);
  return feet.map(([footX, footY]) => {
    const px = (metres: number) => Math.round(WIDTH_PX / 2 + (metres - EYE[0]) / METRES_PER_PX);
    const py = (metres: number) => Math.round(HEIGHT_PX / 2 + (metres - EYE[1]) / METRES_PER_PX);
    let [count, sumX, sumY] = [0, 0, 0];
    for (let y = py(footY - CELL_M.below); y < py(footY + CELL_M.above); y++) {
      for (let x = px(footX - CELL_M.side); x < px(footX + CELL_M.side); x++) {
        if (Math.max(...at(x, y)) < BRIGHT) continue;
        count++;
        sumX += x + 0.5;
        sumY += y + 0.5;
      }
    }
    const ball =
      count === 0
        ? null
        : ([
            (sumX / count - WIDTH_PX / 2) * METRES_PER_PX + EYE[0] - footX,
            (sumY / count - HEIGHT_PX / 2) * METRES_PER_PX + EYE[1] - footY,
          ] as const);
    return { ball, color: [...at(px(footX), py(footY + CELL_M.middle))] };
  });
}

export function problems(): readonly unknown[] {
  return [...told(), ...(gl.getError() === 0 ? [] : ['GL error'])];
}

export function end(): unknown {
  player.dispose();
  return player.counts();
}
