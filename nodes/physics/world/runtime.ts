import { type BodyDescription, type BodyList, type BodyWorld, createPhysicsBody, createWorldControl } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { createCannonEngine } from './cannon-engine.ts';
import type { definition } from './definition.ts';
import { massProperties } from './mass-properties.ts';
import { FIXED_BODY, type PhysicsCommand } from './protocol.ts';
import { createStepper } from './run-step.ts';
import { createStepDriver } from './step-driver.ts';
import { createTrackedBodies } from './tracked-bodies.ts';

const STEP_S = 1 / 60;
/** While an answer is late, bodies move on by their velocities for at most this time; then they stop until it comes. */
const MAX_AHEAD_S = 1 / 30;

/**
 * The most time that may wait to be simulated. After a long pause, or with a worker that is too slow, the world continues instead of
 * catching up.
 */
const MAX_OWED_S = 0.1;

const FLOOR: BodyDescription = { ...FIXED_BODY, shapes: [{ kind: 'plane' }] };

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { playing, gravity, floorFriction, sleep, substeps, iterations } = ctx.params;
  const commands: PhysicsCommand[] = [];
  const floor = createPhysicsBody(`${ctx.node}/floor`, FLOOR);
  const own: BodyList = { version: 0, bodies: ctx.config.floor ? [floor] : [] };
  const lists: BodyList[] = [];
  /** Whether the result of the last step has been copied to the bodies in this frame. */
  let isApplied = false;
  /** Time that is still to be simulated, seconds; it grows while an answer is late. */
  let owedS = 0;
  /** Time by which the bodies have moved on by their velocities since the last answer, seconds. */
  let aheadS = 0;
  let isFirst = true;
  const settings = { gravity: [0, 0, 0] as [number, number, number], substeps: 0, iterations: 0, sleep: false };
  const control = createWorldControl();
  const wants = { voxels: false, file: false };
  const world: BodyWorld = {
    applyPoses,
    control,
    massOf: ({ description: { shapes, massKg, densityKgPerM3 } }) => massProperties(shapes, massKg, densityKgPerM3),
  };
  const tracked = createTrackedBodies(world);
  const driver = createStepDriver({
    workers: ctx.workers,
    createStepper: () => createStepper(createCannonEngine),
    restore: () => {
      const all: PhysicsCommand[] = [{ kind: 'clear' }, settingsCommand()];
      tracked.writeAll(all);
      return all;
    },
    onRestart: (reason, isOnMainThread) =>
      ctx.report({
        code: 'SCR058',
        severity: 'warning',
        message: `The worker of the physics world ended: ${reason}. ${isOnMainThread ? 'The simulation goes on in the page, which may slow the view.' : 'A new one goes on from the last step.'}`,
        fix: 'Simulate fewer bodies if it happens again.',
      }),
  });

  function applyPoses(): void {
    if (isApplied) return;
    isApplied = true;
    tracked.clearTouches();
    const answer = driver.take();
    if (answer) {
      tracked.take(answer);
      control.voxels = answer.voxels;
      aheadS = 0;
    } else if (!driver.isIdle) {
      aheadS = Math.min(aheadS + ctx.clock.deltaS, MAX_AHEAD_S);
      tracked.continueFor(aheadS);
    }
  }
  function settingsCommand(): PhysicsCommand {
    return { kind: 'settings', settings: { ...settings, gravity: [...settings.gravity] } };
  }
  /** Adds a command if a param of the world has changed, and updates the floor. */
  function writeSettings(): void {
    const [x = 0, y = 0, z = 0] = gravity.value;
    const [p, q, r] = settings.gravity;
    const parts = Math.round(substeps.value);
    const passes = Math.round(iterations.value);
    const isSame = x === p && y === q && z === r && settings.sleep === sleep.value && settings.substeps === parts;
    if (isFirst || !isSame || settings.iterations !== passes) {
      settings.gravity = [x, y, z];
      settings.sleep = sleep.value;
      settings.substeps = parts;
      settings.iterations = passes;
      commands.push(settingsCommand());
    }
    if (floor.description.friction !== floorFriction.value) {
      floor.description = { ...FLOOR, friction: floorFriction.value };
      floor.version++;
    }
  }
  function reset(): void {
    driver.forget();
    tracked.clearTouches();
    tracked.clear();
    commands.length = 0;
    owedS = 0;
    aheadS = 0;
    isFirst = true;
  }

  return {
    update: () => {
      applyPoses();
      isApplied = false;
      if (ctx.inputs.reset.count > 0 || control.wantsReset) reset();
      control.wantsReset = false;
      const { deltaS } = ctx.clock;
      if (control.isPaused || !playing.value) owedS += (ctx.inputs.step.count + control.steps) * STEP_S;
      else if (deltaS > 0) owedS = Math.min(owedS + deltaS, MAX_OWED_S);
      control.steps = 0;
      lists.length = 0;
      lists.push(own, ...ctx.inputs.bodies);
      for (const list of lists) list.isInWorld = true;
      driver.watch();
      if (!driver.isIdle) return;
      if (isFirst) commands.push({ kind: 'clear' });
      writeSettings();
      isFirst = false;
      tracked.writeCommands(lists, commands);
      const { awake } = ctx.outputs;
      if (awake) awake.value = tracked.awakeCount;
      control.edgeM = lists.find(({ room }) => room)?.room?.settings.edgeM ?? 0;
      const looks = control.wantsVoxels && control.voxels === null;
      if (!control.wantsVoxels) control.voxels = null;
      wants.voxels = control.wantsVoxels;
      wants.file = tracked.takeFileRequest();
      if (commands.length > 0 || owedS > 0 || looks || wants.file) driver.send(commands, owedS, tracked.count, wants);
      commands.length = 0;
      owedS = 0;
    },
    settle: () => driver.settle(),
    staysOnRepeat: true,
    reset,
    dispose: () => {
      for (const list of lists) list.isInWorld = false;
      driver.dispose();
      tracked.clear();
    },
  };
}
