import { describe, expect, test } from '@jest/globals';
import { createSessionInput, type MutableController, type MutableInput } from '../../../export/runtime/sessions/input/session-input.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Hand = (typeof definition.params.hand.options)[number]['value'];

function start(hand: Hand = 'either', deadZone = 0, params = {}) {
  const inputs = { vibrate: createPulseQueue() };
  const fake = fakeContext(definition, { params: { hand, deadZone, ...params }, inputs });
  const node = create(fake.ctx);
  const input = createSessionInput();
  const { outputs } = fake.ctx;
  const frame = (change: (input: MutableInput) => void = () => {}) => {
    change(input);
    fake.tick(1 / 60);
    node.update({ input, jumps: 0 } as never);
    return {
      stick: [outputs.x.value, outputs.y.value].map((x) => Math.round(x * 1e6) / 1e6 + 0),
      trigger: outputs.trigger.value,
      connected: outputs.connected.value,
      pulses: [outputs.pulled.count, outputs.primary.count, outputs.secondary.count],
    };
  };
  return { inputs, outputs, frame, reset: () => node.reset?.() };
}

function move(controller: MutableController, x: number, y: number): void {
  controller.connected = true;
  controller.stick.set([x, y]);
}

/** A rigid pose at x. */
const poseAt = (x: number) => Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1);

describe('gamepad', () => {
  test('gives the poses of its controller; of either, those of the right one while it is tracked', () => {
    const { outputs, frame } = start();
    const told = () => [outputs.ray, outputs.grip].map(({ valid, worldFromPose }) => (valid ? worldFromPose[12] : null));
    frame(({ left }) => Object.assign(left, { worldFromRay: poseAt(1), worldFromGrip: poseAt(2) }));
    expect([told(), outputs.ray.jumps]).toEqual([[1, 2], 0]);
    frame(({ right }) => Object.assign(right, { worldFromRay: poseAt(3) }));
    expect([told(), outputs.ray.jumps]).toEqual([[3, null], 1]);
    frame(({ right }) => Object.assign(right, { worldFromRay: null }));
    expect([told(), outputs.ray.jumps]).toEqual([[1, 2], 2]);
  });

  test('a pulse makes its controllers vibrate, one motor once', () => {
    const { inputs, frame } = start('either', 0, { strength: 0.75, durationS: 0.2 });
    const played: unknown[] = [];
    const motor = (name: string) => ({ pulse: (...pulse: number[]) => played.push([name, ...pulse]) });
    const both = motor('both');
    frame(({ left, right }) => Object.assign(left, { haptics: both }) && Object.assign(right, { haptics: both }));
    expect(played).toEqual([]);
    inputs.vibrate.emit();
    inputs.vibrate.emit();
    frame();
    expect(played.splice(0)).toEqual([['both', 0.75, 0.2]]);
    frame(({ left }) => Object.assign(left, { haptics: motor('left') }));
    expect(played.splice(0).map((pulse) => (pulse as unknown[])[0])).toEqual(['left', 'both']);
    frame(({ left, right }) => Object.assign(left, { haptics: null }) && Object.assign(right, { haptics: null }));
    expect(played).toEqual([]);
  });

  test('the stick gives one pulse per press', () => {
    const { outputs, frame } = start();
    const press = (stickPressed: boolean) => {
      frame(({ right }) => Object.assign(right, { stickPressed }));
      return outputs.stickPressed.count;
    };
    expect([press(true), press(true), press(false), press(true)]).toEqual([1, 0, 0, 1]);
  });

  test('outputs 0 without a controller', () => {
    expect(start().frame()).toEqual({ stick: [0, 0], trigger: 0, connected: false, pulses: [0, 0, 0] });
  });

  test.each<[Hand, number[]]>([
    ['left', [-0.5, 0]],
    ['right', [0, 0.75]],
    ['either', [0, 0.75]],
  ])('gives the stick of the %s hand', (hand, stick) => {
    const { frame } = start(hand);
    const given = frame(({ left, right }) => {
      move(left, -0.5, 0);
      move(right, 0, 0.75);
    });
    expect(given).toMatchObject({ stick, connected: true });
  });

  test('a stick counts from the end of the dead zone, all around, to 1', () => {
    const { frame } = start('left', 0.2);
    const at = (x: number, y: number) => frame(({ left }) => move(left, x, y)).stick;
    expect(at(0.12, 0.16)).toEqual([0, 0]);
    expect(at(0.6, 0)).toEqual([0.5, 0]);
    expect(at(0, -1)).toEqual([0, -1]);
    expect(at(0.8, 0.8)).toEqual([expect.closeTo(Math.SQRT1_2, 5), expect.closeTo(Math.SQRT1_2, 5)]);
  });

  test('a button gives one pulse per press, of whichever hand', () => {
    const { frame } = start();
    const press = (left: boolean, right: boolean) =>
      frame((input) => {
        input.left.primary = left;
        input.right.primary = right;
      }).pulses[1];
    expect([press(true, false), press(true, true), press(false, true), press(false, false), press(false, true)]).toEqual([1, 0, 0, 0, 1]);
  });

  test('the trigger pulls past the middle, and again only after it was let go; its pulse knows where it points', () => {
    const { outputs, frame } = start('right');
    const pull = (trigger: number) =>
      frame(({ right }) => {
        right.trigger = trigger;
        right.worldFromRay = new Float32Array(16).fill(3);
      }).pulses[0];
    expect([pull(0.49), pull(0.5)]).toEqual([0, 1]);
    expect(outputs.pulled.at(0).worldFromPose).toEqual(new Float32Array(16).fill(3));
    expect([pull(0.45), pull(0.55), pull(0.3), pull(0.6)]).toEqual([0, 0, 0, 1]);
  });

  test('after a reset, what is still pressed is pressed anew', () => {
    const { frame, reset } = start();
    const hold = (input: MutableInput) => {
      Object.assign(input.right, { trigger: 0.45, primary: true, secondary: true });
    };
    const pull = (input: MutableInput) => {
      hold(input);
      input.right.trigger = 1;
    };
    expect([frame(pull).pulses, frame(hold).pulses]).toEqual([
      [1, 1, 1],
      [0, 0, 0],
    ]);
    reset();
    // Between the two limits, the trigger is not pulled unless it was.
    expect([frame(hold).pulses, frame(pull).pulses]).toEqual([
      [0, 1, 1],
      [1, 0, 0],
    ]);
  });
});
