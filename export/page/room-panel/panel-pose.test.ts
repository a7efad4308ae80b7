import { describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../../runtime/sessions/session-frame.ts';
import { createPanelPose } from './panel-pose.ts';

/** Two eyes at a place, turned about y, then up or down. */
function frameAt(position: readonly [number, number, number], turn = 0, pitch = 0, deltaS = 0.1) {
  const frame = createSessionFrame();
  frame.viewCount = 2;
  frame.deltaS = deltaS;
  const right = [Math.cos(turn), 0, -Math.sin(turn)];
  const back = [Math.sin(turn) * Math.cos(pitch), -Math.sin(pitch), Math.cos(turn) * Math.cos(pitch)];
  const up = [Math.sin(turn) * Math.sin(pitch), Math.cos(pitch), Math.cos(turn) * Math.sin(pitch)];
  for (const [i, side] of [-0.032, 0.032].entries()) {
    const eye = position.map((value, axis) => value + side * (right[axis] ?? 0));
    frame.views[i]?.worldFromView.set([...right, 0, ...up, 0, ...back, 0, ...eye, 1]);
  }
  return frame;
}

const place = (pose: ReturnType<typeof createPanelPose>) => [...pose.worldFromPanel.subarray(12, 15)];

function expectNear(actual: readonly number[], expected: readonly number[]) {
  expect(Math.hypot(...actual.map((value, i) => value - (expected[i] ?? 0)))).toBeLessThan(1e-5);
}

const AHEAD_M = Math.sqrt(0.56);

describe('where the panel stands', () => {
  test('is 0.9 m away, half a meter below the eyes, and faces them', () => {
    const pose = createPanelPose();
    pose.update(frameAt([1, 1.6, 2]), false);
    expectNear(place(pose), [1, 1.1, 2 - AHEAD_M]);
    expectNear([...pose.worldFromPanel.subarray(0, 3)], [1, 0, 0]);
    expectNear([...pose.worldFromPanel.subarray(8, 11)], [0, 0.5 / 0.9, AHEAD_M / 0.9]);
  });

  test.each([
    ['level', 0],
    ['straight down', -Math.PI / 2],
    ['straight up', Math.PI / 2],
  ])('is ahead of someone who looks %s', (_how, pitch) => {
    const pose = createPanelPose();
    // A quarter to the left: ahead is -x.
    pose.update(frameAt([0, 1.6, 0], Math.PI / 2, pitch), false);
    expectNear(place(pose), [-AHEAD_M, 1.1, 0]);
  });

  test('stays while the viewer looks and leans about, and glances away', () => {
    const pose = createPanelPose();
    pose.update(frameAt([0, 1.6, 0]), false);
    const before = place(pose);
    for (let i = 0; i < 100; i++) pose.update(frameAt([0.2, 1.5, 0.1], 1.2, -0.3), false);
    for (let i = 0; i < 19; i++) pose.update(frameAt([0, 1.6, 0], 2.5), false);
    pose.update(frameAt([0, 1.6, 0]), false);
    for (let i = 0; i < 19; i++) pose.update(frameAt([0, 1.6, 0], 2.5), false);
    expectNear(place(pose), before);
  });

  test.each([
    ['walks away', frameAt([0, 1.6, 3])],
    ['turns away', frameAt([0, 1.6, 0], Math.PI)],
    ['sits down', frameAt([0, 1.15, 0])],
    ['stands in it', frameAt([0, 1.2, -AHEAD_M])],
  ])('comes after a viewer who %s, but is not pulled out of a hand', (_what, frame) => {
    const pose = createPanelPose();
    pose.update(frameAt([0, 1.6, 0]), false);
    const before = place(pose);
    for (let i = 0; i < 50; i++) pose.update(frame, true);
    expectNear(place(pose), before);
    for (let i = 0; i < 21; i++) pose.update(frame, false);
    const fresh = createPanelPose();
    fresh.update(frame, false);
    expectNear(place(pose), place(fresh));
  });

  test('is chosen anew when the room is', () => {
    const pose = createPanelPose();
    pose.update(frameAt([0, 1.6, 0]), false);
    pose.reset();
    pose.update(frameAt([0.1, 1.6, 0]), false);
    expectNear(place(pose), [0.1, 1.1, -AHEAD_M]);
  });
});
