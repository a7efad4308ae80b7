import { describe, expect, test } from '@jest/globals';
import { Matrix4, Object3D, Vector3 } from 'three';
import { createSessionFrame } from '../../export/runtime/sessions/session-frame.ts';
import * as gamepad from '../../nodes/input/gamepad/definition.ts';
import { create as createGamepad } from '../../nodes/input/gamepad/runtime.ts';
import * as hand from '../../nodes/input/hand/definition.ts';
import { create as createHand } from '../../nodes/input/hand/runtime.ts';
import * as head from '../../nodes/input/head/definition.ts';
import { create as createHead } from '../../nodes/input/head/runtime.ts';
import { jointIndex } from '../../nodes/kit/hand-joints.ts';
import { createPose, writePose } from '../../nodes/kit/pose.ts';
import { setFromAngles } from '../../nodes/kit/rigid.ts';
import type { NodeRuntime } from '../../nodes/kit/runtime.ts';
import type { ObjectList } from '../../nodes/kit/scene-lists.ts';
import * as atPose from '../../nodes/objects/at-pose/definition.ts';
import { create as createAtPose } from '../../nodes/objects/at-pose/runtime.ts';
import * as follow from '../../nodes/pose/follow/definition.ts';
import { create as createFollow } from '../../nodes/pose/follow/runtime.ts';
import * as lookAt from '../../nodes/pose/look-at/definition.ts';
import { create as createLookAt } from '../../nodes/pose/look-at/runtime.ts';
import * as offset from '../../nodes/pose/offset/definition.ts';
import { create as createOffset } from '../../nodes/pose/offset/runtime.ts';
import { captureHand } from '../support/captured-hand.ts';
import { fakeContext } from '../support/node-context.ts';

/** Nodes wired in a row, as designers attach objects to hands, controllers and heads, and turn them to the viewer. */
const RATE_HZ = 60;

/** Where a chain's object is drawn, frame by frame. */
function play(nodes: readonly NodeRuntime[], ticks: readonly { tick(deltaS: number): void }[], placed: ObjectList) {
  const frame = createSessionFrame();
  frame.viewCount = 1;
  return {
    frame,
    step: (): Matrix4 | null => {
      for (const context of ticks) context.tick(1 / RATE_HZ);
      for (const node of nodes) node.update(frame);
      return placed.items[0]?.worldFromObject ?? null;
    },
  };
}

/** One object at its origin. */
function object(): ObjectList[] {
  const item = { key: 'a', root: new Object3D(), role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  return [{ version: 1, items: [{ ...item, worldFromObject: new Matrix4() }] }];
}

const positionOf = (matrix: Matrix4 | null) => (matrix ? new Vector3().setFromMatrixPosition(matrix) : null);

describe('an object attached', () => {
  test('to a joint of a hand is within 1 mm of it in each frame, and hidden while the hand is lost', () => {
    const tip = fakeContext(hand.definition, { params: { side: 'left', joint: 'index-finger-tip' } });
    const place = fakeContext(atPose.definition, { inputs: { objects: object(), pose: tip.ctx.outputs.joint } });
    const { frame, step } = play([createHand(tip.ctx), createAtPose(place.ctx)], [tip, place], place.ctx.outputs.objects);
    const { leftHand } = frame.input;
    const at = 16 * jointIndex('index-finger-tip') + 12;
    for (let i = 0; i < 60; i++) {
      captureHand(i % 2 ? 'relaxed' : 'point', 0.3 * Math.sin(i / 5), leftHand as never);
      const drawn = positionOf(step());
      expect(drawn?.distanceTo(new Vector3().fromArray(leftHand.worldFromJoints, at))).toBeLessThan(1e-3);
    }
    Object.assign(leftHand, { tracked: false });
    expect(step()).toBe(null);
  });

  test('to a controller keeps its offset along the grip', () => {
    const right = fakeContext(gamepad.definition, { params: { hand: 'right' } });
    const beside = fakeContext(offset.definition, { params: { offsetM: [0, 0.1, -0.2] }, inputs: { pose: right.ctx.outputs.grip } });
    const place = fakeContext(atPose.definition, { inputs: { objects: object(), pose: beside.ctx.outputs.pose } });
    const nodes = [createGamepad(right.ctx), createOffset(beside.ctx), createAtPose(place.ctx)];
    const { frame, step } = play(nodes, [right, beside, place], place.ctx.outputs.objects);
    const grip = new Float32Array(16);
    for (let i = 0; i < 30; i++) {
      setFromAngles(grip, [0.2 * Math.sin(i), 1.2, -0.4], [0.1 * i, 0.3 * i, 0]);
      Object.assign(frame.input.right, { worldFromGrip: grip });
      const expected = new Vector3(0, 0.1, -0.2).applyMatrix4(new Matrix4().fromArray(grip));
      expect(positionOf(step())?.distanceTo(expected)).toBeLessThan(1e-3);
    }
  });

  test('to the head with a lag halves what is left each time constant × ln 2', () => {
    const viewer = fakeContext(head.definition);
    const lag = fakeContext(follow.definition, { params: { timeConstantS: 0.3 }, inputs: { pose: viewer.ctx.outputs.pose } });
    const place = fakeContext(atPose.definition, { inputs: { objects: object(), pose: lag.ctx.outputs.pose } });
    const nodes = [createHead(viewer.ctx), createFollow(lag.ctx), createAtPose(place.ctx)];
    const { frame, step } = play(nodes, [viewer, lag, place], place.ctx.outputs.objects);
    const view = frame.views[0]?.worldFromView ?? new Float32Array(16);
    setFromAngles(view, [0, 1.6, 0], [0, 0, 0]);
    step();
    // A step of 1 m to the side.
    setFromAngles(view, [1, 1.6, 0], [0, 0, 0]);
    for (let i = 1; i <= 60; i++) {
      const left = 1 - (positionOf(step())?.x ?? 0);
      expect(left).toBeCloseTo(0.5 ** (i / RATE_HZ / (0.3 * Math.LN2)), 5);
    }
  });
});

describe('a billboard', () => {
  test.each([
    ['fully', false],
    ['upright', true],
  ])('faces the viewer within 0.1° from all sides: %s', (_name, upright) => {
    const viewer = fakeContext(head.definition);
    const stand = createPose();
    const matrix = new Float32Array(16);
    setFromAngles(matrix, [0.5, 1, -2], [0.3, 2, 0.1]);
    writePose(stand, upright ? new Matrix4().setPosition(0.5, 1, -2).elements : matrix, 0);
    const turned = fakeContext(lookAt.definition, { params: { upright }, inputs: { pose: stand, target: viewer.ctx.outputs.pose } });
    const place = fakeContext(atPose.definition, { inputs: { objects: object(), pose: turned.ctx.outputs.pose } });
    const nodes = [createHead(viewer.ctx), createLookAt(turned.ctx), createAtPose(place.ctx)];
    const { frame, step } = play(nodes, [viewer, turned, place], place.ctx.outputs.objects);
    const view = frame.views[0]?.worldFromView ?? new Float32Array(16);
    for (let i = 0; i < 24; i++) {
      const angle = (i / 12) * Math.PI;
      const eye = new Vector3(0.5 + 3 * Math.sin(angle), 1.7, -2 + 3 * Math.cos(angle));
      setFromAngles(view, eye.toArray(), [0.2, i, 0]);
      const drawn = step();
      if (!drawn) throw new Error('The billboard is not there.');
      const towards = eye.sub(new Vector3(0.5, 1, -2));
      if (upright) towards.y = 0;
      const front = new Vector3().setFromMatrixColumn(drawn, 2);
      expect((front.angleTo(towards) * 180) / Math.PI).toBeLessThan(0.1);
      if (upright) expect(new Vector3().setFromMatrixColumn(drawn, 1).y).toBeCloseTo(1, 6);
    }
  });
});
