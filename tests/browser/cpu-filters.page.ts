import type { Program } from '../../export/program/program.ts';
import { type StartWorker, startBlobWorker } from '../../export/runtime/cpu/worker-source.ts';
import type { Player } from '../../export/runtime/player.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { CpuAnswer, CpuTask, PlayedModule } from '../../nodes/kit/cpu-filter.ts';
import { servePixels } from '../../nodes/kit/serve-pixels.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { createGl, frame, HEIGHT, pixel, stand, texture, view, WIDTH } from './runtime-kit.ts';

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** Texts of workers that take the place of the node's own. */
const WORKERS: Readonly<Record<string, PlayedModule>> = {
  // Red and blue change places, times the param.
  swap: worker(`(pixels, { amount }) => {
    for (let i = 0; i < pixels.data.length; i += 4) {
      const red = pixels.data[i];
      pixels.data[i] = Math.round(pixels.data[i + 2] * amount);
      pixels.data[i + 2] = red;
    }
  }`),
  throwing: worker(`() => { throw new Error('the picture is too sad'); }`),
  broken: { worker: 'this is no script' },
};

function worker(process: string): PlayedModule {
  return { worker: `(${servePixels.toString()})(self, ${process});` };
}

export type Act = 'reset' | 'recompile' | 'half';

export interface PlayedFrames {
  /** By frame and view. */
  readonly shown: readonly (readonly number[][])[];
  readonly diagnostics: readonly unknown[];
  readonly error: number;
}

/**
 * Plays frames of a held player over cameras of one color per view, with a worker of ours in the node's place (`node` is its own).
 * `acts` is what to do before a frame.
 */
export async function playHeld(
  program: Program,
  which: string,
  cameras: readonly number[][][],
  acts: Readonly<Record<number, Act>> = {},
): Promise<PlayedFrames> {
  const gl = createGl();
  const { player, diagnostics } = await stand(program, { gl, modules: modules(which), held: true });
  player.setSession({ world: 'image', blend: 'opaque' });
  const shown: number[][][] = [];
  for (const [index, colors] of cameras.entries()) {
    if (acts[index] === 'reset') player.reset();
    if (acts[index] === 'half') player.setParam('cpu-a', 'amount', 0.5);
    if (acts[index] === 'recompile') await player.replaceProgram({ ...program, title: 'another' });
    await player.drawSettled(frame(index, viewsOf(gl, colors)));
    shown.push(colors.map((_, i) => pixel(gl, (i + 0.5) * (WIDTH / colors.length), HEIGHT / 2)));
  }
  const told = diagnostics();
  player.dispose();
  return { shown, diagnostics: told, error: gl.getError() };
}

export interface Running {
  /** How many frames were drawn until the screen showed the worker's picture of the camera's new color. */
  readonly framesLate: readonly number[];
  /** How many buffers of pixels were made in all. */
  readonly buffers: number;
  readonly leaks: readonly string[];
  readonly diagnostics: readonly unknown[];
  readonly error: number;
}

/** Plays as a page does, a frame a repaint, and changes the camera's color whenever the last has come through. */
export async function playRunning(program: Program, colors: readonly number[][]): Promise<Running> {
  const gl = createGl();
  const tracked = trackGl(gl);
  let buffers = 0;
  /** What came back is another object around the same memory. */
  const returned = new WeakSet<ArrayBuffer>();
  const startWorker: StartWorker = (text, { onMessage, onFailure }) => {
    const remember = (answer: unknown): void => {
      returned.add((answer as CpuAnswer).buffer);
      onMessage(answer);
    };
    const started = startBlobWorker(text, { onMessage: remember, onFailure });
    const post = (task: unknown, transfer: readonly ArrayBuffer[]): void => {
      if (!returned.has((task as CpuTask).buffer)) buffers++;
      started.post(task, transfer);
    };
    return { post, dispose: started.dispose };
  };
  const { player, diagnostics } = await stand(program, { gl, modules: modules('swap'), startWorker });
  player.setSession({ world: 'image', blend: 'opaque' });
  const stages = colors.map((camera) => ({ camera, screen: [camera[2] ?? 0, camera[1] ?? 0, camera[0] ?? 0, 255] }));
  const framesLate = await playStages(gl, player, stages, 0);
  const told = diagnostics();
  player.dispose();
  return { framesLate, buffers, leaks: tracked.report(), diagnostics: told, error: gl.getError() };
}

/** Colors of the camera image and, once it is played, of the screen: RGBA bytes. */
interface Colors {
  readonly camera: number[];
  readonly screen: readonly number[];
}

/** Draws a frame per repaint, and changes the camera when the screen shows its color. Returns by how many frames each was late. */
async function playStages(gl: WebGL2RenderingContext, player: Player, stages: readonly Colors[], tolerance: number): Promise<number[]> {
  const framesLate: number[] = [];
  let index = 0;
  for (const { camera, screen } of stages) {
    const views = viewsOf(gl, [camera]);
    for (let late = 0; ; late++) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      player.draw(frame(index++, views));
      const seen = pixel(gl, WIDTH / 2, HEIGHT / 2);
      if (seen.every((value, i) => Math.abs(value - (screen[i] ?? 0)) <= tolerance)) {
        framesLate.push(late);
        break;
      }
      if (late > 1000) throw new Error(`The screen shows ${seen.join()} for ever.`);
    }
    gl.deleteTexture(views[0]?.cameraImage?.texture ?? null);
  }
  return framesLate;
}

/** Plays a program as a page does until a pixel of the screen has a color, and then again with another camera. */
export async function playUntil(program: Program, stages: readonly Colors[]) {
  const gl = createGl();
  const tracked = trackGl(gl);
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES });
  player.setSession({ world: 'image', blend: 'opaque' });
  const framesLate = await playStages(gl, player, stages, 1);
  const told = diagnostics();
  player.dispose();
  return { framesLate, leaks: tracked.report(), diagnostics: told, error: gl.getError() };
}

function modules(which: string): Readonly<Record<string, PlayedModule>> {
  const own = WORKERS[which];
  return own ? { ...RUNTIMES, 'filter/cpu-equalize-histogram': own } : RUNTIMES;
}

function viewsOf(gl: WebGL2RenderingContext, colors: readonly number[][]) {
  const widthPx = WIDTH / colors.length;
  return colors.map((color, i) =>
    view(i * widthPx, 0, widthPx, HEIGHT, {
      cameraImage: { texture: texture(gl, 1, 1, color), widthPx: 1, heightPx: 1, uvFromViewUv: UPRIGHT },
    }),
  );
}
