import type { Player } from '../../../export/runtime/player.ts';
import type { BodyList, PhysicsBody } from '../../../nodes/kit/physics.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { ToPreview } from '../../preview-protocol.ts';
import { boxOf } from '../gizmo/gizmo.ts';
import type { CaptureSource } from '../posters.ts';
import { createPencil, type Pencil } from './pencil.ts';

/** Controls the physics of the running program, and draws its bodies and voxels over the preview. */
export interface PhysicsView {
  receive(message: Extract<ToPreview, { kind: 'physics' | 'physics-drop' | 'physics-view' }>): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: CaptureSource | null): void;
}

const COLORS = { awake: '#ffb224', asleep: '#6aa6ff', fixed: '#7ac74f', voxel: 'rgb(90 220 200 / 55%)', touch: '#ff3d5e' } as const;
/** An arrow shows where a body will be after so long. */
const ARROW_S = 0.2;
/** How long the mark of a contact stays. */
const TOUCH_FRAMES = 20;
const TOUCH_PX = 6;

/** @param wake Requests a frame, also while the preview is paused. */
export function createPhysicsView(parent: HTMLElement, wake: () => void): PhysicsView {
  /** Whether a message has not reached the world yet. */
  let isPending = false;
  let isPaused = false;
  let steps = 0;
  let wantsReset = false;
  let drops: readonly string[] | null = null;
  let showsBodies = false;
  let showsVoxels = false;
  let pencil: Pencil | null = null;
  let touches: { readonly pointWorld: readonly number[]; left: number }[] = [];

  /** Hands what was asked to the world, which the next frame plays. */
  function control(bodies: readonly PhysicsBody[]): PhysicsBody['world'] {
    const world = bodies.find((body) => body.world !== null)?.world ?? null;
    if (!world) return null;
    world.control.isPaused = isPaused;
    world.control.steps += steps;
    world.control.wantsReset ||= wantsReset;
    world.control.wantsVoxels = showsVoxels;
    const nodes = drops;
    for (const body of nodes ? bodies : []) {
      if (nodes && nodes.length > 0 && !nodes.some((node) => body.key.startsWith(`${node}/`))) continue;
      body.targetVelocity.fill(0);
      body.jumps++;
    }
    if (steps > 0 || wantsReset || drops) wake();
    steps = 0;
    wantsReset = false;
    drops = null;
    return world;
  }
  function drawBodies(on: Pencil, bodies: readonly PhysicsBody[]): void {
    for (const body of bodies) {
      if (!body.world) continue;
      const color = body.description.mode === 'static' ? COLORS.fixed : body.isAsleep ? COLORS.asleep : COLORS.awake;
      for (const shape of body.description.shapes) on.shape(body.worldFromBody, shape, color);
      if (!body.isAsleep) on.arrow(body.worldFromBody, body.velocity, ARROW_S, color);
      for (let i = 0; i < body.touches.count; i++) {
        const touch = body.touches.entries[i];
        if (touch) touches.push({ pointWorld: [...touch.pointWorld], left: TOUCH_FRAMES });
      }
    }
    touches = touches.filter((touch) => touch.left-- > 0);
    for (const { pointWorld } of touches) on.dot(pointWorld, 0, TOUCH_PX, COLORS.touch);
  }

  return {
    receive: (message) => {
      isPending = true;
      if (message.kind === 'physics-view') {
        showsBodies = message.bodies;
        showsVoxels = message.voxels;
      } else if (message.kind === 'physics-drop') drops = message.nodes;
      else if (message.action === 'step') steps++;
      else if (message.action === 'reset') wantsReset = true;
      else isPaused = message.action === 'pause';
      wake();
    },
    afterFrame: (player, frame, place) => {
      // Other frames need no list of bodies.
      if (!isPending && !isPaused && !showsBodies && !showsVoxels) return;
      const bodies = bodiesOf(player);
      const world = control(bodies);
      // A new world plays by itself and shows nothing; steps, resets and drops wait for it.
      isPending = world === null && (steps > 0 || wantsReset || drops !== null);
      const box = place && boxOf(place.canvas, frame);
      const [view] = frame.views;
      if (!world || !box || !view || !(showsBodies || showsVoxels)) {
        pencil?.hide();
        return;
      }
      pencil ??= createPencil(parent);
      pencil.begin(view, box);
      const { voxels, edgeM } = world.control;
      if (showsVoxels && voxels) for (let i = 0; i < voxels.length; i += 3) pencil.dot(voxels.subarray(i, i + 3), edgeM, 1, COLORS.voxel);
      if (showsBodies) drawBodies(pencil, bodies);
      // So that tests can wait for it.
      pencil.canvas.dataset.bodies = String(showsBodies ? bodies.length : 0);
      pencil.canvas.dataset.voxels = String(showsVoxels && voxels ? voxels.length / 3 : 0);
    },
  };
}

/** All bodies that nodes of the running program list. */
function bodiesOf(player: Pick<Player, 'inspect'>): PhysicsBody[] {
  const inspected = player.inspect(null);
  const lists = new Set<BodyList>();
  for (const resource of inspected?.resources.values() ?? []) if (resource.kind === 'bodies') lists.add(resource.list);
  return [...new Set([...lists].flatMap(({ bodies }) => bodies))];
}
