import { Matrix4, Vector3 } from 'three';
import { addImpulse, type PhysicsBody } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime, Pulse } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchMatrix = new Matrix4();
const scratchImpulse = new Vector3();
const scratchTurn = new Vector3();
const impulse: [number, number, number] = [0, 0, 0];
const turn: [number, number, number] = [0, 0, 0];

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { impulseNs, turnNms } = ctx.params;
  const { axes } = ctx.config;

  function push(body: PhysicsBody, pulse: Pulse): void {
    scratchImpulse.fromArray(impulseNs.value);
    scratchTurn.fromArray(turnNms.value);
    const frame = axes === 'body' ? body.worldFromBody : axes === 'pulse' ? pulse.worldFromPose : null;
    if (frame) {
      scratchMatrix.fromArray(frame).setPosition(0, 0, 0);
      scratchImpulse.applyMatrix4(scratchMatrix);
      scratchTurn.applyMatrix4(scratchMatrix);
    }
    addImpulse(body, scratchImpulse.toArray(impulse), scratchTurn.toArray(turn), null);
  }

  return {
    update: () => {
      const { body: lists, push: pulses } = ctx.inputs;
      for (let i = 0; i < pulses.count; i++) {
        const pulse = pulses.at(i);
        for (const { bodies } of lists) {
          for (const body of bodies) if (pulse.bodyKey === '' || pulse.bodyKey === body.key) push(body, pulse);
        }
      }
    },
    dispose: () => {},
  };
}
