import { BoxGeometry, Matrix4, Mesh } from 'three';
import type { NodeDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import type { BodyList } from '../../../nodes/kit/physics.ts';
import { createPose } from '../../../nodes/kit/pose.ts';
import type { NodeContext, NodeRuntime, WorkerListener } from '../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import { definition as bodyDefinition } from '../../../nodes/physics/body/definition.ts';
import { create as createBody } from '../../../nodes/physics/body/runtime.ts';
import { createCannonEngine } from '../../../nodes/physics/world/cannon-engine.ts';
import { definition as worldDefinition } from '../../../nodes/physics/world/definition.ts';
import type { StepMessage } from '../../../nodes/physics/world/protocol.ts';
import { createStepper } from '../../../nodes/physics/world/run-step.ts';
import { create as createWorld } from '../../../nodes/physics/world/runtime.ts';

/** Falling boxes with the nodes Body and Physics world. */
export interface MeasuredBodies {
  /** Milliseconds that the page spends on a frame; what the worker does is not counted, the messages to it are. */
  frameMs(): number;
}

const FRAME_S = 1 / 60;

export function openBodies(count: number): MeasuredBodies {
  const clock = { timeS: 0, deltaS: FRAME_S, frame: 0, held: false };
  const items = Array.from({ length: count }, (_, i) => boxAt(i));
  const body: BodyList = { version: 0, bodies: [] };
  const outputs = { objects: { version: 0, items: [] }, body, pose: createPose() };
  const nothing = { count: 0 };
  const bodies: NodeRuntime = createBody(
    contextOf(bodyDefinition, { clock, outputs, inputs: { objects: [{ version: 1, items }], spawn: nothing, recycle: nothing } }),
  );
  // As a worker: messages are copied, buffers transferred. Its work is done between two frames.
  const step = createStepper(createCannonEngine);
  let waiting: StepMessage | null = null;
  let heard: WorkerListener | null = null;
  const workers = {
    start: (listener: WorkerListener) => {
      heard = listener;
      return {
        post: (message: unknown, transfer: readonly ArrayBuffer[]) => {
          waiting = structuredClone(message, { transfer: [...transfer] }) as StepMessage;
        },
        dispose: () => {},
      };
    },
  };
  const world: NodeRuntime = createWorld(
    contextOf(worldDefinition, { clock, outputs: {}, inputs: { bodies: [body], reset: nothing, step: nothing }, workers }),
  );
  return {
    frameMs: () => {
      clock.timeS += FRAME_S;
      clock.frame++;
      const startMs = performance.now();
      bodies.update({ jumps: 0 } as never);
      world.update({ jumps: 0 } as never);
      const spentMs = performance.now() - startMs;
      const message = waiting;
      waiting = null;
      if (message) {
        const answer = step(message);
        heard?.onMessage(structuredClone(answer, { transfer: [answer.poses.buffer, answer.touches.buffer] }));
      }
      return spentMs;
    },
  };
}

function boxAt(i: number): ObjectItem {
  const worldFromObject = new Matrix4().makeTranslation(0.3 * (i % 20), 0.2 + 0.3 * Math.floor(i / 400), 0.3 * (Math.floor(i / 20) % 20));
  const root = new Mesh(new BoxGeometry(0.2, 0.2, 0.2));
  return { key: String(i), root, worldFromObject, role: 'virtual', castsShadow: false, receivesShadow: false };
}

/** A context with the defaults of a definition. */
function contextOf<const D extends NodeDefinition>(definition: D, given: object): NodeContext<D> {
  const live = (value: ParamValue) => ({ value: Array.isArray(value) ? Float64Array.from(value as readonly number[]) : value });
  const all = Object.entries(definition.params);
  const context = {
    node: definition.type,
    params: Object.fromEntries(all.map(([name, param]) => [name, live(param.default)])),
    config: Object.fromEntries(all.map(([name, param]) => [name, param.default])),
    report: () => {},
    ...given,
  };
  return context as unknown as NodeContext<D>;
}
