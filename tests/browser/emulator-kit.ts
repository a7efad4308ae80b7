/// <reference types="webxr" />
import type { Emulator } from '../../export/emulator/emulator.ts';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';

/** A page in a session of an emulated device with a manual clock, as a test drives it. */
export interface Stage {
  readonly emulator: Emulator;
  readonly session: XRSession;
  readonly gl: WebGL2RenderingContext;
  readonly layer: XRWebGLLayer;
  readonly binding: XRWebGLBinding;
  readonly space: XRReferenceSpace;
  /** Steps one frame and gives what the page made of it. */
  frame<T>(draw: (frame: XRFrame, pose: XRViewerPose, timeMs: number) => T): Promise<T>;
  leave(): Promise<void>;
}

export async function enter(options: EmulatorOptions, init: XRSessionInit = {}): Promise<Stage> {
  const emulator = installEmulator({ clock: 'manual', ...options });
  const stage = await enterWith(emulator, init);
  return {
    ...stage,
    leave: async () => {
      await stage.leave();
      await emulator.uninstall();
    },
  };
}

/** With a device that stays when the session is left. */
export async function enterWith(emulator: Emulator, init: XRSessionInit = {}, gl = createContext()): Promise<Stage> {
  const session = await requestSession(init);
  let ended = false;
  session.addEventListener('end', () => {
    ended = true;
  });
  const layer = new XRWebGLLayer(session, gl);
  session.updateRenderState({ baseLayer: layer });
  const space = await session.requestReferenceSpace('local-floor');
  return {
    emulator,
    session,
    gl,
    layer,
    binding: new XRWebGLBinding(session, gl),
    space,
    frame: async (draw) => {
      const result = new Promise<ReturnType<typeof draw>>((resolve, reject) => {
        session.requestAnimationFrame((timeMs, frame) => {
          try {
            resolve(draw(frame, frame.getViewerPose(space) as XRViewerPose, timeMs));
          } catch (error) {
            reject(error);
          }
        });
      });
      await emulator.stepFrame();
      return result;
    },
    leave: async () => {
      if (!ended) await session.end();
    },
  };
}

export function requestSession(init: XRSessionInit, mode: XRSessionMode = 'immersive-ar'): Promise<XRSession> {
  const { xr } = navigator;
  if (!xr) throw new Error('There is no navigator.xr.');
  const requiredFeatures = [...(init.requiredFeatures ?? []), 'local-floor'];
  return xr.requestSession(mode, { ...init, requiredFeatures });
}

export function createContext(
  attributes: WebGLContextAttributes & { xrCompatible?: boolean } = { xrCompatible: true },
): WebGL2RenderingContext {
  const gl = document.createElement('canvas').getContext('webgl2', attributes);
  if (!gl) throw new Error('No WebGL 2 here.');
  return gl;
}

/** The name of the error that `act` rejects with or throws, or null. */
export async function nameOfError(act: () => unknown): Promise<string | null> {
  try {
    await act();
    return null;
  } catch (error) {
    return nameOf(error);
  }
}

/** At once, as is needed while a frame lasts. */
export function nameOfThrow(act: () => unknown): string | null {
  try {
    act();
    return null;
  } catch (error) {
    return nameOf(error);
  }
}

function nameOf(error: unknown): string {
  return error instanceof Error || error instanceof DOMException ? error.name : String(error);
}

export function first<T>(list: readonly T[]): T {
  const [value] = list;
  if (value === undefined) throw new Error('The list is empty.');
  return value;
}

/** Position and look direction as a pose. */
export function lookAt(eye: Triple, target: Triple): { readonly matrix: number[] } {
  const z = unit([eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]]);
  const x = unit([z[2], 0, -z[0]]);
  const y: Triple = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
  return { matrix: [...x, 0, ...y, 0, ...z, 0, ...eye, 1] };
}

export type Triple = readonly [number, number, number];

function unit([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

/** A floor, and a table of 80 cm in front. */
const FLOOR = { label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [8, 0.1, 8] } as const;
const TABLE = { label: 'table', centerWorld: [0, 0.4, -2], sizeM: [1, 0.8, 1] } as const;
export const TABLE_ROOM = { boxes: [FLOOR, TABLE] };

/** In that room unless the options name another. */
export async function onStage<T>(options: EmulatorOptions, init: XRSessionInit, act: (stage: Stage) => Promise<T>): Promise<T> {
  const stage = await enter({ room: TABLE_ROOM, ...options }, init);
  try {
    return await act(stage);
  } finally {
    await stage.leave();
  }
}

export function point(p: DOMPointReadOnly | undefined): number[] {
  return p ? [round(p.x), round(p.y), round(p.z)] : [];
}

export function up(m: ArrayLike<number> | undefined): number[] {
  return [4, 5, 6].map((i) => round(m?.[i] ?? 0));
}

export function forward(m: ArrayLike<number> | undefined): number[] {
  return [8, 9, 10].map((i) => round(-(m?.[i] ?? 0)));
}

/** To a tenth of a millimeter, without negative zero. */
export function round(x: number): number {
  return Math.round(x * 1e4) / 1e4 + 0;
}
