import { FloatType, Matrix4, NearestFilter, RGBAFormat, WebGLRenderTarget } from 'three';
import { aimCamera, createEyeCamera } from '../display/eye.ts';
import type { RoomView } from '../display/room-view.ts';
import type { Room } from '../rooms/room.ts';
import { type CubeFace, projectCube } from './spherical-harmonics.ts';

/** Light estimated from rendered images of the room, so that it agrees with what the user sees. */
export interface RoomLight {
  /** 27 numbers, linear-sRGB radiance, world space. */
  readonly sphericalHarmonics: Float32Array;
  readonly directionWorld: readonly [number, number, number];
  readonly intensity: readonly [number, number, number];
  /** Faces +x, −x, +y, −y, +z, −z in the order of GL (row 0 is t = 0): RGBA, linear radiance. */
  readonly cubeFaces: readonly Float32Array[];
  readonly cubeSizePx: number;
}

const CUBE_SIZE_PX = 32;

/**
 * Camera axes per face of a GL cube map (OpenGL ES 3.0 §3.8.10). Seen from inside, a face is rotated by half a turn: s runs along −`right`,
 * t along −`up`.
 */
const FACES = [
  { forward: [1, 0, 0], right: [0, 0, 1], up: [0, 1, 0] },
  { forward: [-1, 0, 0], right: [0, 0, -1], up: [0, 1, 0] },
  { forward: [0, 1, 0], right: [-1, 0, 0], up: [0, 0, -1] },
  { forward: [0, -1, 0], right: [-1, 0, 0], up: [0, 0, 1] },
  { forward: [0, 0, 1], right: [-1, 0, 0], up: [0, 1, 0] },
  { forward: [0, 0, -1], right: [1, 0, 0], up: [0, 1, 0] },
] as const;

/** Renders the room into a cube map at `room.probeWorld` and projects it on spherical harmonics. Leaves the renderer's target unset. */
export function measureLight(view: RoomView, room: Room): RoomLight {
  const target = new WebGLRenderTarget(CUBE_SIZE_PX, CUBE_SIZE_PX, {
    format: RGBAFormat,
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
  });
  const camera = createEyeCamera();
  const clipFromView = new Matrix4().makePerspective(-0.05, 0.05, 0.05, -0.05, 0.05, 100);
  const faces = FACES.map(({ forward, right, up }): CubeFace => {
    const back = forward.map((n) => -n);
    aimCamera(camera, clipFromView.elements, [...right, 0, ...up, 0, ...back, 0, ...room.probeWorld, 1]);
    view.renderer.setRenderTarget(target);
    view.renderer.setClearColor(0x000000, 1);
    view.renderer.clear();
    view.renderer.render(view.scene, camera);
    const rgba = new Float32Array(CUBE_SIZE_PX * CUBE_SIZE_PX * 4);
    view.renderer.readRenderTargetPixels(target, 0, 0, CUBE_SIZE_PX, CUBE_SIZE_PX, rgba);
    return { rgba, forward, right, up };
  });
  view.renderer.setRenderTarget(null);
  target.dispose();
  return {
    sphericalHarmonics: projectCube(faces, CUBE_SIZE_PX),
    directionWorld: room.primaryLight.directionWorld,
    intensity: room.primaryLight.intensity,
    cubeFaces: faces.map(({ rgba }) => halfTurn(rgba)),
    cubeSizePx: CUBE_SIZE_PX,
  };
}

/** Rotates rows read from the bottom to rows from t = 0. */
function halfTurn(rgba: Float32Array): Float32Array {
  const out = new Float32Array(rgba.length);
  for (let i = 0; i < rgba.length; i += 4) out.set(rgba.subarray(i, i + 4), rgba.length - 4 - i);
  return out;
}
