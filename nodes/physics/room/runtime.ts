import type { DepthFrame, PhysicsRoom } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DepthImage } from '../../kit/session.ts';
import type { definition } from './definition.ts';

/** Wider images are thinned: at 4 m, 160 texels over 60° are 3 cm apart, less than a voxel. */
const MAX_WIDTH_PX = 160;
/** Frames that wait for the worker at most. */
const MAX_FRAMES = 2;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { edgeM, speed, threshold, farM, friction, restitution } = ctx.config;
  const room: PhysicsRoom = { settings: { edgeM, speed, threshold, farM }, friction, restitution, version: 0, frames: [] };
  ctx.outputs.body.room = room;
  ctx.outputs.body.version++;
  let lastFrame = -1;
  let lastS = 0;
  let jumps = 0;
  let sessions = 0;

  function forget(): void {
    room.version++;
    room.frames.length = 0;
    lastFrame = -1;
  }
  return {
    update: (frame) => {
      // World space has moved, or it is another room.
      if (frame.jumps !== jumps || ctx.session.sessions !== sessions) forget();
      jumps = frame.jumps;
      ({ sessions } = ctx.session);
      if (ctx.inputs.clear.count > 0) forget();
      const image = ctx.session.depthImage(0);
      if (!image || image.frame === lastFrame) return;
      const deltaS = lastFrame < 0 ? 1 / 30 : ctx.clock.timeS - lastS;
      lastFrame = image.frame;
      lastS = ctx.clock.timeS;
      if (room.frames.length === MAX_FRAMES) room.frames.shift();
      const depth = depthFrame(image, deltaS);
      if (depth) room.frames.push(depth);
    },
    staysOnRepeat: true,
    reset: forget,
    dispose: () => {
      delete ctx.outputs.body.room;
      ctx.outputs.body.version++;
    },
  };
}

/**
 * A depth image for the grid, thinned, with the map from texels to rays.
 *
 * @returns Null for a projection or a UV matrix without inverse.
 */
export function depthFrame(image: DepthImage, deltaS: number): DepthFrame | null {
  const { meters, widthPx, heightPx, uvFromViewUv: u, clipFromView: c, worldFromView } = image;
  const stride = Math.max(1, Math.ceil(widthPx / MAX_WIDTH_PX));
  const width = Math.floor(widthPx / stride);
  const height = Math.floor(heightPx / stride);
  const thin = new Float32Array(width * height);
  for (let j = 0; j < height; j++) for (let i = 0; i < width; i++) thin[j * width + i] = meters[j * stride * widthPx + i * stride] ?? 0;
  // View UV from texture UV: the inverse of an affine map.
  const at = (list: Float32Array, i: number) => list[i] ?? 0;
  const determinant = at(u, 0) * at(u, 4) - at(u, 3) * at(u, 1);
  if (!(Math.abs(determinant) > 1e-9) || !(at(c, 0) > 0) || !(at(c, 5) > 0)) return null;
  const viewUv = (s: number, t: number): readonly [number, number] => {
    const p = s - at(u, 6);
    const q = t - at(u, 7);
    return [(at(u, 4) * p - at(u, 3) * q) / determinant, (at(u, 0) * q - at(u, 1) * p) / determinant];
  };
  const ray = (i: number, j: number): readonly [number, number] => {
    const [x, y] = viewUv((i * stride + 0.5) / widthPx, (j * stride + 0.5) / heightPx);
    return [(2 * x - 1 + at(c, 8)) / at(c, 0), (2 * y - 1 + at(c, 9)) / at(c, 5)];
  };
  const [x0, y0] = ray(0, 0);
  const [x1, y1] = ray(1, 0);
  const [x2, y2] = ray(0, 1);
  const rayFromTexel = [x1 - x0, x2 - x0, x0, y1 - y0, y2 - y0, y0];
  return { meters: thin, widthPx: width, heightPx: height, worldFromDepth: Float64Array.from(worldFromView), rayFromTexel, deltaS };
}
