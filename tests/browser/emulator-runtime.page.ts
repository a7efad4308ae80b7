/// <reference types="webxr" />
import { Matrix4, Vector3 } from 'three';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Capability } from '../../nodes/kit/definition.ts';
import type { Session, SessionEvent, SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';
import { createContext, lookAt } from './emulator-kit.ts';

const WANTED: readonly Capability[] = ['depth', 'camera-image', 'light-estimation'];
const NEEDS: readonly ProgramNeed[] = WANTED.map((capability) => ({ capability, required: false, nodes: [], why: '', without: '' }));

/** Places in a view, from its bottom left. */
const PLACES = [
  [0.5, 0.5],
  [0.21, 0.33],
  [0.77, 0.31],
  [0.4, 0.12],
  [0.62, 0.74],
] as const;

export interface SeenBySession {
  readonly kind: string;
  readonly world: string;
  readonly blend: string;
  readonly capabilities: readonly string[];
  readonly viewCount: number;
  readonly ownFramebuffer: boolean;
  /** Room depth of the session less a ray cast into the room, meters, per view and place. */
  readonly depthErrorsM: readonly number[];
  readonly depthsM: readonly number[];
  /** Largest difference of a byte between the session's camera image and the room as shown, at the places. */
  readonly cameraError: number;
  readonly light: readonly number[] | null;
  readonly hasReflection: boolean;
  readonly events: readonly string[];
  readonly diagnostics: readonly string[];
  readonly glError: number;
}

/** What the runtime's own WebXR session makes of an emulated device. */
export async function seeThroughSession(options: EmulatorOptions): Promise<SeenBySession> {
  const emulator = installEmulator({ clock: 'manual', sizePx: [320, 240], ...options });
  const gl = createContext();
  // To read floats back; what the session reads must not hang on it.
  gl.getExtension('EXT_color_buffer_float');
  emulator.setPose(lookAt([0.3, 1.5, 0.6], [-0.3, 0.6, -1.4]));
  const { output, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: NEEDS, antialias: false });
  if (!output) throw new Error(`No session: ${diagnostics.map(({ message }) => message).join(' ')}`);
  const events: string[] = [];
  const frames: Omit<SeenBySession, 'kind' | 'world' | 'blend' | 'capabilities' | 'events' | 'diagnostics' | 'glError'>[] = [];
  output.start(
    (frame) => frames.push(readFrame(gl, emulator, frame)),
    (event) => events.push(describeEvent(event)),
  );
  await emulator.frameRequested();
  await emulator.stepFrame(2);
  emulator.setTracked(false);
  await emulator.stepFrame();
  emulator.setTracked(true);
  emulator.recenter();
  await emulator.stepFrame();
  // Before the world was re-centered: the room is where the session says.
  const seen = frames[1];
  const glError = gl.getError();
  await output.end();
  await emulator.uninstall();
  if (!seen || frames.length !== 3) throw new Error(`${frames.length} frames instead of 3.`);
  return { ...describeSession(output), ...seen, events, diagnostics: diagnostics.map(({ code }) => code), glError };
}

function describeSession({ kind, world, blend, capabilities }: Session) {
  return { kind, world, blend, capabilities: [...capabilities].sort() };
}

function describeEvent(event: SessionEvent): string {
  return event.kind === 'tracking' ? `tracking ${event.tracked}` : event.kind;
}

type Emulator = ReturnType<typeof installEmulator>;

function readFrame(gl: WebGL2RenderingContext, emulator: Emulator, frame: SessionFrame) {
  const views = frame.views.slice(0, frame.viewCount);
  const room = emulator.readRoom();
  const depths = views.flatMap((view) => PLACES.map(([u, v]) => depthAt(gl, emulator, view, u, v)));
  const camera = views.flatMap((view) =>
    PLACES.map(([u, v]) => {
      const image = view.cameraImage;
      if (!image) return 0;
      const seen = readTexel(gl, image.texture, Math.floor(u * image.widthPx), Math.floor(v * image.heightPx), gl.UNSIGNED_BYTE);
      const column = view.viewport.x + Math.floor(u * view.viewport.widthPx);
      const row = room.heightPx - 1 - Math.floor(v * view.viewport.heightPx);
      return Math.max(...[0, 1, 2].map((c) => Math.abs((seen[c] ?? 0) - (room.rgba[(row * room.widthPx + column) * 4 + c] ?? 0))));
    }),
  );
  return {
    viewCount: frame.viewCount,
    ownFramebuffer: frame.framebuffer !== null,
    depthErrorsM: depths.map(({ errorM }) => errorM),
    depthsM: depths.map(({ meters }) => meters),
    cameraError: Math.max(...camera),
    hasReflection: gl.isTexture(frame.light?.reflection?.texture ?? null),
    light: frame.light && [...frame.light.sphericalHarmonics.slice(0, 3), ...frame.light.primaryDirectionWorld],
  };
}

/** The session's depth at a place of the view, against a ray through the center of the texel that it reads. */
function depthAt(gl: WebGL2RenderingContext, emulator: Emulator, view: ViewFrame, u: number, v: number) {
  const { depth } = view;
  if (!depth) return { meters: Number.NaN, errorM: Number.NaN };
  const m = depth.uvFromViewUv;
  const texelOf = (row: number, size: number): number => Math.floor(((m[row] ?? 0) * u + (m[row + 3] ?? 0) * v + (m[row + 6] ?? 0)) * size);
  const [column, row] = [texelOf(0, depth.widthPx), texelOf(1, depth.heightPx)];
  const [meters = Number.NaN] = readTexel(gl, depth.texture, column, row, gl.FLOAT);
  // Back from the texel's center to the view: the inverse of the 3 × 3 as a 4 × 4.
  const full = new Matrix4().set(m[0] ?? 0, m[3] ?? 0, 0, m[6] ?? 0, m[1] ?? 0, m[4] ?? 0, 0, m[7] ?? 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const inView = new Vector3((column + 0.5) / depth.widthPx, (row + 0.5) / depth.heightPx, 0).applyMatrix4(full.invert());
  const p = view.clipFromView;
  const direction = new Vector3((2 * inView.x - 1 + (p[8] ?? 0)) / (p[0] ?? 1), (2 * inView.y - 1 + (p[9] ?? 0)) / (p[5] ?? 1), -1);
  const length = direction.length();
  const worldFromView = new Matrix4().fromArray([...view.worldFromView]);
  const origin = new Vector3().setFromMatrixPosition(worldFromView);
  const cast = emulator.measure(origin.toArray(), direction.transformDirection(worldFromView).toArray());
  return { meters, errorM: meters - (cast ?? Number.NaN) / length };
}

function readTexel(gl: WebGL2RenderingContext, texture: WebGLTexture, x: number, y: number, type: GLenum): number[] {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const out = type === gl.FLOAT ? new Float32Array(4) : new Uint8Array(4);
  gl.readPixels(x, y, 1, 1, gl.RGBA, type, out);
  gl.deleteFramebuffer(framebuffer);
  return [...out];
}
