import { createPhysicsRoom, type DepthFrame } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { DepthImage } from '../../kit/session.ts';
import { readVoxelFile } from '../../kit/voxel-file.ts';
import type { definition } from './definition.ts';
import { createDepthFrames } from './depth-frames.ts';
import { createKeptRoom } from './kept-room.ts';
import { createSurfaceBodies } from './surface-bodies.ts';
import { createVoxelRays } from './voxel-rays.ts';

/** The most depth frames that wait for the worker. */
const MAX_FRAMES = 2;
/** Seconds between two copies of the voxels that answer rays. While the clock is held each frame has one, as renders do not wait. */
const COPY_EVERY_S = 0.5;
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] as const;
const FIXED = {
  mode: 'static',
  massKg: 0,
  densityKgPerM3: 0,
  rollingM: 0,
  linearDamping: 0,
  angularDamping: 0,
  gravityFactor: 0,
} as const;
const OTHER_VOXELS = {
  code: 'SCR057',
  severity: 'info',
  message: 'The room of the recording has voxels of another size. It is measured anew.',
} as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { edgeM, speed, threshold, farM, friction, restitution, surface, depth, planes, meshes, keep } = ctx.config;
  const settings = { edgeM, speed, threshold, farM, isSmooth: surface === 'smooth' };
  const room = createPhysicsRoom(settings, friction, restitution);
  // One more than can wait: the world has copied the others when it returns.
  const depthFrames = createDepthFrames(MAX_FRAMES + 1);
  if (depth) ctx.outputs.body.room = room;
  ctx.outputs.body.version++;
  const surfaces =
    planes || meshes ? createSurfaceBodies(ctx.node, ctx.outputs.body, { ...FIXED, friction, restitution }, { planes, meshes }) : null;
  const kept = keep && depth ? createKeptRoom(ctx.node, ctx.session, room, ctx.report) : null;
  const rays = createVoxelRays();
  const endAnswers = depth ? ctx.session.answerRays(rays) : null;
  /** The file of which the rays have a copy, and when they last asked for one. */
  let copied: Uint8Array | null = null;
  let copiedS = Number.NEGATIVE_INFINITY;
  /** The voxels with which the recording begins, if they are in the grid. */
  let recorded: Uint8Array | null = null;
  let lastFrame = -1;
  let lastS = 0;
  let jumps = 0;
  let sessions = 0;

  /** The former voxels are no longer those of the room. */
  function change(): void {
    room.changes++;
    rays.clear();
    copiedS = Number.NEGATIVE_INFINITY;
  }
  /** Copies the voxels for rays, once they may come. */
  function copyForRays(): void {
    if (!rays.isAsked) return;
    if (room.file && room.file !== copied && room.fileChanges === room.changes) {
      copied = room.file;
      rays.read(copied);
    }
    const { timeS, held } = ctx.clock;
    if (!held && timeS - copiedS < COPY_EVERY_S && timeS >= copiedS) return;
    copiedS = timeS;
    room.wantsFile = true;
  }
  function forget(): void {
    room.version++;
    change();
    room.frames.length = 0;
    room.edits.length = 0;
    recorded = null;
    lastFrame = -1;
  }
  /** World space has moved by a transform, or to an unknown place. */
  function move(worldFromFormer: ArrayLike<number> | null): void {
    if (!worldFromFormer) {
      forget();
      return;
    }
    room.frames.length = 0;
    room.edits.push({ kind: 'move', worldFromFormer });
    change();
  }
  function loadRecorded(file: Uint8Array | null): void {
    if (file === recorded) return;
    recorded = file;
    if (!file) return;
    const { voxels } = readVoxelFile(file);
    if (voxels && Math.abs(voxels.edgeM - edgeM) < 1e-4) {
      room.edits.push({ kind: 'load', file, worldFromFile: IDENTITY });
      change();
    } else ctx.report(OTHER_VOXELS);
  }
  function add(image: DepthImage, deltaS: number): void {
    if (room.frames.length === MAX_FRAMES) room.frames.shift();
    const frame: DepthFrame | null = depthFrames.write(image, deltaS, room.spent);
    if (frame) room.frames.push(frame);
  }
  return {
    update: (frame) => {
      surfaces?.update(frame.surfaces ?? null);
      if (!depth) return;
      const isOtherRoom = ctx.session.sessions !== sessions;
      if (isOtherRoom) {
        forget();
        kept?.leave();
      } else if (frame.jumps !== jumps) move(frame.worldFromFormer ?? null);
      jumps = frame.jumps;
      ({ sessions } = ctx.session);
      if (ctx.inputs.clear.count > 0) {
        forget();
        kept?.forget();
      }
      loadRecorded(frame.roomFile ?? null);
      const image = ctx.session.depthImage(0);
      kept?.update(ctx.clock.timeS, image?.worldFromView ?? null);
      copyForRays();
      if (!image || image.frame === lastFrame) return;
      const deltaS = lastFrame < 0 ? 1 / 30 : ctx.clock.timeS - lastS;
      lastFrame = image.frame;
      lastS = ctx.clock.timeS;
      add(image, deltaS);
    },
    staysOnRepeat: true,
    reset: forget,
    dispose: () => {
      kept?.leave();
      endAnswers?.();
      delete ctx.outputs.body.room;
      ctx.outputs.body.version++;
    },
  };
}
