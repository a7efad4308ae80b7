import { PerspectiveCamera } from 'three';
import type { Program } from '../../../export/program/program.ts';
import { coverCanvas, createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import type { Session } from '../../../nodes/kit/session.ts';
import { type Drawn, measureFrames } from './frame-ms.ts';
import { countCalls, type GlCalls, startCounting } from './gl-calls.ts';
import { createGpuBytes, type GpuBytes } from './gpu-bytes.ts';
import { type MeasuredPlayer, openPlayer } from './measured-player.ts';
import { AMBIENT, EYE_M, FOV_DEG, LOOK_M, type RoomPlan, SUN_IRRADIANCE, TOWARDS_SUN } from './room-plan.ts';

/** Plays a program like an AR device with constant depth and light. The cost of WebXR itself is measured separately. */
export async function open(program: Program, plan: RoomPlan): Promise<void> {
  if (plan.counted) startCounting();
  const canvas = document.createElement('canvas');
  canvas.width = plan.widthPx;
  canvas.height = plan.heightPx;
  document.body.append(canvas);
  const gl = canvas.getContext('webgl2', { alpha: true, antialias: true, depth: true, stencil: false });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  bytes = createGpuBytes(gl);
  measured = await openPlayer(gl, canvas, program, document.baseURI);
  const { player } = measured;
  const frame = createRoomFrame(gl);
  player.setSession(ROOM);
  // After this, models and other assets have loaded.
  await player.drawSettled(frame);
  drawn = {
    gl,
    draw: (deltaS) => {
      frame.deltaS = deltaS;
      frame.timeS += deltaS;
      player.draw(frame);
      frame.index++;
    },
  };
}

const ROOM: Session = {
  kind: 'webxr',
  capabilities: new Set(['depth', 'light-estimation']),
  world: 'device',
  blend: 'alpha',
  start: () => {},
  end: async () => {},
};

function createRoomFrame(gl: WebGL2RenderingContext): ReturnType<typeof createSessionFrame> {
  const frame = createSessionFrame();
  const view = coverCanvas(frame, gl);
  const camera = new PerspectiveCamera(FOV_DEG, gl.drawingBufferWidth / gl.drawingBufferHeight, view.nearM, view.farM);
  camera.position.set(...EYE_M);
  camera.lookAt(...LOOK_M);
  camera.updateMatrixWorld();
  view.clipFromView.set(camera.projectionMatrix.elements);
  view.worldFromView.set(camera.matrixWorld.elements);
  view.viewFromWorld.set(camera.matrixWorldInverse.elements);
  view.depth = {
    texture: farDepth(gl),
    widthPx: DEPTH_PX[0],
    heightPx: DEPTH_PX[1],
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
    worldFromDepth: view.worldFromView,
  };
  const sphericalHarmonics = new Float32Array(27);
  // Ambient white light has only the constant coefficient: radiance × √(4π).
  sphericalHarmonics.fill(AMBIENT * Math.sqrt(4 * Math.PI), 0, 3);
  frame.light = {
    sphericalHarmonics,
    primaryDirectionWorld: Float32Array.from(TOWARDS_SUN),
    primaryIntensity: Float32Array.from(SUN_IRRADIANCE),
    reflection: null,
  };
  return frame;
}

/** Depth resolution of phones. */
const DEPTH_PX = [160, 90] as const;

/** A depth texture that says 20 m everywhere, so that it hides nothing. */
function farDepth(gl: WebGL2RenderingContext): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, ...DEPTH_PX, 0, gl.RED, gl.FLOAT, new Float32Array(DEPTH_PX[0] * DEPTH_PX[1]).fill(20));
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  return texture;
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (measured?.wrong) throw new Error(measured.wrong);
  if (drawn?.gl.isContextLost()) throw new Error(LOST);
  if (!drawn) throw new Error('Nothing is open.');
  return measureFrames(drawn, count);
}

/** Calls of WebGL in one frame, of a counted plan. */
export function glCalls(): GlCalls {
  if (!drawn) throw new Error('Nothing is open.');
  return countCalls(drawn);
}

/** Bytes of all textures on the GPU. */
export function textureBytes(): number {
  return bytes?.textures() ?? 0;
}

/** The image as a data URL, for a person to look at. */
export function picture(): string {
  if (!drawn) throw new Error('Nothing is open.');
  drawn.draw(0);
  return (drawn.gl.canvas as HTMLCanvasElement).toDataURL();
}

/** Error message for a lost context. Drivers lose it when they run out of memory. */
const LOST = 'The graphics were lost.';
let drawn: Drawn | null = null;
let measured: MeasuredPlayer | null = null;
let bytes: GpuBytes | null = null;
