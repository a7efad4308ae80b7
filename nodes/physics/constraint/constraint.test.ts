import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import type { PhysicsBody } from '../../kit/physics.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = Record<string, number | string | boolean | number[]>;

function start(
  params: Params,
  at: readonly [number, number, number],
  options: { other?: readonly [number, number, number]; pose?: Matrix4 } = {},
) {
  const stage = createStage({ floor: false });
  const body = stage.add(at);
  const other = options.other ? stage.add(options.other, undefined, { mode: 'static' }) : null;
  const pose = createPose();
  if (options.pose) writePose(pose, options.pose.elements, 0);
  const fake = fakeContext(definition, {
    params,
    inputs: {
      body: { version: 1, bodies: [body] },
      other: other ? { version: 1, bodies: [other] } : null,
      pose: options.pose ? pose : null,
    },
  });
  const node = create(fake.ctx);
  return { ...fake, body, other, pose, node, play: (seconds: number) => stage.play(Math.round(seconds * 60), node, fake) };
}
const distance = (body: PhysicsBody, to: readonly [number, number, number]) => new Vector3(...placeOf(body)).distanceTo(new Vector3(...to));

describe('physics/constraint', () => {
  test('a rope holds a body at its length and lets it come nearer', () => {
    const { body, play } = start({ kind: 'rope', lengthM: 0.5, otherAnchorM: [0, 2, 0] }, [0.3, 2, 0]);
    let longestM = 0;
    for (let i = 0; i < 120; i++) {
      play(1 / 60);
      longestM = Math.max(longestM, distance(body, [0, 2, 0]));
    }
    expect(longestM).toBeGreaterThan(0.49);
    expect(longestM).toBeLessThan(0.51);
  });

  test('a spring comes to rest where it carries the weight: g / (2 π f)² below its length', () => {
    const { body, play } = start({ kind: 'spring', lengthM: 0.5, frequencyHz: 2, damping: 0.5, otherAnchorM: [0, 2, 0] }, [0, 1.5, 0]);
    play(6);
    expect(distance(body, [0, 2, 0])).toBeCloseTo(0.5 + 9.81 / (4 * Math.PI) ** 2, 2);
  });

  test('a hinge turns about its axis alone and keeps its anchor', () => {
    const { body, play } = start({ kind: 'hinge', anchorM: [-0.3, 0, 0], axis: [0, 0, 1] }, [0.3, 2, 0]);
    play(0.5);
    const m = new Matrix4().fromArray(body.worldFromBody);
    const anchor = new Vector3(-0.3, 0, 0).applyMatrix4(m);
    expect(anchor.distanceTo(new Vector3(0, 2, 0))).toBeLessThan(0.005);
    expect(new Vector3(0, 0, 1).transformDirection(m).z).toBeGreaterThan(0.9999);
    expect(placeOf(body)[1]).toBeLessThan(1.9);
  });

  test('a lock carries a body with a pose, and lets go while the pose is invalid', () => {
    const { body, pose, play } = start({ kind: 'lock' }, [0, 1, 0], { pose: new Matrix4().makeTranslation(0, 1, 0) });
    play(0.5);
    expect(distance(body, [0, 1, 0])).toBeLessThan(0.005);
    for (let i = 1; i <= 60; i++) {
      writePose(pose, new Matrix4().makeTranslation(i / 60, 1, 0).elements, 0);
      play(1 / 60);
    }
    expect(distance(body, [1, 1, 0])).toBeLessThan(0.06);
    expect(body.velocity[0]).toBeCloseTo(1, 1);
    writePose(pose, null, 0);
    play(0.5);
    expect(placeOf(body)[1]).toBeLessThan(0.5);
  });

  test('a lock to another body holds; off, the body falls', () => {
    const { body, set, play } = start({ kind: 'lock' }, [0.3, 2, 0], { other: [0, 2, 0] });
    play(1);
    expect(distance(body, [0.3, 2, 0])).toBeLessThan(0.01);
    set('on', false);
    play(0.5);
    expect(placeOf(body)[1]).toBeLessThan(1.5);
  });

  test('an anchor that changes moves the end of a rope', () => {
    const { body, set, play } = start({ kind: 'rope', lengthM: 0.5, otherAnchorM: [0, 2, 0] }, [0, 1.5, 0]);
    play(0.5);
    expect(distance(body, [0, 2, 0])).toBeCloseTo(0.5, 1);
    set('otherAnchorM', [0, 3, 0]);
    play(3);
    expect(distance(body, [0, 3, 0])).toBeLessThan(0.52);
  });

  test('leaves no joint behind', () => {
    const { body, node, play } = start({ kind: 'rope' }, [0, 2, 0]);
    play(0.1);
    expect(body.joints).toHaveLength(1);
    node.dispose();
    expect(body.joints).toEqual([]);
  });
});
