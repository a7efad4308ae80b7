import { describe, expect, test } from '@jest/globals';
import { Euler, Matrix4, Vector3 } from 'three';
import { addPointer, createPointer, type MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

const DEG = Math.PI / 180;
const FRAME_S = 1 / 60;

/** A ray from an eye, degrees to the right and up. */
function ray(rightDeg: number, upDeg = 0, from: readonly [number, number, number] = [0, 1.6, 0]): Float32Array {
  return new Float32Array(
    new Matrix4().makeRotationFromEuler(new Euler(upDeg * DEG, -rightDeg * DEG, 0, 'YXZ')).setPosition(...from).elements,
  );
}

function pointer(phase: MutablePointer['phase'], worldFromRay: Float32Array, more: Partial<MutablePointer> = {}): MutablePointer {
  return Object.assign(createPointer(), { id: 1, by: 'screen', phase, tapped: false, worldFromRay, ...more });
}

function start(params: Params = {}) {
  const frame = createSessionFrame() as ReturnType<typeof createSessionFrame> & { jumps: number };
  frame.viewCount = 1;
  frame.views[0]?.worldFromView.set(new Matrix4().setPosition(0, 1.6, 0).elements);
  const reset = createPulseQueue();
  const fake = fakeContext(definition, { params, inputs: { reset } });
  const node = create(fake.ctx);
  const { outputs } = fake.ctx;
  const step = (pointers: readonly MutablePointer[] = [], deltaS = FRAME_S) => {
    frame.input.pointerCount = 0;
    for (const each of pointers) addPointer(frame.input, each);
    fake.tick(deltaS);
    node.update(frame);
    const said = (['tapped', 'doubleTapped', 'longPressed', 'dragStarted', 'dragEnded'] as const).flatMap((name) =>
      pulseNumbers(outputs[name]).map((number) => `${name} ${number}`),
    );
    return said.join(', ');
  };
  const values = () => ({
    dragDeg: [...outputs.dragRad.value].map((x) => Math.round((x / DEG) * 100) / 100 + 0),
    dragM: [...outputs.dragM.value].map((x) => Math.round(x * 1e4) / 1e4 + 0),
    scale: Math.round(outputs.scale.value * 1e4) / 1e4,
    twistDeg: Math.round((outputs.twistRad.value / DEG) * 100) / 100 + 0,
  });
  return { ...fake, node, frame, reset, step, values };
}

const STILL = { dragDeg: [0, 0], dragM: [0, 0, 0], scale: 1, twistDeg: 0 };

describe('one pointer', () => {
  test('taps, twice within the time and the angle is a double tap, and the third begins another', () => {
    const { step } = start({ doubleTapS: 0.3 });
    const tap = (rightDeg = 0, waitS = 0) => {
      step([], waitS);
      step([pointer('start', ray(rightDeg))]);
      return step([pointer('end', ray(rightDeg + 1))]);
    };
    expect([tap(), tap(2), tap(), tap(0, 0.5), tap(20), tap(20)]).toEqual([
      'tapped 1',
      'tapped 2, doubleTapped 2',
      'tapped 1',
      'tapped 1',
      'tapped 1',
      'tapped 2, doubleTapped 2',
    ]);
  });

  test('presses long, once, which is no tap', () => {
    const { step } = start({ longPressS: 0.495 });
    step([pointer('start', ray(0))]);
    const said = Array.from({ length: 40 }, () => step([pointer('hold', ray(1))]));
    expect(said.flatMap((words, i) => (words === '' ? [] : [[words, i]]))).toEqual([['longPressed 1', 29]]);
    expect(step([pointer('end', ray(1))])).toBe('');
  });

  test('drags from 3° on, to the right and up as the visitor sees it, and keeps the drag', () => {
    const { step, values } = start();
    step([pointer('start', ray(0))]);
    expect([step([pointer('hold', ray(2.9))]), values()]).toEqual(['', STILL]);
    expect(step([pointer('hold', ray(8, 4))])).toBe('dragStarted 1');
    expect(values().dragDeg).toEqual([8, 4]);
    expect(step([pointer('end', ray(10, 5))])).toBe('dragEnded 1');
    step();
    expect(values().dragDeg).toEqual([10, 5]);
    step([pointer('start', ray(-20))]);
    step([pointer('hold', ray(-25))]);
    expect(values().dragDeg).toEqual([5, 5]);
    // A canceled drag is undone.
    expect(step([pointer('cancel', ray(-25))])).toBe('dragEnded -1');
    expect(values().dragDeg).toEqual([10, 5]);
  });

  test('gives the movement of the point at the distance, and of a hand that of the hand', () => {
    const { step, values } = start({ distanceM: 2 });
    step([pointer('start', ray(0))]);
    step([pointer('hold', ray(30))]);
    expect(values().dragM).toEqual([1, 0, Math.round((2 - Math.sqrt(3)) * 1e4) / 1e4]);
    const hands = start();
    const grip = (x: number) => ({
      by: 'right-hand' as const,
      worldFromGrip: new Float32Array(new Matrix4().setPosition(x, 1, -0.3).elements),
    });
    hands.step([pointer('start', ray(0), grip(0.1))]);
    hands.step([pointer('hold', ray(10), grip(0.35))]);
    expect(hands.values().dragM).toEqual([0.25, 0, 0]);
  });

  test('of a finger that rests does not drag while the device turns; a controller that turns does', () => {
    const turned = new Matrix4().makeRotationY(-10 * DEG).setPosition(0, 1.6, 0).elements;
    const said = (['screen', 'right'] as const).map((by) => {
      const { frame, step } = start();
      step([pointer('start', ray(0), { by })]);
      frame.views[0]?.worldFromView.set(turned);
      return step([pointer('hold', ray(10), { by })]);
    });
    expect(said).toEqual(['', 'dragStarted 1']);
  });

  test('returns to 0 where it is set so, and at a pulse', () => {
    const drag = (node: ReturnType<typeof start>) => {
      node.step([pointer('start', ray(0))]);
      node.step([pointer('hold', ray(8))]);
      node.step([pointer('end', ray(8))]);
      return node.values().dragDeg;
    };
    expect(drag(start({ after: 'return' }))).toEqual([0, 0]);
    const kept = start();
    expect(drag(kept)).toEqual([8, 0]);
    kept.reset.emit();
    kept.step();
    expect(kept.values()).toEqual(STILL);
  });

  test('counts only where it is active in the first two frames, of the chosen kind, and free', () => {
    const late = start({ active: false });
    late.step([pointer('start', ray(0))]);
    late.set('active', true);
    expect(late.step([pointer('end', ray(0))])).toBe('tapped 1');
    const never = start({ active: false });
    never.step([pointer('start', ray(0))]);
    never.step([pointer('hold', ray(0))]);
    never.set('active', true);
    expect(never.step([pointer('end', ray(0))])).toBe('');
    const taps = (params: Params, more: Partial<MutablePointer>) => {
      const { ctx, step } = start(params);
      const press = pointer('start', ray(0), more);
      step([press]);
      press.phase = 'end';
      return [step([press]) !== '', press.owner === ctx];
    };
    const theirs = { owner: {} };
    expect([taps({}, theirs), taps({ presses: 'claim' }, theirs), taps({ presses: 'all' }, theirs)]).toEqual([
      [false, false],
      [false, false],
      [true, false],
    ]);
    expect([taps({ presses: 'claim' }, {}), taps({}, {})]).toEqual([
      [true, true],
      [true, false],
    ]);
    expect(
      [taps({ by: 'screen' }, { by: 'left' }), taps({ by: 'hands' }, { by: 'left' }), taps({ by: 'hands' }, {})].map(([is]) => is),
    ).toEqual([false, true, false]);
  });

  test('leaves a press that another node claims after it started', () => {
    const { step } = start();
    const press = pointer('start', ray(0));
    step([press]);
    press.owner = {};
    press.phase = 'end';
    expect(step([press])).toBe('');
  });

  test('drags on from where it is when the world is re-centered', () => {
    const { frame, step, values } = start();
    step([pointer('start', ray(0), { by: 'right' })]);
    step([pointer('hold', ray(10), { by: 'right' })]);
    frame.jumps++;
    step([pointer('hold', ray(90), { by: 'right' })]);
    expect(values().dragDeg).toEqual([10, 0]);
    step([pointer('hold', ray(95), { by: 'right' })]);
    expect(values().dragDeg).toEqual([15, 0]);
  });
});

describe('two pointers', () => {
  /** Fingers around the middle of the view, as far apart in the plane 1 m before the eye, and turned counterclockwise. */
  function fingers(phase: MutablePointer['phase'], apart: number, turnDeg = 0): MutablePointer[] {
    return [1, -1].map((side, i) => {
      const to = new Vector3(Math.cos(turnDeg * DEG), Math.sin(turnDeg * DEG), 0).multiplyScalar((side * apart) / 2).setZ(-1);
      const looking = new Matrix4().lookAt(new Vector3(), to, new Vector3(0, 1, 0.001)).setPosition(0, 1.6, 0);
      return pointer(phase, new Float32Array(looking.elements), { id: i + 1 });
    });
  }

  test('pinch and twist by what is beyond the thresholds, and keep it', () => {
    const { ctx, step, values } = start({ pinchFrom: 0.1, twistFromRad: 10 * DEG });
    step(fingers('start', 0.2));
    step(fingers('hold', 0.21, 9));
    expect([ctx.outputs.isPinching.value, values()]).toEqual([true, STILL]);
    step(fingers('hold', 0.24, 12));
    expect(values()).toEqual(STILL);
    step(fingers('hold', 0.48, 42));
    expect(values()).toEqual({ ...STILL, scale: 2, twistDeg: 30 });
    expect(step(fingers('end', 0.48, 42))).toBe('');
    step();
    expect([ctx.outputs.isPinching.value, values()]).toEqual([false, { ...STILL, scale: 2, twistDeg: 30 }]);
    step(fingers('start', 0.2));
    step(fingers('hold', 0.1));
    step(fingers('hold', 0.05));
    expect(values().scale).toBe(1);
    step(fingers('cancel', 0.05));
    expect(values().scale).toBe(2);
  });

  test('twist through half a turn without a jump', () => {
    const { step, values } = start({ twistFromRad: 0 });
    step(fingers('start', 0.2));
    for (let deg = 5; deg <= 400; deg += 5) step(fingers('hold', 0.2, deg));
    // The first 5° were the threshold.
    expect(values().twistDeg).toBe(395);
  });

  test('of which one is lifted: the other drags on, and does not tap', () => {
    const { step } = start();
    step(fingers('start', 0.2));
    const [left, right] = fingers('hold', 0.2) as [MutablePointer, MutablePointer];
    step([left, right]);
    right.phase = 'end';
    step([left, right]);
    expect(step([left])).toBe('');
    expect(step([pointer('hold', ray(-30), { id: left.id })])).toBe('dragStarted 1');
    expect(step([pointer('end', ray(-30), { id: left.id })])).toBe('dragEnded 1');
  });

  test('of two hands scale and twist by the line between them; a hand and a finger do neither', () => {
    const { ctx, step, values } = start({ pinchFrom: 0, twistFromRad: 0 });
    const hands = (phase: MutablePointer['phase'], halfM: number, turnDeg: number) =>
      (['left-hand', 'right-hand'] as const).map((by, i) => {
        const side = i === 0 ? -halfM : halfM;
        const at = [side * Math.cos(turnDeg * DEG), 1.2, -0.4 - side * Math.sin(turnDeg * DEG)] as const;
        return pointer(phase, ray(0, 0, at), { id: i + 1, by });
      });
    step(hands('start', 0.1, 0));
    step(hands('hold', 0.11, 1));
    step(hands('hold', 0.22, 31));
    expect(values()).toEqual({ ...STILL, scale: 2, twistDeg: 30 });
    const mixed = start();
    mixed.step([pointer('start', ray(0)), pointer('start', ray(10), { id: 2, by: 'right' })]);
    expect([ctx.outputs.isPinching.value, mixed.ctx.outputs.isPinching.value]).toEqual([true, false]);
  });
});
