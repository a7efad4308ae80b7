import type { NodeDefinition } from '../../../nodes/kit/definition.ts';
import {
  type BodyDescription,
  type BodyList,
  type BodyShape,
  createPhysicsBody,
  type PhysicsBody,
  type Triple,
} from '../../../nodes/kit/physics.ts';
import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import { definition } from '../../../nodes/physics/world/definition.ts';
import { create } from '../../../nodes/physics/world/runtime.ts';
import { type FakeContext, fakeContext } from '../node-context.ts';
import { cube, STEEL } from './lab.ts';

/** Bodies with the runtime of a physics world on the main thread, for tests of nodes that act on bodies. */
export function createStage(params: Readonly<Record<string, number | boolean | number[]>> = {}) {
  const list: BodyList = { version: 0, bodies: [] };
  const bodies = [list];
  const workers = {
    start: () => {
      throw new Error('There is no worker.');
    },
  };
  const world = fakeContext(definition, { inputs: { bodies }, services: { workers }, params });
  const node = create(world.ctx);
  return {
    list,
    add: (at: Triple, shapes: readonly BodyShape[] = cube(0.2), description: Partial<BodyDescription> = {}): PhysicsBody => {
      const body = createPhysicsBody(`body ${list.bodies.length}`, { ...STEEL, ...description, shapes });
      body.worldFromTarget.set(at, 12);
      body.worldFromBody.set(at, 12);
      list.bodies.push(body);
      list.version++;
      return body;
    },
    /** Plays frames: bodies, then the node, then the world. Bodies of `others` are in the world, too. */
    play: <D extends NodeDefinition>(
      frames: number,
      acting: NodeRuntime,
      fake: FakeContext<D>,
      frame: object = {},
      others: readonly BodyList[] = [],
    ): void => {
      bodies.splice(1, Number.POSITIVE_INFINITY, ...others);
      for (let i = 0; i < frames; i++) {
        world.tick(1 / 60);
        fake.tick(1 / 60);
        for (const body of list.bodies) body.world?.applyPoses();
        acting.update(frame as never);
        node.update(frame as never);
      }
    },
  };
}

export const placeOf = ({ worldFromBody: m }: PhysicsBody): Triple => [m[12] ?? Number.NaN, m[13] ?? Number.NaN, m[14] ?? Number.NaN];
