import type { Player } from '../../../export/runtime/player.ts';
import type { BodyList, BodyWorld, PhysicsBody, PhysicsRoom } from '../../../nodes/kit/physics.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { FromPreview, ToPreview } from '../../preview-protocol.ts';
import { boxOf } from '../gizmo/gizmo.ts';
import type { CaptureSource } from '../posters.ts';
import { type BodyDrag, createBodyDrag } from './body-drag.ts';
import { createPencil, type Pencil } from './pencil.ts';

/** Controls the physics of the running program, and draws its bodies and voxels over the preview. */
export interface PhysicsView {
  receive(message: Extract<ToPreview, { kind: 'physics' | 'physics-drop' | 'physics-view' }>): void;
  afterFrame(player: Pick<Player, 'inspect'>, frame: SessionFrame, place: CaptureSource | null): void;
  dispose(): void;
}

const COLORS = {
  awake: '#ffb224',
  asleep: '#6aa6ff',
  fixed: '#7ac74f',
  voxel: 'rgb(90 220 200 / 55%)',
  touch: '#ff3d5e',
  force: '#d46bff',
  selected: '#ffffff',
} as const;
/** The length of the arrow of a force of one newton. */
const M_PER_N = 0.05;
/** Forces that are smaller are the rounding of velocities. */
const LEAST_N = 0.02;
const CENTER_PX = 5;
/** An arrow shows where a body will be after so long. */
const ARROW_S = 0.2;
/** How long the mark of a contact stays. */
const TOUCH_S = 1 / 3;
const TOUCH_PX = 6;

/**
 * @param send Receives clicks on bodies.
 * @param wake Requests a frame, also while the preview is paused.
 */
export function createPhysicsView(parent: HTMLElement, send: (message: FromPreview) => void, wake: () => void): PhysicsView {
  /** Whether a message has not reached the world yet. */
  let isPending = false;
  let isPaused = false;
  let steps = 0;
  let wantsReset = false;
  let drops: readonly string[] | null = null;
  let showsBodies = false;
  let showsVoxels = false;
  let lastS = 0;
  let pencil: Pencil | null = null;
  const drag: BodyDrag = createBodyDrag((node) => send({ kind: 'picked', chain: [node], phantom: false }));
  /** The velocities of bodies in the previous frame. */
  const before = new WeakMap<PhysicsBody, Float64Array>();
  const scratchForce = new Float64Array(3);
  let touches: { readonly pointWorld: readonly number[]; leftS: number }[] = [];

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
  /** The center of mass, the force on the body as its change of momentum, and the mass of the selected body. */
  function drawMass(on: Pencil, body: PhysicsBody, world: BodyWorld, deltaS: number): void {
    const { massKg, centerM } = world.massOf(body);
    const { worldFromBody: m, velocity } = body;
    const center = [0, 1, 2].map((i) => at(m, i) * centerM[0] + at(m, 4 + i) * centerM[1] + at(m, 8 + i) * centerM[2] + at(m, 12 + i));
    const isSelected = body === drag.selected;
    on.dot(center, 0, CENTER_PX, isSelected ? COLORS.selected : COLORS.force);
    if (isSelected) on.label(center, `${massKg.toPrecision(3)} kg`, COLORS.selected);
    const last = before.get(body) ?? velocity.slice();
    if (deltaS > 0) {
      for (let i = 0; i < 3; i++) scratchForce[i] = (massKg * (at(velocity, i) - at(last, i))) / deltaS;
      if (Math.hypot(...scratchForce) > LEAST_N) on.arrow([...m.slice(0, 12), ...center, 1], scratchForce, M_PER_N, COLORS.force);
    }
    last.set(velocity);
    before.set(body, last);
  }
  function drawBodies(on: Pencil, bodies: readonly PhysicsBody[], deltaS: number): void {
    for (const body of bodies) {
      if (!body.world) continue;
      const color = body.description.mode === 'static' ? COLORS.fixed : body.isAsleep ? COLORS.asleep : COLORS.awake;
      for (const shape of body.description.shapes) on.shape(body.worldFromBody, shape, color);
      if (!body.isAsleep) on.arrow(body.worldFromBody, body.velocity, ARROW_S, color);
      if (body.description.mode === 'dynamic') drawMass(on, body, body.world, deltaS);
      for (let i = 0; i < body.touches.count; i++) {
        const touch = body.touches.entries[i];
        if (touch) touches.push({ pointWorld: [...touch.pointWorld], leftS: TOUCH_S });
      }
    }
    for (const { pointWorld } of touches) on.dot(pointWorld, 0, TOUCH_PX, COLORS.touch);
    for (const touch of touches) touch.leftS -= Math.max(deltaS, 0);
    touches = touches.filter(({ leftS }) => leftS > 0);
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
        drag.see([], null, null);
        return;
      }
      drag.see(showsBodies ? bodies : [], view, box);
      pencil ??= createPencil(parent);
      pencil.begin(view, box);
      const { voxels, edgeM } = world.control;
      if (showsVoxels && voxels) for (let i = 0; i < voxels.length; i += 3) pencil.dot(voxels.subarray(i, i + 3), edgeM, 1, COLORS.voxel);
      if (showsBodies) drawBodies(pencil, bodies, frame.timeS - lastS);
      lastS = frame.timeS;
      // So that tests can wait for it.
      pencil.canvas.dataset.bodies = String(showsBodies ? bodies.length : 0);
      pencil.canvas.dataset.voxels = String(showsVoxels && voxels ? voxels.length / 3 : 0);
    },
    dispose: drag.dispose,
  };
}

const at = (list: ArrayLike<number>, index: number): number => list[index] ?? 0;

/** All bodies that nodes of the running program list. */
function bodiesOf(player: Pick<Player, 'inspect'>): PhysicsBody[] {
  return [...new Set([...listsOf(player)].flatMap(({ bodies }) => bodies))];
}

/** The measured room of the running program; null if it has none. */
export function roomOf(player: Pick<Player, 'inspect'>): PhysicsRoom | null {
  for (const { room } of listsOf(player)) if (room) return room;
  return null;
}

function listsOf(player: Pick<Player, 'inspect'>): ReadonlySet<BodyList> {
  const lists = new Set<BodyList>();
  for (const resource of player.inspect(null)?.resources.values() ?? []) if (resource.kind === 'bodies') lists.add(resource.list);
  return lists;
}
