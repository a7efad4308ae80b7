import { describe, expect, test } from '@jest/globals';
import type { Control } from '../../program/program.ts';
import { type MutableInput, nextTap } from '../../runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../runtime/sessions/session-frame.ts';
import { createControlValues } from '../control-values.ts';
import { layOutPanel, PX_PER_M, SIZES } from './panel-layout.ts';
import { createPointing } from './pointing.ts';
import { castRay, createRayHit } from './ray-hit.ts';

const base = { node: 'a', param: 'value', value: 0 };
const CONTROLS: readonly Control[] = [
  { ...base, label: 'Size', kind: 'slider', min: 0, max: 1, step: 0.1 },
  { ...base, label: 'Light', kind: 'toggle' },
  { ...base, label: 'Again', kind: 'button' },
  { ...base, label: 'Mood', kind: 'choice', options: ['Warm', 'Cold'] },
];
const layout = layOutPanel('Lamp', CONTROLS, (text, sizePx) => (text.length * sizePx) / 2);
/** Upright at (2, 1, -1), turned a quarter: its front looks towards +x, its right is -z. */
const PANEL = new Float32Array([0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 1, -1, 1]);

/** A ray from 1 m before the panel, straight at a pixel of its picture. */
function rayAt(x: number, y: number): Float32Array {
  const right = (x - layout.widthPx / 2) / PX_PER_M;
  const up = (layout.heightPx / 2 - y) / PX_PER_M;
  return new Float32Array([0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 3, 1 + up, -1 - right, 1]);
}

const AWAY = rayAt(-900, 100);

function middle(index: number): readonly [number, number] {
  const part = layout.parts[index];
  if (!part) throw new Error('no such part');
  return [part.x + part.width / 2, part.y + part.height / 2];
}

function setUp() {
  const values = createControlValues(CONTROLS, () => {});
  const pointing = createPointing(layout, values);
  const frame = createSessionFrame();
  const input = frame.input as MutableInput;
  /** One frame; gives the taps that are left for the program. */
  const step = (ray: Float32Array | null, trigger: number, ...taps: readonly Float32Array[]): number => {
    input.right.connected = ray !== null;
    input.right.worldFromRay = ray;
    input.right.trigger = trigger;
    input.tapCount = 0;
    for (const tapped of taps) {
      const tap = nextTap(input);
      tap?.worldFromRay.set(tapped);
      if (tap) tap.by = 'right';
    }
    return pointing.take(frame, PANEL).input.tapCount;
  };
  const set = () => CONTROLS.map((_, i) => values.get(i));
  return { pointing, step, set, frame };
}

describe('a ray', () => {
  test('meets the panel where it points, and not from behind or leading away', () => {
    const hit = createRayHit();
    castRay(hit, rayAt(123, 45), PANEL, layout);
    expect(hit.hits).toBe(true);
    expect([hit.x, hit.y, hit.distanceM].map((value) => Math.round(value * 100) / 100)).toEqual([123, 45, 1]);
    const behind = rayAt(123, 45);
    behind[12] = 1;
    castRay(hit, behind, PANEL, layout);
    expect(hit.hits).toBe(false);
    const away = rayAt(123, 45);
    away[8] = -1;
    castRay(hit, away, PANEL, layout);
    expect(hit.hits).toBe(false);
  });
});

describe('pointing at the panel', () => {
  test('shows what is pointed at and what is held', () => {
    const { pointing, step } = setUp();
    const right = pointing.pointers[1];
    step(rayAt(...middle(1)), 0);
    expect([right?.pointing, right?.part, right?.held]).toEqual([true, 1, -1]);
    step(rayAt(...middle(1)), 1);
    expect([right?.part, right?.held, pointing.isHeld]).toEqual([1, 1, true]);
    step(AWAY, 0);
    expect([right?.pointing, right?.part, right?.held, pointing.isHeld]).toEqual([false, -1, -1, false]);
    step(null, 0);
    expect(right?.pointing).toBe(false);
  });

  test.each([
    [1, [0, 1, 0, 0]],
    [2, [0, 0, 1, 0]],
    [4, [0, 0, 0, 1]],
  ])('a press on part %d sets it once, with the tap, which no one else hears', (part, after) => {
    const { step, set } = setUp();
    const ray = rayAt(...middle(part));
    expect(step(ray, 1)).toBe(0);
    expect(set()).toEqual([0, 0, 0, 0]);
    expect(step(ray, 0, ray)).toBe(0);
    expect(set()).toEqual(after);
    step(ray, 0);
    expect(set()).toEqual(after);
  });

  test('a tap without a trigger, and one too quick to be seen, press as well', () => {
    const { step, set } = setUp();
    const ray = rayAt(...middle(2));
    expect(step(null, 0, ray, ray)).toBe(0);
    expect(step(ray, 0, ray)).toBe(0);
    expect(set()).toEqual([0, 0, 3, 0]);
    const [x, y] = middle(0);
    step(null, 0, rayAt(x, y));
    expect(set()).toEqual([0.5, 0, 3, 0]);
  });

  test('a slider follows the ray while it is held, beyond its ends too, and what ends it does nothing else', () => {
    const { step, set } = setUp();
    const [x, y] = middle(0);
    const width = (layout.parts[0]?.width ?? 0) - 2 * SIZES.trackInset;
    step(rayAt(x, y), 1);
    expect(set()[0]).toBe(0.5);
    step(rayAt(x + width / 4, y), 1);
    expect(set()[0]).toBe(0.8);
    step(rayAt(x + 3000, y - 900), 1);
    expect(set()[0]).toBe(1);
    step(rayAt(x - width * 0.3, y), 0.45);
    expect(set()[0]).toBe(0.2);
    const onToggle = rayAt(...middle(1));
    expect(step(onToggle, 0, onToggle)).toBe(0);
    expect(set()).toEqual([0.2, 0, 0, 0]);
  });

  test('what begins on the panel and ends beside it presses nothing, and no one hears its tap', () => {
    const { step, set } = setUp();
    step(rayAt(...middle(1)), 1);
    expect(step(AWAY, 0, AWAY)).toBe(0);
    expect(set()).toEqual([0, 0, 0, 0]);
    // The next is the program's.
    step(AWAY, 1);
    expect(step(AWAY, 0, AWAY)).toBe(1);
  });

  test('what begins elsewhere does not press or drag', () => {
    const { step, set } = setUp();
    step(AWAY, 1);
    const ray = rayAt(...middle(1));
    step(rayAt(...middle(0)), 1);
    expect(step(ray, 0, ray)).toBe(0);
    expect(set()).toEqual([0, 0, 0, 0]);
  });

  test('taps beside the panel stay as they were, in their order', () => {
    const { pointing, step, frame } = setUp();
    const other = rayAt(-700, 50);
    expect(step(null, 0, AWAY, rayAt(...middle(1)), other)).toBe(2);
    expect(frame.input.tapCount).toBe(3);
    const passed = pointing.take(frame, PANEL);
    expect([...passed.input.taps.slice(0, 2)].map((tap) => [...tap.worldFromRay])).toEqual([[...AWAY], [...other]]);
    expect(passed.views).toBe(frame.views);
  });
});
