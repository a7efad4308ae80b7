import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { cube, STEEL } from '../../../tests/support/physics/lab.ts';
import { SEEN_FLOOR, SETTINGS } from '../../../tests/support/physics/seen-room.ts';
import { addImpulse, type BodyList, createPhysicsBody, createPhysicsRoom, type PhysicsBody } from '../../kit/physics.ts';
import type { WorkerListener, WorkerService } from '../../kit/runtime.ts';
import { definition } from './definition.ts';
import { type PhysicsCommand, type PhysicsEngine, POSE_STRIDE, type StepMessage } from './protocol.ts';
import { createStepper } from './run-step.ts';
import { create } from './runtime.ts';
import { createStepDriver } from './step-driver.ts';
import { serve, type WorkerScope } from './worker.ts';

const noWorker: WorkerService = {
  start: () => {
    throw new Error('The browser starts no worker.');
  },
};

/** Runs the real script of the worker in this thread, with messages copied and buffers transferred as a browser does it. */
function workersHere() {
  const listeners: WorkerListener[] = [];
  let isStuck = false;
  const service: WorkerService = {
    start: (listener) => {
      listeners.push(listener);
      const scope: WorkerScope = { onmessage: null, postMessage: () => {} };
      serve(scope);
      let isAlive = true;
      scope.postMessage = (answer, transfer) => {
        const data = structuredClone(answer, { transfer });
        queueMicrotask(() => isAlive && listener.onMessage(data));
      };
      return {
        post: (message, transfer) => {
          const data = structuredClone(message, { transfer: [...transfer] }) as StepMessage;
          if (!isStuck) queueMicrotask(() => isAlive && scope.onmessage?.({ data }));
        },
        dispose: () => {
          isAlive = false;
        },
      };
    },
  };
  return {
    service,
    kill: (reason: string) => listeners.at(-1)?.onFailure(reason),
    get started() {
      return listeners.length;
    },
    stick: (value: boolean) => {
      isStuck = value;
    },
  };
}

/** Twelve boxes that fall on each other and on the floor. */
function boxes(): PhysicsBody[] {
  return Array.from({ length: 12 }, (_, i) => {
    const body = createPhysicsBody(`box ${i}`, { ...STEEL, shapes: cube(0.2), friction: 0.4 });
    body.worldFromTarget.set([0.07 * (i % 3), 0.3 + 0.25 * i, 0.05 * (i % 2)], 12);
    return body;
  });
}

function start(workers: WorkerService, bodies = boxes(), params: Record<string, number | boolean> = {}) {
  const list: BodyList = { version: 1, bodies };
  const fake = fakeContext(definition, { inputs: { bodies: [list] }, services: { workers }, params });
  (fake.ctx.clock as { held: boolean }).held = true;
  const node = create(fake.ctx);
  const frame = async (deltaS = 1 / 60) => {
    fake.tick(deltaS);
    node.update({} as never);
    await node.settle?.();
  };
  const play = async (count: number) => {
    for (let i = 0; i < count; i++) await frame();
  };
  const heights = () => bodies.map(({ worldFromBody }) => worldFromBody[13]);
  const poses = () => bodies.flatMap(({ worldFromBody }) => [...worldFromBody]);
  return { ...fake, node, bodies, list, frame, play, heights, poses };
}

describe('steps', () => {
  test('600 frames give the same bytes twice, in a worker and on the main thread', async () => {
    const inWorker = start(workersHere().service);
    const again = start(workersHere().service);
    const onMain = start(noWorker);
    for (const each of [inWorker, again, onMain]) await each.play(600);
    expect(again.poses()).toEqual(inWorker.poses());
    expect(onMain.poses()).toEqual(inWorker.poses());
    expect(Math.max(...(inWorker.heights() as number[]))).toBeLessThan(3);
  });

  test('a frame shows the step before, and after a reset begins anew', async () => {
    const { frame, bodies, node, play, heights } = start(noWorker);
    const [body] = bodies;
    await frame(0);
    expect(body?.world).not.toBeNull();
    await frame();
    expect(body?.worldFromBody[13]).toBeCloseTo(0.3, 6);
    await frame();
    expect(body?.worldFromBody[13]).toBeLessThan(0.3);
    await play(30);
    const once = heights();
    node.reset?.();
    await frame(0);
    for (let i = 0; i < 32; i++) await frame();
    expect(heights()).toEqual(once);
  });

  test('a late worker means frames that go on by velocity, never a wait', async () => {
    const workers = workersHere();
    const { tick, node, bodies, play } = start(workers.service);
    await play(10);
    const [body] = bodies;
    workers.stick(true);
    const frame = () => {
      tick(1 / 60);
      node.update({} as never);
      return body?.worldFromBody[13] ?? 0;
    };
    const [a, b, c] = [frame(), frame(), frame()];
    expect(b).toBeLessThan(a);
    expect(c).toBeLessThan(b);
    for (let i = 0; i < 20; i++) frame();
    expect(frame()).toBe(frame());
  });

  test('a list whose engine has not answered yet is in a world', () => {
    const workers = workersHere();
    workers.stick(true);
    const { tick, node, list, bodies } = start(workers.service, []);
    tick(1 / 60);
    node.update({} as never);
    // A body that is added while the first answer is out has no pose of the engine, but a world.
    list.bodies.push(...boxes());
    list.version++;
    tick(1 / 60);
    node.update({} as never);
    expect([list.isInWorld, bodies[0]?.world ?? null]).toEqual([true, null]);
    node.dispose();
    expect(list.isInWorld).toBe(false);
  });

  test('a worker that dies is replaced, from the last kept state', async () => {
    const workers = workersHere();
    const undisturbed = start(noWorker);
    const { play, node, tick, bodies, reports } = start(workers.service);
    await play(6);
    tick(1 / 60);
    node.update({} as never);
    workers.kill('out of memory');
    await node.settle?.();
    await play(3);
    await undisturbed.play(10);
    expect(workers.started).toBe(2);
    expect(reports).toMatchObject([{ code: 'SCR058' }]);
    bodies.forEach(({ worldFromBody }, i) => {
      expect(worldFromBody[13]).toBeCloseTo(undisturbed.bodies[i]?.worldFromBody[13] ?? 0, 5);
    });
  });

  test('a worker that is silent is given up; after three the page simulates', async () => {
    const workers = workersHere();
    const { tick, node, bodies, frame } = start(workers.service);
    workers.stick(true);
    for (let i = 0; i < 1000; i++) {
      tick(1 / 60);
      node.update({} as never);
    }
    expect(workers.started).toBe(3);
    await frame();
    expect(bodies[0]?.worldFromBody[13]).toBeLessThan(0.3);
  });

  test('paused, it stands still; a pulse is one step', async () => {
    const { frame, bodies, ctx, play } = start(noWorker, boxes(), { playing: false });
    await play(5);
    expect(bodies[3]?.worldFromBody[13]).toBeCloseTo(1.05, 6);
    (ctx.inputs.step as unknown as { emit(): void }).emit();
    await frame();
    (ctx.inputs.step as unknown as { clear(): void }).clear();
    await frame();
    const { worldFromBody } = bodies[3] as PhysicsBody;
    expect(worldFromBody[13]).toBeCloseTo(1.05 - 9.81 / 3600 / 2, 3);
    const [, stood] = [await play(5), worldFromBody[13]];
    expect(stood).toBeLessThan(1.05);
  });

  test('the editor pauses, steps and resets it, whatever the graph says', async () => {
    const { frame, bodies, play } = start(noWorker);
    await frame();
    const [body] = bodies as [PhysicsBody];
    const control = body.world?.control;
    if (!control) throw new Error('No world has taken the body.');
    await play(20);
    control.isPaused = true;
    await play(2);
    const heightM = body.worldFromBody[13] ?? 0;
    expect(heightM).toBeLessThan(0.25);
    await play(10);
    expect(body.worldFromBody[13]).toBe(heightM);
    control.wantsReset = true;
    await play(3);
    expect(body.worldFromBody[13]).toBeCloseTo(0.3, 6);
    control.steps = 3;
    await play(3);
    // A step takes at most 1/60 s, and falls with the velocity at its end.
    expect(0.3 - (body.worldFromBody[13] ?? 0)).toBeCloseTo((9.81 * 0.05 ** 2) / 2, 2);
    const [, steppedM] = [await play(5), body.worldFromBody[13] ?? 0];
    expect(steppedM).toBeLessThan(0.2995);
    control.isPaused = false;
    await play(3);
    expect(body.worldFromBody[13]).toBeLessThan(steppedM);
  });

  test('bodies that leave the list leave the world', async () => {
    const { list, bodies, play, heights } = start(noWorker);
    await play(120);
    const [removed] = list.bodies.splice(0, 1);
    list.version++;
    await play(90);
    expect(removed?.world).toBeNull();
    expect(Math.max(...(heights().slice(1) as number[]))).toBeLessThan(2.4);
    expect(bodies[1]?.world).not.toBeNull();
  });

  test('no number that is not finite reaches a body', async () => {
    const { play, bodies, frame, list } = start(noWorker);
    let seed = 1;
    const chance = () => {
      seed = (seed * 16807) % 2147483647;
      return seed / 2147483647;
    };
    const strange = [Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, 1e308, -1e308, 0];
    const any = () => strange[Math.floor(chance() * strange.length)] ?? 0;
    for (let i = 0; i < 60; i++) {
      const body = bodies[Math.floor(chance() * bodies.length)] as PhysicsBody;
      if (chance() < 0.5) addImpulse(body, [any(), any(), any()], [any(), 0, 0], [any(), 0, 0]);
      if (chance() < 0.3) {
        body.worldFromTarget[12 + Math.floor(chance() * 3)] = any();
        body.jumps++;
      }
      if (chance() < 0.1) {
        const mode = chance() < 0.5 ? 'kinematic' : 'dynamic';
        body.description = { ...body.description, mode, massKg: any(), restitution: any() };
        body.version++;
      }
      await frame(chance() < 0.1 ? any() : 1 / 60);
      for (const { worldFromBody } of bodies) expect([...worldFromBody].every(Number.isFinite)).toBe(true);
    }
    list.version++;
    await play(5);
    for (const { worldFromBody } of bodies) expect([...worldFromBody].every(Number.isFinite)).toBe(true);
  });
});

describe('the protocol', () => {
  test('depth moves to the worker and back without a copy', async () => {
    const { list, frame } = start(workersHere().service);
    const room = createPhysicsRoom(SETTINGS, 0.6, 0);
    list.room = room;
    const meters = new Float32Array(16 * 12).fill(2);
    room.frames.push({ ...SEEN_FLOOR, meters });
    await frame();
    expect([meters.length, room.spent.length]).toEqual([0, 0]);
    await frame();
    expect(room.spent.map((each) => [...each])).toEqual([Array(16 * 12).fill(2)]);
  });

  test('another engine needs no more than commands and buffers', () => {
    const seen: string[] = [];
    const ids: number[] = [];
    const fake = (): PhysicsEngine => ({
      apply: (command) => {
        seen.push(command.kind);
        if (command.kind === 'add') ids.push(command.id);
      },
      step: (deltaS) => void seen.push(`step ${deltaS}`),
      get bodyCount() {
        return ids.length;
      },
      writePoses: (out) => {
        for (const [i, id] of ids.entries()) out.set([id, 1, 2, 3, 0, 0, 0, 1], i * POSE_STRIDE);
      },
      writeTouches: () => 0,
      voxels: () => new Float32Array(3),
      roomFile: () => null,
    });
    const driver = createStepDriver({
      workers: noWorker,
      createStepper: () => createStepper(fake),
      restore: () => [],
      onRestart: () => {},
    });
    const add: PhysicsCommand = { kind: 'add', id: 7, body: { ...STEEL, shapes: cube(1) }, state: [] };
    driver.send([{ kind: 'clear' }, add, { kind: 'remove', id: 3 }], 0.5, 1);
    expect(driver.take()).toMatchObject({ bodyCount: 1, touchCount: 0, failure: null });
    expect(seen).toEqual(['add', 'remove', 'step 0.5']);
    expect(driver.isOnMainThread).toBe(true);
  });
});
