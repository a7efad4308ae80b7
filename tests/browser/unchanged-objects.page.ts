import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createPlayer, type Player } from '../../export/runtime/player.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { setRigidInverse } from '../../export/runtime/sessions/matrix.ts';
import { createOrbit, ORBIT_DEFAULTS } from '../../export/runtime/sessions/orbit/orbit-pose.ts';
import { createSpatial } from '../../export/runtime/spatial/create-spatial.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { ParamValue } from '../../nodes/kit/definition.ts';
import type { SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';
import { createGl, frame, HEIGHT, texture, view, WIDTH } from './runtime-kit.ts';

/** Plays compiled programs frame by frame like a page does, and counts what is drawn. */

interface Playing {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly room: WebGLTexture;
  readonly draws: { count: number };
  readonly input: ReturnType<typeof SESSION_INPUTS.page>;
}

let playing: Playing | null = null;
let index = 0;
let azimuthRad = 0.3;
let hasRoom = false;

const FRAMES_OF_REST = 30;

const CALLS = [
  'drawArrays',
  'drawElements',
  'drawArraysInstanced',
  'drawElementsInstanced',
  'drawRangeElements',
  'clear',
  'clearBufferfv',
] as const;

/** Opens a program that looks at the origin from 2 m in a session without a camera. Files are loaded from below `assetUrl`. */
export async function open(program: Program, assetUrl: string): Promise<void> {
  playing?.player.dispose();
  playing?.input.dispose();
  index = 0;
  azimuthRad = 0.3;
  hasRoom = false;
  const gl = createGl({ depth: true });
  const assets = createFetchAssetSource(new URL(assetUrl, location.href).href, (...args) => fetch(...args));
  const canvas = gl.canvas as HTMLCanvasElement;
  const player = createPlayer({
    gl,
    canvas,
    program,
    modules: RUNTIMES,
    createScenes,
    createSpatial,
    assets,
    seed: 1,
    onDiagnostics: () => {},
  });
  await player.ready;
  player.setSession({ world: 'virtual', blend: 'opaque' } as never);
  const draws = { count: 0 };
  const context = gl as unknown as Record<string, (...args: unknown[]) => unknown>;
  for (const name of CALLS) {
    const call = context[name];
    context[name] = (...args) => {
      draws.count++;
      return call?.apply(gl, args);
    };
  }
  canvas.style.cssText = `position: fixed; left: 0; top: 0; width: ${WIDTH}px; height: ${HEIGHT}px`;
  document.body.append(canvas);
  playing = { gl, player, room: roomTexture(gl), draws, input: SESSION_INPUTS.page(canvas) };
}

/** Replaces the program as the preview does after an edit. Unchanged nodes are kept. */
export async function replace(program: Program): Promise<void> {
  await opened().player.replaceProgram(program);
}

/** Draws the changes of a frame. Returns the number of calls that draw or clear. */
export function next(widthPx = WIDTH): number {
  const { player, draws } = opened();
  draws.count = 0;
  player.drawChanges(frameOf(index++, widthPx));
  return draws.count;
}

/** Draws frames as the browser asks for them until one draws nothing. Returns the number that drew something. */
export async function untilStill(): Promise<number> {
  for (let frames = 0; ; frames++) {
    if (next() === 0) return frames;
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }
}

/** Draws frames as the browser asks for them until many in a row draw nothing, as after the answer of a worker. */
export async function untilRest(): Promise<void> {
  for (let still = 0; still < FRAMES_OF_REST; ) {
    still = next() === 0 ? still + 1 : 0;
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }
}

/** Draws frames as the browser asks for them until one draws something. */
export async function untilDrawn(): Promise<void> {
  while (next() === 0) await new Promise((resolve) => requestAnimationFrame(resolve));
}

export function setParam(node: string, param: string, value: ParamValue): void {
  opened().player.setParam(node, param, value);
}

export function turnCamera(): void {
  azimuthRad += 0.4;
}

/** Presses, or moves or lifts, a mouse at a fraction of the canvas from its top left. */
export function point(type: 'pointerdown' | 'pointermove' | 'pointerup', x: number, y: number): void {
  const pointer = { pointerId: 1, pointerType: 'mouse', isPrimary: true, bubbles: true, button: 0, buttons: type === 'pointerup' ? 0 : 1 };
  opened().gl.canvas.dispatchEvent(new PointerEvent(type, { ...pointer, clientX: x * WIDTH, clientY: y * HEIGHT }));
}

/** Whether the session knows the depth of the room from now on. */
export function showRoom(shows: boolean): void {
  hasRoom = shows;
}

export function reset(): void {
  opened().player.reset();
}

export async function loseContext(): Promise<void> {
  const { player } = opened();
  player.contextLost();
  await player.restore();
}

/** A hash of the canvas as it is, and of the same frame drawn in full. */
export function images(): { readonly kept: number; readonly drawn: number } {
  const { player, gl } = opened();
  const kept = hashOf(gl);
  player.draw(frameOf(index - 1, WIDTH));
  return { kept, drawn: hashOf(gl) };
}

/** The canvas as it is: RGBA. */
export function pixels(): number[] {
  return [...pixelsOf(opened().gl)];
}

function opened(): Playing {
  if (!playing) throw new Error('Nothing is open.');
  return playing;
}

function frameOf(at: number, widthPx: number): SessionFrame {
  const { input } = opened();
  const made = frame(at, [seen(widthPx)]);
  input.fill(made as Parameters<typeof input.fill>[0]);
  return made;
}

function seen(widthPx: number): ViewFrame {
  const depth = { texture: opened().room, widthPx: 1, heightPx: 1, uvFromViewUv: UPRIGHT, worldFromDepth: new Float32Array(16) };
  const made = view(0, 0, widthPx, HEIGHT, hasRoom ? { depth } : {});
  createOrbit({ ...ORBIT_DEFAULTS, targetWorld: [0, 0, 0], distanceM: 2, azimuthRad, elevationRad: 0.4 }).writeWorldFromView(
    made.worldFromView,
  );
  setRigidInverse(made.viewFromWorld, made.worldFromView);
  return made;
}

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

function roomTexture(gl: WebGL2RenderingContext): WebGLTexture {
  const made = texture(gl, 1, 1, [0, 0, 0, 0]);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, 1, 1, 0, gl.RED, gl.FLOAT, new Float32Array([1]));
  return made;
}

function pixelsOf(gl: WebGL2RenderingContext): Uint8Array {
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const bytes = new Uint8Array(WIDTH * HEIGHT * 4);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes;
}

function hashOf(gl: WebGL2RenderingContext): number {
  return pixelsOf(gl).reduce((hash, byte) => (Math.imul(hash, 31) + byte) | 0, 7);
}
