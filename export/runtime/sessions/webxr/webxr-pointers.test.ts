import { describe, expect, test } from '@jest/globals';
import { captureHand } from '../../../../tests/support/captured-hand.ts';
import { createSessionInput } from '../input/session-input.ts';
import { createWebXrPointers } from './webxr-pointers.ts';

type Source = Partial<Record<keyof XRInputSource, unknown>>;

const RAY = {};
const GRIP = {};
const CONTROLLER: Source = {
  targetRayMode: 'tracked-pointer',
  handedness: 'right',
  profiles: ['generic-trigger'],
  targetRaySpace: RAY,
  gripSpace: GRIP,
};

/** A pose at x. */
const poseAt = (x: number) => ({
  transform: { matrix: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1), position: { x, y: 0, z: 0 } },
});

function start(...sources: Source[]) {
  const events = new EventTarget();
  const session = Object.assign(events, { inputSources: sources });
  const places = new Map<object, number | null>([
    [RAY, 1],
    [GRIP, 2],
  ]);
  const frame = {
    getPose: (space: object) => {
      const x = places.get(space);
      return x === null || x === undefined ? null : poseAt(x);
    },
  };
  const pointers = createWebXrPointers(session as never, {} as never);
  const input = createSessionInput();
  return {
    input,
    sources,
    places,
    fire: (type: string, inputSource: Source) => void events.dispatchEvent(Object.assign(new Event(type), { frame, inputSource })),
    skip: pointers.skip,
    frame: () => {
      input.pointerCount = 0;
      pointers.fill(input, frame as never);
      return input.pointers.slice(0, input.pointerCount).map((pointer) => ({
        by: pointer.by,
        id: pointer.id,
        phase: pointer.phase,
        at: pointer.worldFromRay[12],
        grip: pointer.worldFromGrip?.[12] ?? null,
        pinch: Math.round(pointer.pinch * 1e4) / 1e4,
        tapped: pointer.tapped,
      }));
    },
  };
}

describe('pointers of a WebXR session', () => {
  test('a controller hovers where it points', () => {
    const { frame } = start({ ...CONTROLLER });
    const [hover] = frame();
    expect(hover).toEqual({ by: 'right', id: 1, phase: 'hover', at: 1, grip: 2, pinch: 0, tapped: false });
  });

  test('a tap while tracking is lost does not come later; a press that was seen before ends after it', () => {
    const touch = { ...CONTROLLER, targetRayMode: 'screen' };
    const { fire, frame, skip, sources } = start(touch);
    fire('selectstart', touch);
    skip();
    fire('select', touch);
    fire('selectend', touch);
    skip();
    sources.length = 0;
    expect(frame()).toEqual([]);
    sources.push(touch);
    fire('selectstart', touch);
    expect(frame().map(({ phase }) => phase)).toEqual(['start']);
    skip();
    fire('select', touch);
    fire('selectend', touch);
    skip();
    expect(frame().map(({ phase, tapped }) => [phase, tapped])).toEqual([['end', true]]);
  });

  test('a press goes from selectstart to selectend, and is a tap by select', () => {
    const source = { ...CONTROLLER };
    const { fire, frame } = start(source);
    frame();
    fire('selectstart', source);
    const phases = [frame(), frame()];
    fire('select', source);
    fire('selectend', source);
    phases.push(frame(), frame());
    expect(phases.flat().map(({ phase, tapped, id }) => [phase, tapped, id])).toEqual([
      ['start', false, 1],
      ['hold', false, 1],
      ['end', true, 1],
      ['hover', false, 1],
    ]);
  });

  test('selectend without select, and a source that goes, cancel the press', () => {
    const source = { ...CONTROLLER };
    const first = start(source);
    first.fire('selectstart', source);
    first.frame();
    first.fire('selectend', source);
    expect(first.frame()).toMatchObject([{ phase: 'cancel', tapped: false }]);
    const second = start(source);
    second.fire('selectstart', source);
    second.frame();
    second.sources.length = 0;
    expect([second.frame(), second.frame()]).toMatchObject([[{ phase: 'cancel', at: 1 }], []]);
  });

  test('select alone, as some browsers fire it, is a whole press', () => {
    const source = { ...CONTROLLER };
    const { fire, frame } = start(source);
    fire('select', source);
    expect([frame(), frame()].flat().map(({ phase, tapped }) => [phase, tapped])).toEqual([
      ['start', true],
      ['end', true],
    ]);
  });

  test('a hand that is lost in a pinch keeps its last ray, and is not listed while it hovers', () => {
    const hand = { ...CONTROLLER, profiles: ['generic-hand-select'] };
    const { fire, frame, places } = start(hand);
    expect(frame()).toMatchObject([{ by: 'right-hand', phase: 'hover' }]);
    fire('selectstart', hand);
    frame();
    places.set(RAY, null);
    places.set(GRIP, null);
    expect(frame()).toMatchObject([{ phase: 'hold', at: 1, grip: null }]);
    fire('selectend', hand);
    expect([frame(), frame()]).toMatchObject([[{ phase: 'cancel' }], []]);
  });

  test.each([
    ['screen', { targetRayMode: 'screen', handedness: 'none' }],
    ['left-hand', { targetRayMode: 'transient-pointer', handedness: 'left' }],
    ['gaze', { targetRayMode: 'transient-pointer', handedness: 'none' }],
  ] as const)('transient input is %s, and is listed only while it presses', (by, kind) => {
    const source = { ...CONTROLLER, ...kind };
    const { fire, frame, sources } = start();
    expect(frame()).toEqual([]);
    sources.push(source);
    fire('selectstart', source);
    expect(frame()).toMatchObject([{ by, phase: 'start', pinch: 1 }]);
    fire('select', source);
    fire('selectend', source);
    sources.length = 0;
    expect([frame(), frame()]).toMatchObject([[{ phase: 'end', tapped: true }], []]);
  });

  test('a pinch is as closed as the trigger, or as the tips of thumb and finger are near', () => {
    const trigger = start({ ...CONTROLLER, gamepad: { buttons: [{ value: 0.25 }] } });
    expect(trigger.frame()).toMatchObject([{ pinch: 0.25 }]);
    const hand = start({ ...CONTROLLER, hand: {} });
    const strengthOf = (pose: 'relaxed' | 'pinch') => {
      captureHand(pose, 0, hand.input.rightHand);
      return hand.frame()[0]?.pinch;
    };
    expect([strengthOf('pinch'), strengthOf('relaxed')]).toEqual([1, 0]);
  });

  test.each([
    ['no pose', null],
    ['a pose of NaN', Number.NaN],
  ])('a press with %s is not shown until it has one, and never if it ends before', (_what, x) => {
    const source = { ...CONTROLLER };
    const { fire, frame, places } = start(source);
    places.set(RAY, x);
    fire('selectstart', source);
    expect([frame(), frame()]).toEqual([[], []]);
    places.set(RAY, 3);
    expect([frame(), frame()]).toMatchObject([[{ phase: 'start', at: 3 }], [{ phase: 'hold', at: 3 }]]);
    fire('selectend', source);
    frame();
    places.set(RAY, x);
    expect(frame()).toEqual([]);
    for (const type of ['selectstart', 'select', 'selectend']) fire(type, source);
    expect(frame()).toEqual([]);
    places.set(RAY, 4);
    expect(frame()).toMatchObject([{ phase: 'hover', at: 4, tapped: false }]);
    fire('selectstart', source);
    expect(frame()).toMatchObject([{ phase: 'start' }]);
  });

  test('two presses between two frames are two pointers', () => {
    const source = { ...CONTROLLER };
    const { fire, frame } = start(source);
    for (let i = 0; i < 2; i++) for (const type of ['selectstart', 'select', 'selectend']) fire(type, source);
    expect(frame().map(({ id, phase }) => [id, phase])).toEqual([
      [1, 'start'],
      [2, 'start'],
    ]);
    expect(frame().map(({ tapped }) => tapped)).toEqual([true, true]);
    expect(frame()).toMatchObject([{ phase: 'hover' }]);
  });
});
