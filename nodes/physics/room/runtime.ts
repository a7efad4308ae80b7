import type { DepthFrame, PhysicsRoom } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DepthImage } from '../../kit/session.ts';
import type { definition } from './definition.ts';
import { createDepthFrames } from './depth-frames.ts';

/** The most depth frames that wait for the worker. */
const MAX_FRAMES = 2;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { edgeM, speed, threshold, farM, friction, restitution, surface } = ctx.config;
  const settings = { edgeM, speed, threshold, farM, isSmooth: surface === 'smooth' };
  const room: PhysicsRoom = { settings, friction, restitution, version: 0, frames: [] };
  // One more than can wait: the world has copied the others when it returns.
  const depthFrames = createDepthFrames(MAX_FRAMES + 1);
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
  function add(image: DepthImage, deltaS: number): void {
    if (room.frames.length === MAX_FRAMES) room.frames.shift();
    const frame: DepthFrame | null = depthFrames.write(image, deltaS);
    if (frame) room.frames.push(frame);
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
      add(image, deltaS);
    },
    staysOnRepeat: true,
    reset: forget,
    dispose: () => {
      delete ctx.outputs.body.room;
      ctx.outputs.body.version++;
    },
  };
}
